#pragma once

#include "app/ui/model/session.h"

#include <vector>

namespace texplorer::ui {

// Opening files. Each of these changes nothing if it fails.

/// Opens a new scene with the initial view, regardless of how the old one was shown.
void newScene(Session& session);

/// Opens one of the program's example scenes, as a scene without a file.
[[nodiscard]] Result<void> openExample(Session& session, std::string_view file);

// Images arrive later: `receiveFiles` finishes the request or reports the error to the user. Only immediate
// errors are returned.

/// Reads a scene and every image that it names. A scene from a picture by texshot has no file, so that the
/// picture is not overwritten.
[[nodiscard]] Result<void> openScene(Session& session, const std::filesystem::path& path);

/// The answer to Dialog::Picture: uses the picture as an image.
void usePicture(Session& session);

/// Puts an image on the texture bound to the selected unit, and enables the unit.
void importImage(Session& session, const std::filesystem::path& path);

/// Puts the images that a load has added into a scene, if they are in `images`: the first for the load's
/// unit, one texture for each of the others. Images without room are refused.
void addImages(Scene& scene, const ImageSource& images, Load& load);

/// Shows unsaved work of a window that crashed, once its images are loaded or cannot be read.
void restoreUnsaved(Session& session, UnsavedScene draft);

/// Shows a file on a unit, with its bound texture or with a new one; enables the unit.
void bindFile(Scene& scene, int pass, int unit, std::string file);

/// Sets the parameter that names an image, "textures[0].levels[1].file", and the image becomes the source of
/// its object. `file` is in the notation of Texture::file.
void setFile(Session& session, std::string param, std::string file);

/// The same for a path that the user has chosen.
void chooseFile(Session& session, std::string param, const std::filesystem::path& path);

/// Replaces the scene by a loaded one; asks first if the user has changed something meanwhile.
void showLoadedScene(Session& session, Load load);

/// Opens a scene or an image, depending on its content.
[[nodiscard]] Result<void> openFile(Session& session, const std::filesystem::path& path);

/// The current scene as a text to send: an address if the window is shown by a page.
[[nodiscard]] Result<std::string> sceneLink(const Session& session);

/// Shows the scene of such a text; asks first if there are unsaved changes. Missing images are left out and
/// reported.
[[nodiscard]] Result<void> openSceneLink(Session& session, std::string_view link);

/// Opens several files: at most one scene, and images; the first image is shown, the others become textures.
/// Files that cannot be opened are listed in Session::refused, and the rest is opened. The error is that of a
/// single file.
[[nodiscard]] Result<void> openFiles(Session& session, const std::vector<std::filesystem::path>& files);

/// Checks the files of the command line by their first bytes, before there is a window. Returns an error for
/// each that is missing or cannot be opened.
[[nodiscard]] std::vector<Error> checkArguments(const std::vector<std::filesystem::path>& files);

/// Opens the files of the command line, like openFiles. The session begins with them: there is nothing to
/// undo or to save. Returns the error of the first file if none can be opened. For a single image that holds
/// a scene, it asks what to open: Dialog::Picture.
[[nodiscard]] Result<void> openArguments(Session& session, const std::vector<std::filesystem::path>& files);

/// Whether a file should be read as a scene, by its first bytes and its name; else it is an image.
[[nodiscard]] Result<bool> holdsScene(const std::filesystem::path& path);

} // namespace texplorer::ui
