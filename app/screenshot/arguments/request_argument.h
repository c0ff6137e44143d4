#pragma once

#include "app/screenshot/arguments/picture_argument.h"
#include "app/screenshot/arguments/renderer_argument.h"

namespace texplorer::screenshot {

/// What pictures of a single size, begin and renderer have in common: all but the scene. The error is about
/// the line.
[[nodiscard]] Result<ShotRequest> requestOf(const PictureArgument& picture, const RendererArgument& renderer);

} // namespace texplorer::screenshot
