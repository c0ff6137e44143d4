#pragma once

#include "texplorer/scene/params/scene_diff.h"

#include <imgui.h>

namespace texplorer::ui {

/// The column headings of a table of changes, in English.
struct ChangeColumns {
    const char* from;
    const char* to;
    float action = 0; ///< width of a fourth one, for a button in each row; 0: none
};

/// If it returns true, draw each row with `changedParam` and `changedValues`, and then call ImGui::EndTable.
/// A size of 0 is the available one.
[[nodiscard]] bool beginChangeTable(const ChangeColumns& columns, ImVec2 size = {0, 0});

/// Starts a row with the parameter, which is then the last item.
void changedParam(const SceneChange& change);
/// The old and the new value; a value that does not fit has a tooltip.
void changedValues(const SceneChange& change);

} // namespace texplorer::ui
