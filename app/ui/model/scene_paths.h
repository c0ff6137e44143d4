#pragma once

#include <filesystem>
#include <string>

namespace texplorer::ui {

/// Without "." and ".."; links stay.
[[nodiscard]] std::filesystem::path absolutePath(const std::filesystem::path& path);

/// How a scene in `directory` names a file: relative where it lies at or below it, absolute elsewhere.
[[nodiscard]] std::string nameFrom(const std::filesystem::path& directory, const std::filesystem::path& file);

} // namespace texplorer::ui
