#pragma once

#include "app/ui/state/selection.h"
#include "texplorer/scene/edit/edit.h"

namespace texplorer::ui {

/// Keeps the selected model and pass selected after an edit of their list. An inserted element is selected;
/// after a removed one, the next. Vertices are selected no longer when the list of models has changed.
/// Returns whether it was one of these lists, so that models or passes have other indices.
bool follow(Selection& selection, const Edit& edit);

} // namespace texplorer::ui
