#pragma once

#include "app/ui/model/session.h"
#include "texplorer/files/file_fingerprint.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::ui {

// Requests of menus, keys, buttons and the host. A request that needs an answer first opens a dialog: see
// Asking::dialog.

void askOpenScene(Session& session);
/// `param` is the parameter that will name the image, "textures[0].levels[1].file"; empty: the bound texture.
void askOpenImage(Session& session, std::string param = {});
void askNewScene(Session& session);
void askExample(Session& session, std::string_view file); ///< see examples.h
void askLesson(Session& session, std::string nameOrFolder, std::optional<std::size_t> step = {});
void askSaveAnswers(Session& session); ///< the results of all lessons, as a file
void save(Session& session);           ///< asks for a name if the document has no file
/// Saves, asks first if another program has written the file meanwhile, and then continues with the pending
/// action. Errors: those of saveScene.
[[nodiscard]] Result<void> saveTo(Session& session, const std::filesystem::path& file,
                                  const std::optional<FileFingerprint>& replaces = {});
void askSaveAs(Session& session);

/// The user wants to close the window: asks first if something would be lost.
void requestQuit(Session& session);

/// Opens files that were dropped onto the window: a scene, images, the folder of a lesson. Asks first if a
/// scene would replace unsaved changes, and, for a single image that holds a scene, what the user wants.
void requestOpen(Session& session, std::vector<std::filesystem::path> files);

/// The answer to Dialog::Picture: opens the image's scene, after asking about unsaved changes.
void askPictureScene(Session& session);

/// Called when the changes are saved or discarded: runs the pending action.
void finishPending(Session& session);

} // namespace texplorer::ui
