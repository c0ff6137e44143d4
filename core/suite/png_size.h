#pragma once

#include "texplorer/suite/suite.h"

#include <filesystem>
#include <optional>

namespace texplorer::suite {

/// The size in a PNG's header; empty if the file does not begin like a PNG, or its size cannot be drawn.
[[nodiscard]] std::optional<PictureSize> sizeOfPng(const std::filesystem::path& file);

} // namespace texplorer::suite
