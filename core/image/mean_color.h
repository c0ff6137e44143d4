#pragma once

#include "texplorer/image/image.h"

#include <glm/vec4.hpp>

namespace texplorer {

/// The mean colour of an Rgba8 image, 0 to 1; 0 for an empty one.
[[nodiscard]] glm::vec4 meanColor(const Image& image);

} // namespace texplorer
