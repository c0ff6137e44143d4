#pragma once

#include <imgui.h>

#include <string>

namespace texplorer::ui {

/// A line of text, which has been translated: in smaller letters where it has no room, and cut where those
/// have none either.
void shrunkText(ImVec2 at, const std::string& words, float size, float room, ImU32 ink);

} // namespace texplorer::ui
