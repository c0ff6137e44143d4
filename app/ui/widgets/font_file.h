#pragma once

#include <filesystem>

namespace texplorer::ui {

/// Whether a file can be read and is a TrueType or OpenType font, or a collection of them, of which no table
/// lies beyond its end. Dear ImGui ends the program over any other file. Pure but for the file.
[[nodiscard]] bool isFontFile(const std::filesystem::path& file);

} // namespace texplorer::ui
