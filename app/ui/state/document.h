#pragma once

#include "app/ui/state/history.h"
#include "app/ui/state/load.h"
#include "app/ui/state/selection.h"
#include "texplorer/diagnosis/diagnosis.h"
#include "texplorer/scene/scene.h"
#include "texplorer/texture/image_source.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::ui {

struct ChangedFile;

/// The inputs of the findings.
struct Diagnosis {
    Scene scene;
    std::vector<TexturePictures> pictures;
    DriverFacts driver;
};

/// The camera distance that fits the whole scene into a picture of this shape.
struct Fit {
    View view{};
    float aspect = 0; ///< width / height; 0: not fitted
};

/// A level that a click selected as the only one that is read, and the range that it replaced.
struct ForcedLevel {
    int texture = 0;
    int level = 0;
    int baseLevel = 0;
    int maxLevel = 0;
};

/// A: the state of a document that the user kept, for comparisons with the current state. Undo does not
/// change it.
struct Kept {
    std::shared_ptr<const Scene> scene; ///< nullptr: no state is kept
    /// The same scene with the current camera, for the view. nullptr: the view does not draw it.
    std::shared_ptr<const Scene> seen;
    /// The current scene while the view shows A: any edit except of the camera switches back to the current
    /// scene.
    std::optional<Scene> flippedAt;
    Selection selection{}; ///< at the time when it was kept
};

/// The scene that is shown and edited. Opening a scene creates another Document; the window stays.
struct Document {
    /// A scene with loaded images. The default camera is fitted to the view when its shape is known, so that
    /// a narrow window cuts nothing off.
    Document(Scene start, ImageSource source, std::filesystem::path savedAs = {});

    Scene scene; ///< `history.current()`, except during an edit
    History history;
    Scene saved; ///< the scene in the file
    Kept kept;
    ImageSource images;
    std::filesystem::path file;      ///< empty: never saved
    std::filesystem::path suggested; ///< the suggested name if it was never saved; may be empty
    /// The hash of the file's content when it was last read or written, to detect changes by other programs.
    /// Empty: unknown.
    std::string fileHash{};
    std::shared_ptr<const ChangedFile> changedFile{}; ///< for Dialog::FileHasChanged: see scene_saving.h
    bool isLessons = false;                           ///< the scene of a lesson: its edits need not be saved
    bool needsFit = false;                            ///< the camera must still be fitted to the view's shape
    Fit fit;                                          ///< the last one
    std::string lastChanged;                          ///< the path of the last edited parameter
    std::optional<ForcedLevel> forced;                ///< updated by the tab Levels
    std::set<std::string> used;                       ///< the files of the scene at the last check
    std::vector<Load> loads;                          ///< pending loads, in the order of the requests
    std::set<std::string> damaged; ///< files of `images` that changed and can no longer be read

    std::vector<Finding> findings; ///< about the scene, updated by `diagnoseSession`
    Diagnosis diagnosis;

    std::optional<Scene> present; ///< see presentScene; nullopt: the same as `scene`
};

/// Whether closing would lose changes. Moving the camera in a scene that was never saved does not count.
[[nodiscard]] bool isDirty(const Document& document);

/// "earth" of earth.json and of earth.texplorer.json; empty: no file.
[[nodiscard]] std::string nameOf(const Document& document);
/// The name of another file about it: "earth-sheet.png", "scene-sheet.png" without a file.
[[nodiscard]] std::string fileNameOf(const Document& document, std::string_view end);

/// "earth.json • Texplorer": the bullet marks unsaved changes.
[[nodiscard]] std::string windowTitle(const Document& document);

} // namespace texplorer::ui
