#pragma once

namespace texplorer::ui {

/// A button of a dialog: as wide as its label, and not narrower than the others of its row.
bool dialogButton(const char* name);
[[nodiscard]] float dialogButtonWidth(const char* name);

} // namespace texplorer::ui
