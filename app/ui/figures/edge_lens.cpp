#include "app/ui/figures/edge_lens.h"

#include "app/ui/figures/plot.h"
#include "app/ui/language/translate.h"
#include "app/ui/model/preview.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/param_names.h"
#include "app/ui/widgets/param_place.h"
#include "app/ui/widgets/param_tips.h"
#include "app/ui/widgets/points.h"
#include "app/ui/widgets/same_line.h"
#include "app/ui/widgets/segments.h"
#include "texplorer/reference/sampling/row_weights.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>
#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace texplorer::ui {
namespace {

using reference::RowPiece;
using reference::RowSample;

constexpr float lensFrom = -1;
constexpr float lensTo = 2;
constexpr std::array lensSizes{2, 4, 8};

/// The colours of the texels: neighbours differ, and so do both ends.
constexpr std::array lensColors{
    glm::vec3(0.84F, 0.24F, 0.20F), glm::vec3(0.98F, 0.78F, 0.22F), glm::vec3(0.25F, 0.63F, 0.35F),
    glm::vec3(0.20F, 0.50F, 0.88F), glm::vec3(0.58F, 0.36F, 0.74F), glm::vec3(0.95F, 0.60F, 0.70F),
    glm::vec3(0.35F, 0.78F, 0.80F), glm::vec3(0.60F, 0.44F, 0.30F),
};

/// The drawn row, its border, and its sampling parameters.
struct LensRow {
    int size;
    glm::vec3 border;
    bool linear;

