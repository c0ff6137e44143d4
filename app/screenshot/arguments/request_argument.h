#pragma once

#include "app/screenshot/arguments/picture_argument.h"
#include "app/screenshot/arguments/renderer_argument.h"
#include "app/screenshot/arguments/scene_argument.h"

#include <span>
#include <string>

namespace texplorer::screenshot {

/// How the reference filters. The error is about the line.
[[nodiscard]] Result<void> putMethods(const PictureArgument& picture, ShotRequest& request);

/// What pictures of a single size, begin and renderer have in common: all but the scene. The error is about
/// the line.
[[nodiscard]] Result<ShotRequest> requestOf(const PictureArgument& picture, const RendererArgument& renderer);

/// No picture may take the place of a file that it is drawn from: the scene's and the shaders.
[[nodiscard]] Result<void> checkPicturesApart(std::span<const std::string> names, const SceneArgument& scene,
                                              const OpenedScene& opened, const RendererArgument& renderer);

} // namespace texplorer::screenshot
