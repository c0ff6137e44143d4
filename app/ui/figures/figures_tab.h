#pragma once

#include "app/ui/figures/block_flip.h"
#include "app/ui/figures/block_microscope.h"
#include "app/ui/figures/cost_figure.h"
#include "app/ui/figures/edge_lens.h"
#include "app/ui/figures/emboss_theory.h"
#include "app/ui/figures/environment_table.h"
#include "app/ui/figures/sheet.h"
#include "app/ui/figures/texture_objects.h"
#include "app/ui/figures/upload_figure.h"

namespace texplorer::ui {

/// The state of each figure.
struct FiguresTabState {
    EnvironmentTableState environments;
    SheetState sheet;
    BlockMicroscopeState block;
    BlockFlipState flip;
    TextureObjectsState objects;
    EmbossTheoryState emboss;
    EdgeLensState edge;
    UploadFigureState upload;
    CostFigureState cost;
};

/// Draws the names of all figures, and the selected one: WindowState::figure.
void drawFiguresTab(const Session& session, FiguresTabState& state, const Pictures& pictures);

} // namespace texplorer::ui
