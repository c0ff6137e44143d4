#pragma once

#include "app/ui/texture_space/plane_look.h"

namespace texplorer::ui {

/// Draws how often each value occurs in the shown components: one line for each, with its letter.
void drawHistogram(const LevelPicture& level, Channel channel, float width);

/// min, max and mean of each component, in 255ths.
void drawStatistics(const LevelPicture& level);

} // namespace texplorer::ui
