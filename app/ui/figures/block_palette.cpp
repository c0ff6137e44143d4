#include "app/ui/figures/block_microscope.h"
#include "app/ui/figures/block_swatch.h"
#include "app/ui/language/translate.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/popups.h"
#include "texplorer/base/sentence_format.h"

#include <fmt/core.h>

#include <cmath>

namespace texplorer::ui {
namespace {

constexpr std::array componentBits{5, 6, 5};
constexpr std::array componentShift{11, 5, 0};

/// A draggable integer, with the bar of its component on the left.
bool dragInteger(const std::string& name, int& value, int max, float width, int component) {
    ImGui::SetNextItemWidth(width);
    const bool changed = dragInt(fmt::format("##{}", name).c_str(), value, 0.15F, 0, max);
    if (ImGui::IsItemHovered())
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    const ImVec2 low = ImGui::GetItemRectMin();
    ImGui::GetWindowDrawList()->AddRectFilled(
        low, {low.x + ImGui::GetFontSize() * 0.2F, ImGui::GetItemRectMax().y}, componentColor(component),
        ImGui::GetStyle().FrameRounding, ImDrawFlags_RoundCornersLeft);
    noteItem(name);
    return changed;
}

/// Gives a field of the selected texel another value.
void setTexel(BlockMicroscopeState& state, BlockPart part, std::size_t value) {
    writeField(state.block, blockField(state.format, part, static_cast<int>(state.texel)),
               static_cast<unsigned>(value));
}

void hoverEnd(BlockMicroscopeState& state, BlockPart part, int end) {
    if (ImGui::IsItemHovered() || ImGui::IsItemActive())
        state.hovering = BlockMark{BlockMark::Kind::Field,
                                   fieldAtBit(state.format, blockField(state.format, part, end).first)};
}

/// The end as a colour picker and as its three numbers.
void drawColorEnd(BlockMicroscopeState& state, const BlockLook& look, int end) {
    const auto index = static_cast<std::size_t>(end);
    const BlockColor& color = look.colors[index];
    const BlockField& field = blockField(state.format, BlockPart::Color, end);
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const std::string name = fmt::format("block:color {}", end);
    std::array<float, 3> shown{static_cast<float>(color[0]) / 255, static_cast<float>(color[1]) / 255,
                               static_cast<float>(color[2]) / 255};
    const auto toByte = [&](std::size_t c) { return static_cast<int>(std::lround(shown.at(c) * 255)); };
    if (ImGui::ColorButton(fmt::format("##{}", name).c_str(), {shown[0], shown[1], shown[2], 1},
                           ImGuiColorEditFlags_NoAlpha | ImGuiColorEditFlags_NoTooltip |
                               ImGuiColorEditFlags_NoDragDrop))
        ImGui::OpenPopup(name.c_str());
    noteItem(name);
    hoverEnd(state, BlockPart::Color, end);
    helpTip("Sets this end colour, to the nearest colour of 5, 6 and 5 bits.");
    if (beginPopup(name.c_str())) {
        ImGui::SetNextItemWidth(ImGui::GetFontSize() * 12);
        if (ImGui::ColorPicker3("##picker", shown.data(),
                                ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_DisplayRGB))
            writeField(state.block, field, quantized(toByte(0), toByte(1), toByte(2)));
        noteItem(name + "#picker");
        endPopup();
    }
    const unsigned stored = readField(state.block, field);
    for (std::size_t c = 0; c < 3; ++c) {
        ImGui::SameLine(0, gap);
        const unsigned max = (1U << componentBits.at(c)) - 1;
        int value = static_cast<int>(stored >> componentShift.at(c) & max);
        const auto left = static_cast<float>(3 - c);
        const float each = std::floor((ImGui::GetContentRegionAvail().x - gap * (left - 1)) / left);
        if (dragInteger(fmt::format("{}[{}]", name, c), value, static_cast<int>(max), each,
                        static_cast<int>(c))) {
            const unsigned others = stored & ~(max << componentShift.at(c));
            writeField(state.block, field, others | static_cast<unsigned>(value) << componentShift.at(c));
        }
        hoverEnd(state, BlockPart::Color, end);
        helpTip(Sentence("{0} of {1} is {2} of 255.", value, max, color.at(c)));
    }
}

/// How a colour is computed that is not stored.
const char* recipeOf(std::size_t index, bool fourColors, BlockFormat format) {
    if (fourColors)
        return index == 2 ? "(2c0+c1)/3" : "(c0+2c1)/3";
    if (index == 2)
        return "(c0+c1)/2";
    return format == BlockFormat::Dxt1Alpha ? N_("Transparent") : N_("Black");
}

void drawColorRow(BlockMicroscopeState& state, const BlockLook& look, std::size_t index) {
    const float em = ImGui::GetFontSize();
    const Spot spot = spotHere(fmt::format("entry {}", index).c_str(), {em * 2.2F, ImGui::GetFrameHeight()});
    noteItem(fmt::format("block:entry {}", index));
    drawSwatch(spot.low, spot.high, look.colors.at(index));
    drawOnSwatch(spot.low, spot.high, fmt::format("{:02b}", index).c_str());
    drawSwatchFrame(spot.low, spot.high, look.fields.indices[state.texel] == index,
                    look.lit.colors.test(index));
    if (spot.hovered) {
        state.hovering = BlockMark{BlockMark::Kind::Color, index};
        helpTip("Gives the selected texel this index.");
    }
    if (spot.pressed)
        setTexel(state, BlockPart::ColorIndex, index);
    ImGui::SameLine();
    if (index < 2)
        return drawColorEnd(state, look, static_cast<int>(index));
    const BlockColor& color = look.colors.at(index);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(fmt::format("{} {} {}", color[0], color[1], color[2]).c_str());
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    fittedText(recipeOf(index, hasFourColors(state.format, look.fields), state.format), color::dim);
}

/// Which of the two meanings the indices have, and why.
void modeSentence(const BlockMicroscopeState& state, const BlockLook& look) {
    const auto [first, second] = look.fields.colors;
    const bool isDxt1 = alphaCount(state.format) == 0;
    using Words = Sentence::Key<std::uint16_t, std::uint16_t>;
    const Words words =
        first > second ? Words(N_("c0 = {0:04X} is larger than c1 = {1:04X}: four colours."))
        : state.format == BlockFormat::Dxt1Alpha
            ? Words(N_("c0 = {0:04X} is not larger than c1 = {1:04X}: three colours and a hole."))
            : Words(N_("c0 = {0:04X} is not larger than c1 = {1:04X}: three colours and black."));
    wrappedText(isDxt1 ? Sentence(words, first, second)
                       : Sentence("{0} always has four colours.", rowOf(state.format).label));
    noteItem("block:mode");
}

void swapEnds(BlockMicroscopeState& state, BlockPart part) {
    const BlockField& first = blockField(state.format, part, 0);
    const BlockField& second = blockField(state.format, part, 1);
    const unsigned kept = readField(state.block, first);
    writeField(state.block, first, readField(state.block, second));
    writeField(state.block, second, kept);
}

void drawAlphaEnds(BlockMicroscopeState& state, const BlockLook& look) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = std::floor(ImGui::GetFontSize() * 2.9F);
    for (int end = 0; end < 2; ++end) {
        int value = look.fields.alphaEnds.at(static_cast<std::size_t>(end));
        if (dragInteger(fmt::format("block:alpha {}", end), value, 255, width, 3))
            writeField(state.block, blockField(state.format, BlockPart::AlphaEnd, end),
                       static_cast<unsigned>(value));
        hoverEnd(state, BlockPart::AlphaEnd, end);
        helpTip(end == 0 ? "Alpha 0, 8 bits. If larger than alpha 1: eight alphas; else six, 0 and 255."
                         : N_("Alpha 1, 8 bits."));
        ImGui::SameLine(0, gap);
    }
    const char* words = hasEightAlphas(look.fields) ? N_("Swap (eight)") : N_("Swap (six)");
    if (ImGui::Button(label(fmt::format("{}##alphas", words)).c_str(), {ImGui::GetContentRegionAvail().x, 0}))
        swapEnds(state, BlockPart::AlphaEnd);
    item("block:swap alphas",
         "Swaps the two ends. The larger one first means eight alphas, else six, 0 and 255.");
}

/// Each possible alpha of a texel, in lines of this many; a click sets it on the selected texel.
void drawAlphas(BlockMicroscopeState& state, const BlockLook& look) {
    const std::size_t count = alphaCount(state.format);
    const std::size_t perLine = count == 16 ? 8 : 4;
    const float width = std::floor(ImGui::GetContentRegionAvail().x / static_cast<float>(perLine));
    const ImVec2 size(width, ImGui::GetFontSize() * 1.15F);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 1});
    for (std::size_t i = 0; i < count; ++i) {
        if (i % perLine != 0)
            ImGui::SameLine();
        const std::uint8_t alpha = look.alphas[i];
        const Spot spot = spotHere(fmt::format("alpha {}", i).c_str(), size);
        noteItem(fmt::format("block:alpha entry {}", i));
        drawSwatch(spot.low, {spot.high.x - 1, spot.high.y}, {alpha, alpha, alpha, 255});
        drawOnSwatch(spot.low, spot.high, std::to_string(alpha).c_str());
        drawSwatchFrame(spot.low, {spot.high.x - 1, spot.high.y}, look.fields.alphas[state.texel] == i,
                        look.lit.alphas.test(i));
        if (spot.hovered) {
            state.hovering = BlockMark{BlockMark::Kind::Alpha, i};
            const std::string bits = count == 16 ? fmt::format("{:04b}", i) : fmt::format("{:03b}", i);
            helpTip(
                Sentence("Gives the selected texel the alpha {0}, stored as {1}.", alpha, ProperName{bits}));
        }
        if (spot.pressed)
            setTexel(state, BlockPart::Alpha, i);
    }
    ImGui::PopStyleVar();
}

} // namespace

float blockPaletteWidth() {
    return std::floor(ImGui::GetFontSize() * 14);
}

void drawBlockPalette(BlockMicroscopeState& state, const BlockLook& look) {
    modeSentence(state, look);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 1});
    for (std::size_t index = 0; index < 4; ++index)
        drawColorRow(state, look, index);
    ImGui::PopStyleVar();
    if (alphaCount(state.format) == 0) {
        if (ImGui::Button(label("Swap the ends")))
            swapEnds(state, BlockPart::Color);
        item("block:swap",
             "Swaps the two end colours. The larger number first means four colours, else three and a "
             "hole.");
        return;
    }
    if (state.format == BlockFormat::Dxt5)
        drawAlphaEnds(state, look);
    drawAlphas(state, look);
}

} // namespace texplorer::ui
