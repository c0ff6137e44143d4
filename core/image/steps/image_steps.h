#pragma once

// The steps of a preparation that have a file of their own; their rules are those of prepared(). Images are
// neither empty nor depths.

#include "texplorer/image/preparation.h"

namespace texplorer {

[[nodiscard]] Image swizzled(const Image& image, const std::array<ComponentSource, 4>& sources,
                             const Image* other = nullptr);
[[nodiscard]] Image withColorsSpread(Image image);
[[nodiscard]] Image normalsOf(const Image& heights, float strength, bool topFirst);

} // namespace texplorer
