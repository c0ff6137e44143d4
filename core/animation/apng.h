#pragma once

#include "texplorer/animation/encoder.h"

#include <memory>

namespace texplorer::animation {

/// An encoder for animated PNG (ISO/IEC 15948:2025, section 4.9). Viewers without animation show the first
/// picture. Of each later picture, only the rectangle that changed is written, without loss. Compressed as by
/// encodePng.
[[nodiscard]] std::unique_ptr<Encoder> apngEncoder(const Settings& settings);

} // namespace texplorer::animation
