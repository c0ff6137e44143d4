#pragma once

#include "core/suite/suite.h"

#include <filesystem>
#include <optional>

namespace texplorer::suite {

/// As a PNG's header states it; none: the file begins as no PNG does, or has none that can be drawn.
[[nodiscard]] std::optional<PictureSize> sizeOfPng(const std::filesystem::path& file);

} // namespace texplorer::suite
