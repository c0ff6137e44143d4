#pragma once

#include <filesystem>
#include <string>

namespace texplorer::ui {

/// Removes "." and ".."; links stay.
[[nodiscard]] std::filesystem::path absolutePath(const std::filesystem::path& path);

/// The name of a file for a scene in `directory`: relative if it is in or below it, else absolute.
[[nodiscard]] std::string nameFrom(const std::filesystem::path& directory, const std::filesystem::path& file);

} // namespace texplorer::ui
