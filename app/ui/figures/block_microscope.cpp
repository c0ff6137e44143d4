#include "app/ui/figures/block_microscope.h"

#include "app/ui/figures/figure_columns.h"
#include "app/ui/language/translate.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/segments.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace texplorer::ui {
namespace {

struct FormatChoice {
    BlockFormat format;
    const char* label;
};

constexpr std::array formatChoices{
    FormatChoice{BlockFormat::Dxt1, "DXT1 RGB"}, FormatChoice{BlockFormat::Dxt1Alpha, "DXT1 RGBA"},
    FormatChoice{BlockFormat::Dxt3, "DXT3"}, FormatChoice{BlockFormat::Dxt5, "DXT5"}};

struct SourceChoice {
    const char* label;
    const char* name;
    const char* help;
};

constexpr std::array sourceChoices{
    SourceChoice{N_("Free block"), "own", N_("A block to edit freely")},
    SourceChoice{N_("From the texture"), "texture",
                 N_("A block of level 0 of the bound texture: its stored bytes, or compressed now")},
    SourceChoice{N_("At the explained pixel"), "probed",
                 N_("The block of the texel that the explained pixel reads")}};

template<class Choices>
float minWidthOf(const Choices& choices) {
    float width = 0;
    for (const auto& each : choices)
        width += ImGui::CalcTextSize(tr(each.label)).x + ImGui::GetFontSize();
    return width;
}

void drawChoices(BlockMicroscopeState& state) {
    const float room = ImGui::GetContentRegionAvail().x;
    const float gap = ImGui::GetFontSize();
    const float formats = std::min(room, minWidthOf(formatChoices));
    const float sources = std::min(room, minWidthOf(sourceChoices));
    if (const auto pressed =
            drawSegments(segmentsOf(formatChoices, &FormatChoice::label), formats,
                         indexIn(formatChoices, state.format, &FormatChoice::format), [](std::size_t i) {
                             const EnumRow& row = rowOf(formatChoices.at(i).format);
                             item(fmt::format("block:format {}", formatChoices.at(i).label),
                                  Sentence("{0}\n{1}", row.name, row.help));
                         })) {
        const BlockFormat wanted = formatChoices.at(*pressed).format;
        state.block = inFormat(state.block, state.format, wanted);
        state.format = wanted;
        state.hovered.reset();
    }
    if (formats + gap + sources <= room)
        ImGui::SameLine(0, gap);
    if (const auto pressed = drawSegments(segmentsOf(sourceChoices, &SourceChoice::label), sources,
                                          static_cast<std::size_t>(state.source.kind), [](std::size_t i) {
                                              item(fmt::format("block:source {}", sourceChoices.at(i).name),
                                                   sourceChoices.at(i).help);
                                          }))
        state.source.kind = static_cast<BlockSource::Kind>(*pressed);
}

BlockLook lookAt(const BlockMicroscopeState& state) {
    const BlockFields fields = fieldsOf(state.format, state.block);
    return {fields, colorsOf(state.format, fields), alphasOf(state.format, fields),
            state.hovered ? linksOf(state.format, fields, *state.hovered) : BlockLinks{}};
}

} // namespace

void drawBlockMicroscope(const Session& session, BlockMicroscopeState& state) {
    followBlockSource(session, state);
    drawChoices(state);
    dimWrappedText(
        N_("Click a texel, then one of the four colours. Click a bit to flip it. Related parts light up."));
    const float em = ImGui::GetFontSize();
    const BlockLook look = lookAt(state);
    state.hovering.reset();
    const float room = ImGui::GetContentRegionAvail().x;
    const float high = ImGui::GetContentRegionAvail().y;
    const float cell = std::floor(std::clamp((high - em * 1.3F) / 4, em * 1.9F, em * 4));
    const FigureColumn texels{blockTexelsWidth(cell), [&] { drawBlockTexels(state, look, cell); }};
    const FigureColumn palette{blockPaletteWidth(), [&] { drawBlockPalette(state, look); }};
    const FigureColumn source{blockSourceWidth(), [&] { drawBlockSource(state); }};
    // As many columns as fit, the source last; in a narrow panel the source is next to the texels.
    const float threeRoom = room - texels.width - palette.width - 2 * figureColumnGap();
    const float fourRoom = threeRoom - source.width - figureColumnGap();
    const float least = blockBitsWidth(state.format, 1);
    const float bitsRoom = least <= fourRoom ? fourRoom : least <= threeRoom ? threeRoom : room;
    const float spread = blockBitsSpread(state.format, bitsRoom - least);
    const FigureColumn bits{
        std::max(blockBitsWidth(state.format, spread), std::min(blockHexWidth(state.format), bitsRoom)),
        [&] { drawBlockBits(state, look, spread, high - 4); }};
    drawFigureColumns(least <= threeRoom ? std::array{texels, palette, bits, source}
                                         : std::array{texels, source, palette, bits});
    state.hovered = state.hovering;
}

} // namespace texplorer::ui
