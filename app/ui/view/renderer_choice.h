#pragma once

#include "app/ui/model/views.h"

namespace texplorer::ui {

/// Who draws the picture, in the menu bar; nothing where `available` is too narrow.
void drawRendererChoice(Views& views, float available);

} // namespace texplorer::ui
