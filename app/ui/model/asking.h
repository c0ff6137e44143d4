#pragma once

#include "app/ui/model/session.h"
#include "core/base/file_fingerprint.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::ui {

// What menus, keys, buttons and the host ask for. Where it needs an answer first, a dialog is opened:
// WindowState::dialog says which.

void askOpenScene(Session& session);
/// `param` is what shall name it, "textures[0].levels[1].file"; empty: the texture that is bound.
void askOpenImage(Session& session, std::string param = {});
void askNewScene(Session& session);
void askExample(Session& session, std::string_view file); ///< see examples.h
void askLesson(Session& session, std::string nameOrFolder);
void askSaveAnswers(Session& session); ///< what was done in which lesson, as a file
void save(Session& session);           ///< asks for a name where there is none
/// Saves, asks where another program has written the file meanwhile, and goes on with what waits for it.
/// Errors: those of saveScene.
[[nodiscard]] Result<void> saveTo(Session& session, const std::filesystem::path& file,
                                  const std::optional<FileFingerprint>& replaces = {});
void askSaveAs(Session& session);

/// The user wants to close the window: asks first where something would be lost.
void requestQuit(Session& session);

/// Files were dropped onto the window: a scene, images, the folder of a lesson. Asks first where a scene
/// would replace unsaved changes, and, of an image alone that holds a scene, what is meant.
void requestOpen(Session& session, std::vector<std::filesystem::path> files);

/// What was asked with Dialog::Picture: its scene is opened, as far as unsaved changes let it.
void askPictureScene(Session& session);

/// The changes are saved or given up: what had to wait for that is done.
void finishPending(Session& session);

} // namespace texplorer::ui
