#pragma once

#include "app/view/size.h"
#include "core/image/image.h"

namespace texplorer::stage {

/// How large the pictures of the history's steps are at most.
inline constexpr view::Size stepPictureSize{96, 60};

/// A small picture of what the view shows (Rgba8), opaque, its shape kept; it is looked at here and there, so
/// that a large picture takes no longer than a small one. An empty one stays empty.
[[nodiscard]] Image stepPicture(const Image& picture);

} // namespace texplorer::stage
