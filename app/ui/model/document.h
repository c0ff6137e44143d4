#pragma once

#include "app/ui/model/kept.h"
#include "app/ui/model/load.h"
#include "core/diagnosis/diagnosis.h"
#include "core/scene/history.h"
#include "core/scene/scene.h"
#include "core/texture/image_source.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace texplorer::ui {

struct ChangedFile;

/// What the findings were made of.
struct Diagnosis {
    Scene scene;
    std::vector<TexturePictures> pictures;
    DriverFacts driver;
};

/// A camera whose distance shows the whole scene in a picture of this shape.
struct Fit {
    View view{};
    float aspect = 0; ///< width by height; 0: there was none
};

/// A level that a click chose as the only one that is read, and what that replaced.
struct ForcedLevel {
    int texture = 0;
    int level = 0;
    int baseLevel = 0;
    int maxLevel = 0;
};

/// While panels are drawn: see timeline_edits.h.
struct Standing {
    Scene base;  ///< what the document has
    Scene shown; ///< what it was when the panels began, or after the last edit
};

/// What is shown and edited. Another scene is another Document; the window around it stays.
struct Document {
    /// A scene whose images are loaded. A camera that nobody has chosen, that of the default scene, is fitted
    /// to the view when its shape is known, so that a narrow window cuts nothing off.
    Document(Scene start, ImageSource source, std::filesystem::path savedAs = {});

    Scene scene; ///< `history.current()` but for an edit in progress
    History history;
    Scene saved; ///< as the file has it
    Kept kept;
    ImageSource images;
    std::filesystem::path file;      ///< empty: never saved
    std::filesystem::path suggested; ///< what it would be saved as, where it was never saved; may be empty
    /// Of what the file had in it when it was read or written last, to notice what another program has
    /// written since. Empty: not known.
    std::string fileHash{};
    std::shared_ptr<const ChangedFile> changedFile{}; ///< of Dialog::FileHasChanged: see scene_saving.h
    bool isLessons = false;                           ///< a lesson's: nobody misses what was tried with it
    bool needsFit = false;             ///< the camera has not yet been fitted to the view's shape
    Fit fit;                           ///< the last one
    std::string lastChanged;           ///< the path of the parameter that was edited last
    std::optional<ForcedLevel> forced; ///< kept by the tab Levels
    std::set<std::string> used;        ///< files that the scene used when that was last looked at
    std::vector<Load> loads;           ///< what is on its way, in the order in which it was asked for
    std::set<std::string> damaged;     ///< files of `images` that changed and can't be read any more

    std::vector<Finding> findings; ///< about the scene, kept by `diagnoseSession`
    Diagnosis diagnosis;

    std::optional<Standing> standing; ///< `scene` is that of the present time; nothing: it is its own
};

/// Whether closing would lose something. Looking around in a scene that was never saved doesn't count.
[[nodiscard]] bool isDirty(const Document& document);

/// "earth" of earth.json and of earth.texplorer.json; empty: it has no file.
[[nodiscard]] std::string nameOf(const Document& document);

/// "earth.json • Texplorer": the bullet says that there are unsaved changes.
[[nodiscard]] std::string windowTitle(const Document& document);

} // namespace texplorer::ui
