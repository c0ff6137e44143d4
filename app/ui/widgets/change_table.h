#pragma once

#include "core/scene/params/scene_diff.h"

#include <imgui.h>

namespace texplorer::ui {

/// The columns of a table of changes. English.
struct ChangeColumns {
    const char* from;
    const char* to;
    float action = 0; ///< the width of a fourth one, for a button in each row; 0: there is none
};

/// Between this, where it is true, and ImGui::EndTable each row is `changedParam` and `changedValues`. A size
/// of 0 is all that there is.
[[nodiscard]] bool beginChangeTable(const ChangeColumns& columns, ImVec2 size = {0, 0});

/// A new row with the parameter, which is the last item after this.
void changedParam(const SceneChange& change);
/// What it was, and what it is; what of that has no room is a tooltip.
void changedValues(const SceneChange& change);

} // namespace texplorer::ui
