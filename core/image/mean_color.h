#pragma once

#include "core/image/image.h"

#include <glm/vec4.hpp>

namespace texplorer {

/// Of an Rgba8 image, 0 to 1; 0 of an empty one.
[[nodiscard]] glm::vec4 meanColor(const Image& image);

} // namespace texplorer
