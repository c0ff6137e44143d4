#pragma once

#include "texplorer/base/result.h"
#include "texplorer/scene/scene.h"
#include "texplorer/texture/image_loader.h"
#include "texplorer/texture/image_source.h"

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace texplorer::ui {

/// A request of the user that waits for files. Loads are finished in the order of the requests; each changes
/// the scene at once, in one undo step, or not at all.
struct Load {
    enum class Kind {
        Import,  ///< an image for the texture bound to a unit
        Add,     ///< several images: one for a unit, and separate textures for the others
        SetFile, ///< another file for a parameter that names one
        Scene,   ///< a whole scene with its images, and perhaps more images, as Add
        Reload,  ///< a file that has changed
        Used,    ///< a file that the scene uses again, after an undo or another edit
    };
    Kind kind = Kind::Import;
    std::filesystem::path path{}; ///< the opened file
    std::string file{};           ///< the same in the scene's notation, for images
    /// The missing files, each with all its notations.
    std::map<ImageLoader::Ticket, std::vector<std::string>> waits{};
    std::map<std::string, ImageLoader::Content> arrived{}; ///< the loaded ones
    std::vector<std::string> added{};                      ///< Add, Scene: the images in the scene's notation
    std::vector<Error> refused{};                          ///< files that the load skips
    bool goesOn = false;                                   ///< whether it skips files that cannot be read
    bool restores = false;                                 ///< Scene: unsaved work of a window that crashed
    int pass = 0;                                          ///< Import, Add
    int unit = 0;                                          ///< Import, Add
    std::string param{};                                   ///< SetFile: "textures[0].file"
    Scene scene{};                                         ///< Scene: the scene to show
    Scene before{};                                        ///< Scene: the scene at the time of the request
    ImageSource images = ImageSource(std::filesystem::path{}); ///< Scene
    std::string fileHash{};                                    ///< Scene: Document::fileHash
    std::string obj{};                 ///< Scene: the OBJ file of which the scene is made when it has arrived
    bool reloads = false;              ///< Scene: the document's own file, which another program has written
    std::filesystem::path suggested{}; ///< Scene: Document::suggested of a scene without a file
    std::vector<Sentence> notes{};     ///< Scene: what of its file was left out
};

} // namespace texplorer::ui
