#include "app/ui/figures/figures_tab.h"

#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/segments.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace texplorer::ui {
namespace {

void drawFigure(const Session& session, FiguresTabState& state, const Pictures& pictures) {
    switch (session.window.figure) {
    case Figure::Environments:
        return drawEnvironmentTable(session, state.environments, pictures);
    case Figure::Sheet:
        return drawSheet(session, state.sheet, pictures);
    case Figure::Block:
        return drawBlockMicroscope(session, state.block, pictures);
    case Figure::Flip:
        return drawBlockFlip(session, state.flip, pictures);
    case Figure::Objects:
        return drawTextureObjects(session, state.objects, pictures);
    case Figure::Emboss:
        return drawEmbossTheory(session, state.emboss, pictures);
    case Figure::Edge:
        return drawEdgeLens(session, state.edge, pictures);
    }
}

void figureNames(const Session& session) {
    std::vector<Segment> names;
    std::ranges::transform(figureRows, std::back_inserter(names),
                           [](const FigureRow& row) { return Segment{row.label}; });
    const float room = ImGui::GetContentRegionAvail().x;
    std::optional<SegmentPlan> plan;
    for (std::size_t lines = 1; !plan && lines <= names.size(); ++lines)
        plan = planSegments(names, room, lines);
    if (!plan)
        return;
    const auto pressed =
        drawSegments(names, *plan, static_cast<std::size_t>(session.window.figure), [](std::size_t i) {
            helpTip(figureRows[i].help);
            noteItem(fmt::format("figure:{}", figureRows[i].name));
        });
    if (pressed)
        change(session,
               [figure = figureRows[*pressed].figure](WindowState& window) { window.figure = figure; });
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
