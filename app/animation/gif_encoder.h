#pragma once

#include "texplorer/animation/encoder.h"

#include <memory>

namespace texplorer::animation {

/// GIF89a, by giflib: each picture with 256 colours of its own (core/animation/dither.h), of which what has
/// changed is written.
[[nodiscard]] Result<std::unique_ptr<Encoder>> gifEncoder(const Settings& settings);

} // namespace texplorer::animation
