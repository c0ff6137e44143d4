#pragma once

#include "core/image/image.h"

#include <string>
#include <vector>

namespace texplorer {

/// What a renderer made of a scene.
struct Frame {
    Image image;                       ///< Rgba8, bottom row first
    std::vector<std::string> problems; ///< sentences: what could not be drawn, or was done otherwise
};

} // namespace texplorer
