#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "core/texture/image_loader.h"
#include "core/texture/image_source.h"

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace texplorer::ui {

/// Something that the user asked for and that waits for files. Loads are finished in the order in which they
/// were asked for; each changes the scene at once, in one step of undo, or not at all.
struct Load {
    enum class Kind {
        Import,  ///< an image for the texture that is bound to a unit
        Add,     ///< several images: one for a unit, and textures of their own for the others
        SetFile, ///< another file for a parameter that names one
        Scene,   ///< a whole scene with its images, and perhaps more images, as Add
        Reload,  ///< a file that has changed
        Used,    ///< a file that the scene uses again, by an undo or another edit
    };
    Kind kind = Kind::Import;
    std::filesystem::path path{}; ///< what is opened
    std::string file{};           ///< the same as the scene spells it, for images
    /// The files that are still missing, each with all spellings that it has.
    std::map<ImageLoader::Ticket, std::vector<std::string>> waits{};
    std::map<std::string, std::shared_ptr<const TextureImage>> arrived{}; ///< those that are there
    std::vector<std::string> added{}; ///< Add, Scene: the images, as the scene spells them
    std::vector<Error> refused{};     ///< files that the load does without
    bool goesOn = false;              ///< whether it does without files that can't be read
    bool restores = false;            ///< Scene: unsaved work, of a window that has died
    int pass = 0;                     ///< Import, Add
    int unit = 0;                     ///< Import, Add
    std::string param{};              ///< SetFile: "textures[0].file"
    Scene scene{};                    ///< Scene: what is to be shown
    Scene before{};                   ///< Scene: what was shown when it was asked for
    ImageSource images = ImageSource(std::filesystem::path{}); ///< Scene
    std::string fileHash{};                                    ///< Scene: Document::fileHash
    bool reloads = false;              ///< Scene: the document's own file, which another program has written
    std::filesystem::path suggested{}; ///< Scene: of one that has no file, Document::suggested
};

} // namespace texplorer::ui
