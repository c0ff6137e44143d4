#pragma once

#include <imgui.h>

#include <string_view>

namespace texplorer::ui {

/// A line of text in the room that the panel or column has left; what is too long ends with "…". True where
/// it had to be cut: then a tooltip should have it all.
bool fittedText(std::string_view text, ImU32 ink);

} // namespace texplorer::ui
