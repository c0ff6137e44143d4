#include "app/ui/texture_space/plane_legend.h"

#include "app/ui/language/translate.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/param_tips.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_places.h"
#include "texplorer/image/cube_faces.h"

#include <fmt/core.h>

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

float lineWidth(const Line& line) {
    return strokeRoom(line) + ImGui::CalcTextSize(line.shown.c_str()).x;
}

float lineGap() {
    return ImGui::GetFontSize();
}

/// The width of all entries in one row.
float rowWidth(const PlaneLegend& legend) {
    float width = -lineGap();
    for (const Line& line : legend.lines)
        width += lineWidth(line) + lineGap();
    return width;
}

/// The texture's size in OpenGL, which may differ from the image's: "64 × 64", "64 × 1", "32 × 32 × 32", "6
/// faces of 128 × 128". Empty: not known yet.
std::string extentsOf(const Session& session, Target target) {
    const std::optional<glm::ivec3> texels = firstExtentOfBound(session);
    if (!texels)
        return {};
    const std::string extents = fmt::format("{} × {}", texels->x, texels->y);
    switch (target) {
    case Target::CubeMap:
        return fmt::format("{} faces of {}", cubeFaceCount, extents);
    case Target::Texture3D:
        return fmt::format("{} × {}", extents, texels->z);
    case Target::Texture1D:
    case Target::Texture2D:
        break;
    }
    return extents;
}

/// The shown part of the texels, unless it is the whole base level.
std::string lookText(const PlaneLook& look) {
    const std::string channel = tr(channelRows[static_cast<std::size_t>(look.channel)].label);
    if (look.exposure != 0 || look.low != 0 || look.high != 1)
        return fmt::format("level {} · {} · × 2^{:.1f}, {:.2f} to {:.2f}", look.level, channel, look.exposure,
                           look.low, look.high);
    return fmt::format("level {} · {}", look.level, channel);
}

struct MoveHintRow {
    MoveKind kind;
    const char* text; ///< with the number of vertices
};

constexpr std::array moveHints{
    MoveHintRow{MoveKind::Move, "Moving {} · S, T: one axis · Enter confirms, Escape cancels"},
    MoveHintRow{MoveKind::Rotate, "Rotating {} · Enter confirms, Escape cancels"},
    MoveHintRow{MoveKind::Scale, "Scaling {} · S, T: one axis · Enter confirms, Escape cancels"},
};

void nameWhatIsShown(const Session& session, const TextureSpaceState& state, std::vector<Line>& lines,
                     const std::string& extents) {
    lines.push_back({extents.empty() ? fmt::format("unit {}", session.look.selection.unit)
                                     : fmt::format("unit {} · {}", session.look.selection.unit, extents)});
    if (!state.look.isPlain() || state.look.level != 0)
        lines.push_back({lookText(state.look)});
    if (state.coords.differ()) {
        lines.push_back({"as given", Line::Stroke::Faint});
        lines.push_back({"as looked up", Line::Stroke::Strong});
    }
}

} // namespace

PlaneLegend legendOf(const Session& session, const TextureSpaceState& state, float room) {
    const Unit& unit = selectedUnit(session);
    const Texture* texture = boundTexture(session);
    const auto image = texture ? session.document.images.find(*texture) : nullptr;
    PlaneLegend legend;
    legend.extents = image ? extentsOf(session, unit.target) : std::string("no texture");
    if (state.legend)
        nameWhatIsShown(session, state, legend.lines, legend.extents);
    if (state.level.isComputing())
        legend.lines.push_back({"Computing…"});
    for (Line& line : legend.lines)
        line.shown = fitted(line.text, room - strokeRoom(line) - 2 * legendPad());
    legend.inOneRow = rowWidth(legend) + 2 * legendPad() <= room;
    return legend;
}

Box boxOf(const PlaneLegend& legend, ImVec2 corner) {
    if (legend.lines.empty())
        return {corner, corner};
    float width = legend.inOneRow ? rowWidth(legend) : 0;
    for (const Line& line : legend.lines)
        width = std::max(width, lineWidth(line));
    const std::size_t rows = legend.inOneRow ? 1 : legend.lines.size();
    const float height = static_cast<float>(rows) * ImGui::GetTextLineHeight();
    return {corner, {corner.x + width + 2 * legendPad(), corner.y + height + legendPad()}};
}

void drawPlaneLegend(ImDrawList& draw, const PlaneLegend& legend, const Box& box) {
    noteDrawn("texture size:" + legend.extents, box.low, box.high);
    if (legend.lines.empty())
        return;
    const float em = ImGui::GetFontSize();
    draw.AddRectFilled(box.low, box.high, color::shade, em * 0.25F);
    ImVec2 at(box.low.x + legendPad(), box.low.y + legendPad() / 2);
    for (const Line& line : legend.lines) {
        const float middle = at.y + ImGui::GetTextLineHeight() / 2;
        if (line.stroke != Line::Stroke::None) {
            const bool strong = line.stroke == Line::Stroke::Strong;
            draw.AddLine({at.x, middle}, {at.x + em * 1.4F, middle}, strong ? color::text : color::outline,
                         strong ? 2.0F : 1.0F);
            if (strong)
                draw.AddCircleFilled({at.x + em * 0.7F, middle}, em * 0.2F, color::text, 12);
            else
                draw.AddCircle({at.x + em * 0.7F, middle}, em * 0.2F, color::outline, 12);
        }
        draw.AddText({at.x + strokeRoom(line), at.y}, color::text, line.shown.c_str());
        noteDrawn("legend:" + line.text, at, {at.x + lineWidth(line), at.y + ImGui::GetTextLineHeight()});
        if (legend.inOneRow)
            at.x += lineWidth(line) + lineGap();
        else
            at.y += ImGui::GetTextLineHeight();
    }
}

void drawMoveHint(ImDrawList& draw, const Canvas& canvas, const VertexMove& move) {
    const float em = ImGui::GetFontSize();
    if (!move.refusal.empty()) {
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(em * 20);
        text(fmt::format("It can't be moved here: {}.", move.refusal));
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
        noteDrawn("refusal:" + move.refusal, canvas.low, canvas.high);
    }
    if (!move.byKey)
        return;
    const std::string words =
        fmt::format(fmt::runtime(moveHints[static_cast<std::size_t>(move.kind)].text), move.vertices.size());
    const std::string shown = fitted(words, canvas.high.x - canvas.low.x - em * 1.5F);
    const ImVec2 at(canvas.low.x + em * 0.7F, canvas.high.y - em * 1.7F);
    const ImVec2 size = ImGui::CalcTextSize(shown.c_str());
    draw.AddRectFilled({at.x - em * 0.3F, at.y - em * 0.1F},
                       {at.x + size.x + em * 0.3F, at.y + size.y + em * 0.1F}, color::shade, em * 0.25F);
    draw.AddText(at, color::chosen, shown.c_str());
    noteDrawn("move hint:" + words, at, {at.x + size.x, at.y + size.y});
}

} // namespace texplorer::ui
