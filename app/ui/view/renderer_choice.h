#pragma once

#include "app/ui/model/view_settings.h"

namespace texplorer::ui {

/// The choice of the renderer, in the menu bar; nothing where `available` is too narrow.
void drawRendererChoice(ViewSettings& settings, float available);

} // namespace texplorer::ui
