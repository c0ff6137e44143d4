#pragma once

#include "app/view/size.h"
#include "texplorer/image/image.h"

namespace texplorer::stage {

/// The maximum size of the pictures in the history.
inline constexpr view::Size stepPictureSize{96, 60};

/// A small, opaque picture of the view (Rgba8) with the same shape. It samples some pixels only, so that a
/// large picture takes no longer than a small one. An empty picture stays empty.
[[nodiscard]] Image stepPicture(const Image& picture);

} // namespace texplorer::stage
