#pragma once

#include "texplorer/base/result.h"
#include "texplorer/emit/flavour.h"

#include <filesystem>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace texplorer::ui {

struct Session; // see session.h

enum class Dialog {
    None,
    OpenScene,
    OpenImage,
    SaveScene,
    SaveAnswers,
    SaveSheet,
    SaveProgram,
    Texture, ///< the options of a texture's file
    SaveTexture,
    Record,
    SaveRecording,
    Discard,
    FileHasChanged, ///< see Document::changedFile
    Help,
    Restore,
    Refused,
    Picture
};

/// The action that waits for the user's decision about unsaved changes: closing the window, or another one.
namespace pending {
struct Quit {};
} // namespace pending
using Pending = std::variant<std::monostate, pending::Quit, std::function<void(Session&)>>;

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
