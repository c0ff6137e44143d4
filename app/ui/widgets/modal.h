#pragma once

namespace texplorer::ui {

/// Begins a dialog in the middle of the window, as large as its content. If it returns true, call
/// ImGui::EndPopup().
[[nodiscard]] bool beginModal(const char* title);

} // namespace texplorer::ui
