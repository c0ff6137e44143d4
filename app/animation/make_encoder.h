#pragma once

#include "texplorer/animation/encoder.h"
#include "texplorer/animation/format.h"

#include <memory>

namespace texplorer::animation {

/// An encoder of the format for pictures of this size. Errors: TooLarge beyond the format's own limit or
/// memory's.
[[nodiscard]] Result<std::unique_ptr<Encoder>> makeEncoder(Format format, const Settings& settings);

} // namespace texplorer::animation
