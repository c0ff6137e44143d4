#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"
#include "app/view/pass_shader.h"

#include <vector>

namespace texplorer::ui {

/// What the tab shows of the selected pass's shader.
struct GlslTabState {
    view::ShaderStage stage = view::ShaderStage::Fragment;
    int wantedLine = 0;                        ///< scrolled to with the next frame, counted from 1; 0: none
    std::vector<view::ShaderMessage> shownLog; ///< its first line was scrolled to already
};

void drawGlslTab(const Session& session, GlslTabState& state, const Pictures& pictures);

} // namespace texplorer::ui
