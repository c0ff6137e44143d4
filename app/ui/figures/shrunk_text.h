#pragma once

#include <imgui.h>

#include <string>

namespace texplorer::ui {

/// A line of translated text: drawn with smaller letters if it does not fit, and cut if those do not fit
/// either.
void shrunkText(ImVec2 at, const std::string& words, float size, float room, ImU32 ink);

} // namespace texplorer::ui
