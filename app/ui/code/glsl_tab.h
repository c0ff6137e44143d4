#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"
#include "app/view/pass_shader.h"

#include <vector>

namespace texplorer::ui {

/// The state of the tab for the selected pass's shader.
struct GlslTabState {
    view::ShaderStage stage = view::ShaderStage::Fragment;
    int wantedLine = 0;                        ///< scrolled to in the next frame, counted from 1; 0: none
    std::vector<view::ShaderMessage> shownLog; ///< the view was already scrolled to its first line
};

void drawGlslTab(const Session& session, GlslTabState& state, const Pictures& pictures);

} // namespace texplorer::ui
