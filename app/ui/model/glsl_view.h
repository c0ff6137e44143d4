#pragma once

#include "app/view/pass_shader.h"

#include <vector>

namespace texplorer::ui {

/// What the tab with the shaders shows.
struct GlslView {
    view::ShaderStage stage = view::ShaderStage::Fragment;
    int wantedLine = 0;                          ///< scrolled to with the next frame, counted from 1; 0: none
    std::vector<view::ShaderMessage> shownLog; ///< its first line was scrolled to already
};

} // namespace texplorer::ui