    [[nodiscard]] bool isBorder(int texel) const { return texel < 0 || texel >= size; }
    [[nodiscard]] glm::vec3 colorOf(int texel) const {
        return isBorder(texel) ? border : lensColors.at(static_cast<std::size_t>(texel));
    }
    [[nodiscard]] glm::vec3 colorOf(const RowSample& sample) const {
        glm::vec3 sum(0);
        for (const reference::RowTexel& tap : sample.taps)
            sum += colorOf(tap.index) * tap.weight;
        return sum;
    }
    [[nodiscard]] std::vector<RowPiece> pieces(Wrap wrap) const {
        return reference::rowPieces(wrap, linear, lensFrom, lensTo, size);
    }
};

void hatchLensBorder(const LensRow& row, std::span<const ImVec2> shape) {
    hatch(shape, ImGui::GetFontSize() * 0.45F, inkOn(row.border), plotLine() * 0.75F);
}

/// A rectangle of a texel or the border, which is hatched.
void drawLensTexel(const LensRow& row, int texel, ImVec2 low, ImVec2 high) {
    ImGui::GetWindowDrawList()->AddRectFilled(low, high, plotColor(row.colorOf(texel)));
    if (row.isBorder(texel))
        hatchLensBorder(row, std::array{low, ImVec2(high.x, low.y), high, ImVec2(low.x, high.y)});
}

/// The texels with the border next to them.
void drawLensRow(ImDrawList& draw, const PlotBox& box, const LensRow& row) {
    for (const auto& [from, to] : {std::pair(lensFrom, 0.0F), std::pair(1.0F, lensTo)}) {
        const ImVec2 low = box.at(from, 1);
        const ImVec2 high = box.at(to, 0);
        drawLensTexel(row, -1, low, high);
        const std::string name = tr("border");
        const ImVec2 size = plotTextSize(name);
        const ImVec2 middle = box.at((from + to) / 2, 0.5F);
        if (size.x + 6 < high.x - low.x) {
            draw.AddRectFilled({middle.x - size.x / 2 - 3, low.y}, {middle.x + size.x / 2 + 3, high.y},
                               plotColor(row.border));
            plotText(middle, {0.5F, 0.5F}, name, inkOn(row.border));
        }
    }
    for (int i = 0; i < row.size; ++i) {
        const auto n = static_cast<float>(row.size);
        drawLensTexel(row, i, box.at(static_cast<float>(i) / n, 1), box.at(static_cast<float>(i + 1) / n, 0));
        plotText(box.at((static_cast<float>(i) + 0.5F) / n, 0.5F), {0.5F, 0.5F}, std::to_string(i),
                 inkOn(row.colorOf(i)));
    }
    draw.AddRect(box.low, box.high, color::outline);
}

/// The stacked weights: at every s they fill the height.
void drawLensWeights(ImDrawList& draw, const PlotBox& box, const LensRow& row, Wrap wrap) {
    draw.AddRectFilled(box.low, box.high, color::ground);
    const ImDrawListFlags flags = draw.Flags; // antialiased edges would be visible seams
    draw.Flags &= ~ImDrawListFlags_AntiAliasedFill;
    for (const RowPiece& piece : row.pieces(wrap)) {
        std::vector<RowPiece::Share> shares = piece.shares;
        std::ranges::sort(shares, {}, [&](const RowPiece::Share& each) {
            return row.isBorder(each.index) ? -1 : each.index; // the border is at the bottom
        });
        float from = 0;
        float to = 0;
        for (const RowPiece::Share& share : shares) {
            const std::array shape{box.at(piece.from, from + share.from), box.at(piece.to, to + share.to),
                                   box.at(piece.to, to), box.at(piece.from, from)};
            draw.AddQuadFilled(shape[0], shape[1], shape[2], shape[3], plotColor(row.colorOf(share.index)));
            if (row.isBorder(share.index))
                hatchLensBorder(row, shape);
            from += share.from;
            to += share.to;
        }
    }
    draw.Flags = flags;
    draw.AddRect(box.low, box.high, color::outline);
}

/// The resulting colours.
void drawLensResult(ImDrawList& draw, const PlotBox& box, const LensRow& row, Wrap wrap) {
    for (const RowPiece& piece : row.pieces(wrap)) {
        glm::vec3 from(0);
        glm::vec3 to(0);
        float border = 0;
        for (const RowPiece::Share& share : piece.shares) {
            from += row.colorOf(share.index) * share.from;
            to += row.colorOf(share.index) * share.to;
            border += row.isBorder(share.index) ? (share.from + share.to) / 2 : 0;
        }
        const ImU32 left = plotColor(from);
        const ImU32 right = plotColor(to);
        const ImVec2 low = box.at(piece.from, 1);
        const ImVec2 high = box.at(piece.to, 0);
        draw.AddRectFilledMultiColor(low, high, left, right, right, left);
        if (border > 0.99F)
            hatchLensBorder(row, std::array{low, ImVec2(high.x, low.y), high, ImVec2(low.x, high.y)});
    }
    draw.AddRect(box.low, box.high, color::outline);
}

/// The numbers -1, 0, 1 and 2, and the edges of texels.
void drawLensScale(ImDrawList& draw, const PlotBox& box, float top) {
    const float below = box.high.y + ImGui::GetFontSize() * 0.2F;
    for (int s = static_cast<int>(lensFrom); s <= static_cast<int>(lensTo); ++s) {
        const float x = box.atX(static_cast<float>(s));
        const bool isEdge = s == 0 || s == 1;
        draw.AddLine({x, isEdge ? top : box.high.y}, {x, below}, isEdge ? color::text : color::dim,
                     isEdge ? plotLine() * 1.5F : plotLine());
        const float anchor = s == static_cast<int>(lensFrom) ? 0.0F
                             : s == static_cast<int>(lensTo) ? 1.0F
                                                             : 0.5F;
        plotText({x, below}, {anchor, 0}, std::to_string(s), color::dim);
    }
    plotText({box.atX(0.5F), below}, {0.5F, 0}, "s", color::s);
}

constexpr std::array lensNames{N_("Texels"), N_("Weights"), N_("Colour")};

/// The large drawing: row, weights and result one above the other. Dragging on it changes the coordinate.
void drawLens(EdgeLensState& state, const LensRow& row, Wrap wrap, float width, float height) {
    const float em = ImGui::GetFontSize();
    const float names = plotNamesWidth(lensNames);
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("lens", {width, height});
    item("edge:lens", "The weights of the texels at each coordinate, stacked. Drag to read one.");
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float strip = em * 1.3F;
    const float scale = em * 1.2F;
    const float gap = em * 0.25F;
    const ImVec2 low(origin.x + names, origin.y);
    const ImVec2 high(origin.x + width, origin.y + height - scale);
    const PlotBox texels{low, {high.x, low.y + strip}, lensFrom, lensTo};
    const PlotBox weights{{low.x, low.y + strip + gap}, {high.x, high.y - strip - gap}, lensFrom, lensTo};
    const PlotBox result{{low.x, high.y - strip}, high, lensFrom, lensTo};
    if (weights.height() < em || weights.width() < em)
        return;
    if (ImGui::IsItemActive())
        state.s = std::clamp(weights.xOf(ImGui::GetIO().MousePos.x), lensFrom, lensTo);
    drawLensRow(draw, texels, row);
    drawLensWeights(draw, weights, row, wrap);
    drawLensResult(draw, result, row, wrap);
    drawLensScale(draw, result, texels.low.y);
    plotNames(origin.x, lensNames, std::array{texels, weights, result});
    const float x = weights.atX(state.s);
    draw.AddLine({x, texels.high.y}, {x, result.high.y}, color::shade, plotLine() * 3.5F);
    draw.AddLine({x, texels.high.y}, {x, result.high.y}, color::probed, plotLine() * 1.5F);
    draw.AddTriangleFilled({x, texels.high.y + gap}, {x - em * 0.3F, texels.high.y - em * 0.25F},
                           {x + em * 0.3F, texels.high.y - em * 0.25F}, color::probed);
}

/// A square with a texel's colour, in front of its text.
void lensSwatch(const LensRow& row, int texel) {
    const float side = ImGui::GetFontSize();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high = low + ImVec2(side, side);
    ImGui::Dummy({side, side});
    drawLensTexel(row, texel, low, high);
    ImGui::GetWindowDrawList()->AddRect(low, high, color::outline);
}

/// The calculation for the current coordinate.
void drawLensReading(EdgeLensState& state, const LensRow& row, Wrap wrap) {
    const float em = ImGui::GetFontSize();
    ImGui::AlignTextToFramePadding();
    plainText("s =", color::s);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(em * 6);
    dragNumber("##s", state.s, {lensFrom, lensTo, 0.01F, {}}, 0);
    item("edge:s", "The coordinate that is read. Drag it, or double-click to type a number.");
    const RowSample sample = reference::sampleRow(wrap, row.linear, state.s, row.size);
    ImGui::SameLine();
    dimText(Sentence("s · {0} = {1:.2f}, wrapped: u = {2:.2f}", row.size, sample.texels, sample.u));
    noteItem(fmt::format("edge:u {:.2f}", sample.u));
    if (row.linear)
        dimText(Sentence("u - 0.5 = {0:.2f}: texels {1} and {2}, weight of the second {3:.2f}",
                         sample.u - 0.5F, sample.taps[0].index, sample.taps[1].index, sample.alpha));
    else
        dimText(Sentence("floor(u) = {0}: one texel is read", sample.taps[0].index));
    for (std::size_t i = 0; i < sample.taps.size(); ++i) {
        const reference::RowTexel& tap = sample.taps[i];
        const std::string words =
            tr(row.isBorder(tap.index) ? Sentence("{0:.2f} of border", tap.weight)
                                       : Sentence("{0:.2f} of texel {1}", tap.weight, tap.index));
        if (i > 0) {
            const float needed = em * 1.5F + ImGui::CalcTextSize(words.c_str()).x + em;
            sameLineFor(needed, em * 0.8F);
        }
        lensSwatch(row, tap.index);
        ImGui::SameLine(0, em * 0.3F);
        ImGui::TextUnformatted(words.c_str());
        noteItem(fmt::format("edge:tap {} {:.2f}", tap.index, tap.weight));
    }
    const glm::vec3 bytes = glm::round(glm::clamp(row.colorOf(sample), 0.0F, 1.0F) * 255.0F);
    text(Sentence("Colour {0}; the border's share is {1:.0f} %",
                  ProperName{fmt::format("{:.0f} {:.0f} {:.0f}", bytes.r, bytes.g, bytes.b)},
                  sample.border * 100));
    noteItem(fmt::format("edge:border {:.2f}", sample.border));
}

/// The colours of each wrap mode; the chosen one has a frame.
void drawLensStrips(const Session& session, const ParamPlace& place, const LensRow& row, Wrap chosen,
                    float width) {
    const float em = ImGui::GetFontSize();
    float names = 0;
    for (const EnumRow& mode : wrapRows)
        names = std::max(names, ImGui::CalcTextSize(tr(shownBrief(session.settings, mode)).c_str()).x);
    names = std::min(std::ceil(names + em * 0.8F), width * 0.5F);
    const std::string path = place.owner.pathOf(*place.row);
    std::optional<Wrap> wanted;
    for (const EnumRow& mode : wrapRows) {
        const auto wrap = static_cast<Wrap>(mode.value);
        ImGui::PushID(mode.name.data());
        const ImVec2 low = ImGui::GetCursorScreenPos();
        const float height = std::ceil(em * 1.2F);
        if (ImGui::Selectable("##mode", wrap == chosen, 0, {width, height}))
            wanted = wrap;
        noteItem(fmt::format("edge:{}", mode.name));
        choiceTip(mode);
        if (ImGui::IsItemHovered() && wrap != chosen)
            preview(session, fmt::format("{}={}", path, mode.name),
                    Sentence("{0}: {1}", place.row->label, mode.label),
                    [&](Scene& scene) { (void)setParam(scene, path, mode.name); });
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        const std::string name = fitted(shownBrief(session.settings, mode), names - em * 0.6F);
        draw.AddText({low.x + em * 0.2F, low.y + (height - em) / 2},
                     wrap == chosen ? color::chosen : color::text, name.c_str());
        const PlotBox box{
            {low.x + names, low.y + 2}, {low.x + width - 2, low.y + height - 2}, lensFrom, lensTo};
        drawLensResult(draw, box, row, wrap);
        for (const float edge : {0.0F, 1.0F})
            draw.AddLine(box.at(edge, 1), box.at(edge, 0), color::text, plotLine());
        if (wrap == chosen)
            draw.AddRect(box.low - ImVec2(1, 1), box.high + ImVec2(1, 1), color::chosen, 0, 0,
                         plotLine() * 2);
        ImGui::PopID();
    }
    if (wanted)
        assignParam(session, place.owner, *place.row, EnumValue{static_cast<std::uint32_t>(*wanted)});
}

/// The number of texels, and the filter of the scene's texture.
void drawLensChoices(const Session& session, EdgeLensState& state, const ParamPlace& filter) {
    const float em = ImGui::GetFontSize();
    rowName(N_("Texels"));
    const auto sizes = segmentsOf(lensSizes, [](int size) { return std::to_string(size); });
    if (const auto pressed = drawSegments(sizes, em * 6, indexIn(lensSizes, state.size), [](std::size_t i) {
            item(fmt::format("edge:size {}", lensSizes.at(i)), "The number of texels in the row.");
        }))
        state.size = lensSizes.at(*pressed);
    sameLineFor(em * 11, em);
    rowName(N_("Filter"));
    paramControl(session, filter.owner, *filter.row, em * 10);
}

} // namespace

