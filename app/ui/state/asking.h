#pragma once

#include "app/ui/state/load.h"
#include "texplorer/base/result.h"
#include "texplorer/emit/flavour.h"

#include <filesystem>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace texplorer::ui {

enum class Dialog {
    None,
    OpenScene,
    OpenImage,
    SaveScene,
    SaveAnswers,
    SaveSheet,
    SaveProgram,
    Record,
    SaveRecording,
    Discard,
    FileHasChanged, ///< see Document::changedFile
    Help,
    Restore,
    Refused,
    Picture
};

/// What waits for the answer about unsaved changes.
namespace pending {
struct NewScene {};
struct Example {
    std::string file; ///< its name
};
struct Lesson {
    std::string nameOrFolder;
};
struct ChooseScene {};
struct OpenFiles {
    std::vector<std::filesystem::path> files; ///< at least one
};
struct OpenScene {
    std::filesystem::path file;
};
struct ShowScene {
    std::shared_ptr<Load> load; ///< finished; shared for the sake of copies of the state
};
struct Quit {};
} // namespace pending

/// The action that waits for the user's decision about unsaved changes.
using Pending =
    std::variant<std::monostate, pending::NewScene, pending::Example, pending::Lesson, pending::ChooseScene,
                 pending::OpenFiles, pending::OpenScene, pending::ShowScene, pending::Quit>;

/// For Dialog::Picture: an image that contains a scene, which the user may want to open.
struct AskedPicture {
    std::filesystem::path file;
    bool begins = false; ///< named on the command line: opening it first is not an edit
};

/// The open dialog, and what it asks about.
struct Asking {
    Dialog dialog = Dialog::None;
    Pending pending{};
    AskedPicture picture;
    std::vector<Error> refused; ///< files that could not be opened, until the user has read the list
    std::string imageParam;     ///< for OpenImage: the parameter that will name it; empty: the bound texture
    emit::Flavour flavour = emit::Flavour::Fixed; ///< for Dialog::SaveProgram
    bool quitConfirmed = false;
};

} // namespace texplorer::ui
