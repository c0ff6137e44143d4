#pragma once

#include "texplorer/gl/sampling.h"

#include <optional>

namespace texplorer::ui {

/// The part of the image that a wrap mode shows along one axis between the integer coordinates `tile` and
/// `tile` + 1: image coordinates from `from` to `to`. (0, 1) is the image itself, (1, 0) a mirrored copy;
/// equal ends are a stretched edge texel.
struct TileSpan {
    float from;
    float to;
    bool operator==(const TileSpan&) const = default;
};

/// Nothing for the border colour. `texels` is the extent of the image along this axis. GL_CLAMP is shown as
/// with a nearest filter: its edge texel (OpenGL 2.1, section 3.8.7).
[[nodiscard]] std::optional<TileSpan> tileSpan(Wrap wrap, int tile, int texels);

} // namespace texplorer::ui
