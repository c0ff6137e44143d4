#pragma once

#include "core/gl/sampling.h"

#include <optional>

namespace texplorer::ui {

/// What a wrap mode shows along one axis between the whole coordinates `tile` and `tile` + 1: image
/// coordinates from `from` to `to`. (0, 1) is the image itself, (1, 0) a reversed copy; equal ends are an
/// edge texel drawn out.
struct TileSpan {
    float from;
    float to;
    bool operator==(const TileSpan&) const = default;
};

/// Nothing where there is the border colour. `texels` is the extent of the image along this axis. GL_CLAMP is
/// shown as under a nearest filter: its edge texel (OpenGL 2.1, section 3.8.7).
[[nodiscard]] std::optional<TileSpan> tileSpan(Wrap wrap, int tile, int texels);

} // namespace texplorer::ui
