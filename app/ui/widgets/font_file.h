#pragma once

#include <filesystem>

namespace texplorer::ui {

/// Whether a file can be read and is a TrueType or OpenType font, or a collection of them, with no table
/// beyond its end. Dear ImGui aborts for any other file. Depends only on the file.
[[nodiscard]] bool isFontFile(const std::filesystem::path& file);

} // namespace texplorer::ui
