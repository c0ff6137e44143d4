#include "app/ui/texture_space/plane_legend.h"

#include "app/ui/language/translate.h"
#include "app/ui/texture_space/outline_drawing.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/points.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_places.h"
#include "app/ui/widgets/wrapped_text.h"
#include "texplorer/image/cube_faces.h"

#include <algorithm>

namespace texplorer::ui {
namespace {

using Line = PlaneLegend::Line;

float strokeRoom(const Line& line) {
    return line.stroke == Line::Stroke::None ? 0 : ImGui::GetFontSize() * 1.8F;
}

float legendPad() {
    return ImGui::GetFontSize() * 0.3F;
}

/// The texture's size in OpenGL, which may differ from the image's: "64 × 64", "64 × 1", "32 × 32 × 32", "6
/// faces of 128 × 128". Empty: not known yet.
Sentence extentsOf(const Session& session) {
    const std::optional<glm::ivec3> texels = extentOfBound(session);
    if (!texels)
        return {};
    const Sentence extents("{0} × {1}", texels->x, texels->y);
    const Target target = selectedUnit(session).target;
    if (target == Target::CubeMap)
        return {N_("{0} faces of {1}"), cubeFaceCount, extents};
    return target == Target::Texture3D ? Sentence("{0} × {1}", extents, texels->z) : extents;
}

/// The shown part of the texels, unless it is the whole base level.
Sentence lookText(const PlaneLook& look) {
    const char* channel = channelRows[static_cast<std::size_t>(look.channel)].label;
    if (look.exposure != 0 || look.low != 0 || look.high != 1)
        return {N_("level {0} · {1} · × 2^{2:.1f}, {3:.2f} to {4:.2f}"),
                look.level,
                channel,
                look.exposure,
                look.low,
                look.high};
    return {N_("level {0} · {1}"), look.level, channel};
}

void nameWhatIsShown(const Session& session, const TextureSpaceState& state, PlaneLegend& legend) {
    std::vector<Line>& lines = legend.lines;
    const int unit = session.look.selection.unit;
    lines.push_back({legend.extents.empty() ? Sentence("unit {0}", unit)
                                            : Sentence("unit {0} · {1}", unit, legend.extents)});
    if (!state.look.isPlain())
        lines.push_back({lookText(state.look)});
    if (leavesOutOutlines(selectedMesh(session)))
        lines.push_back({N_("too many vertices for outlines")});
    if (state.coords.differ()) {
        lines.push_back({N_("as given"), Line::Stroke::Faint});
        lines.push_back({N_("as looked up"), Line::Stroke::Strong});
    }
}

} // namespace

PlaneLegend legendOf(const Session& session, const TextureSpaceState& state, ImVec2 corner, float room) {
    const auto image = boundImage(session);
    PlaneLegend legend;
    legend.extents = image ? extentsOf(session) : N_("no texture");
    if (state.legend)
        nameWhatIsShown(session, state, legend);
    if (state.level.isComputing())
        legend.lines.push_back({N_("Computing…")});
    legend.box = {corner, corner};
    if (legend.lines.empty())
        return legend;
    float row = -ImGui::GetFontSize();
    float widest = 0;
    for (Line& line : legend.lines) {
        line.shown = fitted(line.text, room - strokeRoom(line) - 2 * legendPad());
        line.width = strokeRoom(line) + ImGui::CalcTextSize(line.shown.c_str()).x;
        row += line.width + ImGui::GetFontSize();
        widest = std::max(widest, line.width);
    }
    legend.inOneRow = row + 2 * legendPad() <= room;
    const ImVec2 size =
        legend.inOneRow ? ImVec2(row, 1) : ImVec2(widest, static_cast<float>(legend.lines.size()));
    legend.box.high =
        corner + ImVec2(size.x, size.y * ImGui::GetTextLineHeight()) + ImVec2(2 * legendPad(), legendPad());
    return legend;
}

void drawPlaneLegend(ImDrawList& draw, const PlaneLegend& legend) {
    const Box& box = legend.box;
    noteDrawn(N_("texture size:") + legend.extents.english(), box.low, box.high);
    if (legend.lines.empty())
        return;
    const float em = ImGui::GetFontSize();
    const float height = ImGui::GetTextLineHeight();
    draw.AddRectFilled(box.low, box.high, color::shade, em * 0.25F);
    ImVec2 at = box.low + ImVec2(legendPad(), legendPad() / 2);
    for (const Line& line : legend.lines) {
        if (line.stroke != Line::Stroke::None) {
            const bool strong = line.stroke == Line::Stroke::Strong;
            const ImU32 ink = strong ? color::text : color::outline;
            const ImVec2 middle = at + ImVec2(em * 0.7F, height / 2);
            draw.AddLine({at.x, middle.y}, {at.x + em * 1.4F, middle.y}, ink, strong ? 2.0F : 1.0F);
            if (strong)
                draw.AddCircleFilled(middle, em * 0.2F, ink, 12);
            else
                draw.AddCircle(middle, em * 0.2F, ink, 12);
        }
        draw.AddText({at.x + strokeRoom(line), at.y}, color::text, line.shown.c_str());
        noteDrawn("legend:" + line.text.english(), at, at + ImVec2(line.width, height));
        at = legend.inOneRow ? ImVec2(at.x + line.width + em, at.y) : ImVec2(at.x, at.y + height);
    }
}

void drawMoveHint(ImDrawList& draw, const Canvas& canvas, const VertexMove& move) {
    const float em = ImGui::GetFontSize();
    if (!move.refusal.empty()) {
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(em * 20);
        text(Sentence("It can't be moved here: {0}.", move.refusal));
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
        noteDrawn("refusal:" + move.refusal.english(), canvas.low, canvas.high);
    }
    if (!move.byKey)
        return;
    const Sentence words(rowOf(move.kind).hint, move.vertices.size());
    const std::string shown = fitted(words, canvas.high.x - canvas.low.x - em * 1.5F);
    const ImVec2 at(canvas.low.x + em * 0.7F, canvas.high.y - em * 1.7F);
    const ImVec2 size = ImGui::CalcTextSize(shown.c_str());
    const ImVec2 pad(em * 0.3F, em * 0.1F);
    draw.AddRectFilled(at - pad, at + size + pad, color::shade, em * 0.25F);
    draw.AddText(at, color::chosen, shown.c_str());
    noteDrawn(N_("move hint:") + words.english(), at, at + size);
}

} // namespace texplorer::ui
