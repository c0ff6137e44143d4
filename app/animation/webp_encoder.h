#pragma once

#include "texplorer/animation/encoder.h"

#include <memory>

namespace texplorer::animation {

/// Animated WebP, by libwebp's own encoder of animations, which looks for what has changed. Pictures that are
/// the same become one that is shown longer.
[[nodiscard]] Result<std::unique_ptr<Encoder>> webpEncoder(const Settings& settings);

} // namespace texplorer::animation
