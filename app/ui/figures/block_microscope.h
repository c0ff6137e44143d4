#pragma once

#include "app/ui/figures/block_columns.h"

namespace texplorer::ui {

void drawBlockMicroscope(const Session& session, BlockMicroscopeState& state);

} // namespace texplorer::ui
