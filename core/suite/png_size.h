#pragma once

#include "core/suite/suite.h"

#include <filesystem>

namespace texplorer::suite {

/// As a PNG's header states it; as a suite has it where there is none.
[[nodiscard]] PictureSize sizeOfPng(const std::filesystem::path& file);

} // namespace texplorer::suite
