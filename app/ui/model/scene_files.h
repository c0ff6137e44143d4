#pragma once

#include "app/ui/model/session.h"

#include <vector>

namespace texplorer::ui {

// Files. Each of these changes nothing when it fails.

/// Looked at as a window begins, whatever the old one was looked at with.
void newScene(Session& session);

/// One of the scenes that come with the program, as a scene without a file.
[[nodiscard]] Result<void> openExample(Session& session, std::string_view file);

// Images come later: what was asked for happens in `receiveFiles`, or the user is told there why it can't.
// The errors that are returned are those that are seen at once.

/// Reads a scene and every image that it names. One of a picture that texshot has drawn has no file then, so
/// that the picture isn't overwritten.
[[nodiscard]] Result<void> openScene(Session& session, const std::filesystem::path& path);

/// What was asked with Dialog::Picture: the picture is an image.
void usePicture(Session& session);

/// Puts an image on the texture that is bound to the selected unit, and switches the unit on.
void importImage(Session& session, const std::filesystem::path& path);

/// Puts the images that a load has added into a scene, as far as they are in `images`: the first for the
/// load's unit, a texture for each of the others. Those for which there is no room are refused.
void addImages(Scene& scene, const ImageSource& images, Load& load);

/// Shows unsaved work of a window that has died, once its images are there or can't be read.
void restoreUnsaved(Session& session, UnsavedScene draft);

/// A unit shows a file, with the texture that is bound to it, or with a new one; the unit is switched on.
void bindFile(Scene& scene, int pass, int unit, std::string file);

/// A parameter names an image, "textures[0].levels[1].file", which becomes the source of what it belongs to.
/// `file` is spelled as in Texture::file.
void setFile(Session& session, std::string param, std::string file);

/// The same of a file that was chosen somewhere.
void chooseFile(Session& session, std::string param, const std::filesystem::path& path);

/// A scene that has been loaded takes the place of this one; asks first where the user has changed something
/// meanwhile.
void showLoadedScene(Session& session, Load load);

/// A scene or an image, by its content.
[[nodiscard]] Result<void> openFile(Session& session, const std::filesystem::path& path);

/// A scene as a text that one can send, as it is now.
[[nodiscard]] Result<std::string> sceneLink(const Session& session);

/// Shows the scene of such a text; asks first where there are unsaved changes. Images that aren't there are
/// left out, and that is said.
[[nodiscard]] Result<void> openSceneLink(Session& session, std::string_view link);

/// Several files: at most one scene, and images; the first one is shown, the others wait as textures. What
/// can't be opened is listed in Session::refused, and the rest is opened. The error is that of a file that is
/// the only one.
[[nodiscard]] Result<void> openFiles(Session& session, const std::vector<std::filesystem::path>& files);

/// What of the command line is not there or is nothing that can be opened, by the beginning of each file:
/// what can be said before there is a window. An error for each.
[[nodiscard]] std::vector<Error> checkArguments(const std::vector<std::filesystem::path>& files);

/// What the command line names, as openFiles. The session begins with it: there is nothing to undo or to
/// save. The error is that of the first file where none can be opened. Of an image alone that holds a scene,
/// it is asked what is meant: Dialog::Picture.
[[nodiscard]] Result<void> openArguments(Session& session, const std::vector<std::filesystem::path>& files);

/// Whether a file is to be read as a scene, by its first bytes and its name; else as an image.
[[nodiscard]] Result<bool> holdsScene(const std::filesystem::path& path);

/// Tells the user. Where the content of `file` was the reason, it is offered to look into it.
void say(Session& session, const Error& error, const std::filesystem::path& file = {});
void say(Session& session, std::string sentence);
/// The same of what was done, and can't be seen.
void tell(Session& session, std::string sentence);
/// Shows a failure to the user.
void report(Session& session, const Result<void>& result, const std::filesystem::path& file = {});

} // namespace texplorer::ui
