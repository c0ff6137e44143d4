#include "app/ui/figures/figures_tab.h"

#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/segments.h"

#include <fmt/core.h>

namespace texplorer::ui {
namespace {

void drawFigure(const Session& session, FiguresTabState& state, const Pictures& pictures) {
    switch (session.window.figure) {
    case Figure::Environments:
        return drawEnvironmentTable(session, state.environments, pictures);
    case Figure::Sheet:
        return drawSheet(session, state.sheet, pictures);
    case Figure::Block:
        return drawBlockMicroscope(session, state.block);
    case Figure::Flip:
        return drawBlockFlip(state.flip);
    case Figure::Objects:
        return drawTextureObjects(session, state.objects);
    case Figure::Emboss:
        return drawEmbossTheory(session, state.emboss);
    case Figure::Edge:
        return drawEdgeLens(session, state.edge);
    case Figure::Upload:
        return drawUploadFigure(session, state.upload);
    case Figure::Cost:
        return drawCostFigure(session, state.cost);
    }
}

void figureNames(const Session& session) {
    const auto pressed =
        drawSegments(segmentsOf(figureRows, &FigureRow::label), ImGui::GetContentRegionAvail().x,
                     static_cast<std::size_t>(session.window.figure), [](std::size_t i) {
                         helpTip(figureRows[i].help);
                         noteItem(fmt::format("figure:{}", figureRows[i].name));
                     });
    if (pressed)
        act(session,
            [figure = figureRows[*pressed].figure](Session& changed) { changed.window.figure = figure; });
}

} // namespace

void drawFiguresTab(const Session& session, FiguresTabState& state, const Pictures& pictures) {
    figureNames(session);
    ImGui::BeginChild("figure");
    ImGui::PushID(rowOf(session.window.figure).label);
    drawFigure(session, state, pictures);
    ImGui::PopID();
    ImGui::EndChild();
}

} // namespace texplorer::ui
