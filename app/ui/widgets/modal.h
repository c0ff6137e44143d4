#pragma once

namespace texplorer::ui {

/// A dialog in the middle of the window, as large as its content. To be closed with ImGui::EndPopup() where
/// true.
[[nodiscard]] bool beginModal(const char* title);

} // namespace texplorer::ui
