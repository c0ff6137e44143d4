#pragma once

#include "app/render/shader_source.h"

#include <vector>

namespace texplorer::ui {

/// What the tab with the shaders shows.
struct GlslView {
    render::ShaderStage stage = render::ShaderStage::Fragment;
    int wantedLine = 0;                          ///< scrolled to with the next frame, counted from 1; 0: none
    std::vector<render::ShaderMessage> shownLog; ///< its first line was scrolled to already
};

} // namespace texplorer::ui