void drawEdgeLens(const Session& session, EdgeLensState& state) {
    const Texture* texture = boundTexture(session);
    const std::string path = fmt::format("textures[{}].", selectedUnit(session).texture);
    const std::optional<ParamPlace> wrapPlace =
        placeOf(presentScene(session), path + keyOf<&Texture::wrapS>());
    std::optional<ParamPlace> filterPlace =
        placeOf(presentScene(session), path + keyOf<&Texture::magFilter>());
    if (!texture || !wrapPlace || !filterPlace)
        return dimWrappedText(N_("Bind a texture to this unit to draw its wrap mode and its filter."));
    static const Texture initial;
    filterPlace->owner.initial = &initial;
    const float em = ImGui::GetFontSize();
    const float room = ImGui::GetContentRegionAvail().x;
    const bool beside = room > em * 46;
    drawLensChoices(session, state, *filterPlace);
    if (beside) {
        ImGui::SameLine(0, em * 1.5F);
        ImGui::AlignTextToFramePadding();
    }
    fittedText(N_("Drag across the drawing to read a coordinate. Click a wrap mode to use it for s."),
               color::dim);
    const LensRow row{state.size, glm::vec3(texture->borderColor), texture->magFilter == MagFilter::Linear};
    const Wrap wrap = texture->wrapS;
    const float right = beside ? std::max(em * 27, room * 0.38F) : room;
    const float gap = em * 1.2F;
    const float width = beside ? room - right - gap : room;
    const float height = beside ? std::max(ImGui::GetContentRegionAvail().y, em * 9) : em * 10;
    const ImVec2 top = ImGui::GetCursorPos();
    drawLens(state, row, wrap, width, height - ImGui::GetStyle().ItemSpacing.y);
    if (beside)
        ImGui::SetCursorPos({top.x + width + gap, top.y});
    ImGui::BeginGroup();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, std::floor(em * 0.12F)});
    drawLensStrips(session, *wrapPlace, row, wrap, right);
    drawLensReading(state, row, wrap);
    ImGui::PopStyleVar();
    ImGui::EndGroup();
}

} // namespace texplorer::ui
