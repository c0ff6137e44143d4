#pragma once

#include "app/ui/session.h"

#include <vector>

namespace texplorer::ui {

// Files. Each of these changes nothing when it fails.

void newScene(Session& session);

/// Reads a scene and every image that it names.
[[nodiscard]] Result<void> openScene(Session& session, const std::filesystem::path& path);

/// Writes the scene. Image paths are kept relative to the scene file where they lie below its folder.
[[nodiscard]] Result<void> saveScene(Session& session, const std::filesystem::path& path);

/// Puts an image on the texture that is bound to the selected unit, and switches the unit on.
[[nodiscard]] Result<void> importImage(Session& session, const std::filesystem::path& path);

/// A scene or an image, by its content.
[[nodiscard]] Result<void> openFile(Session& session, const std::filesystem::path& path);

/// What the command line names: at most one scene, and images; the first one is shown, the others wait as
/// textures. The session begins with them: there is nothing to undo or to save.
[[nodiscard]] Result<void> openArguments(Session& session, const std::vector<std::filesystem::path>& files);

/// Whether a file holds an image that can be read, by its first bytes.
[[nodiscard]] Result<bool> holdsImage(const std::filesystem::path& path);

/// Shows a failure to the user.
void report(Session& session, const Result<void>& result);

} // namespace texplorer::ui
