#pragma once

#include "texplorer/base/sentence.h"
#include "texplorer/image/image.h"

#include <string>
#include <vector>

namespace texplorer {

/// The result of drawing a scene.
struct Frame {
    Image image;                    ///< Rgba8, bottom row first
    std::vector<Sentence> problems; ///< sentences about what could not be drawn or was done differently
};

} // namespace texplorer
