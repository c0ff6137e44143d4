#pragma once

#include "core/animation/encoder.h"

#include <memory>

namespace texplorer::animation {

/// An animated PNG (ISO/IEC 15948:2025, section 4.9): the first picture is what a viewer of plain PNG shows.
/// Of the others what has changed is written, as a rectangle; nothing is lost. Packed as encodePng does.
[[nodiscard]] std::unique_ptr<Encoder> apngEncoder(const Settings& settings);

} // namespace texplorer::animation
