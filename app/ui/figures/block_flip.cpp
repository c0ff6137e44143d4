#include "app/ui/figures/block_flip.h"

#include "app/ui/figures/block_swatch.h"
#include "app/ui/figures/figure_columns.h"
#include "app/ui/figures/plot.h"
#include "app/ui/language/translate.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/points.h"
#include "app/ui/widgets/segments.h"
#include "app/ui/widgets/theme.h"
#include "texplorer/s3tc/flip.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ranges>

namespace texplorer::ui {
namespace {

using Act = FlipStep::Act;

struct FlipFormat {
    BlockFormat format;
    const char* label;
};
constexpr std::array flipFormats{FlipFormat{BlockFormat::Dxt1Alpha, "DXT1"},
                                 FlipFormat{BlockFormat::Dxt3, "DXT3"},
                                 FlipFormat{BlockFormat::Dxt5, "DXT5"}};
constexpr std::array flipHeights{1, 2, 3, 4, 6, 8, 10, 12};

void chooseFormat(BlockFlipState& state) {
    const float width = std::min(ImGui::GetContentRegionAvail().x, ImGui::GetFontSize() * 11);
    if (const auto pressed =
            drawSegments(segmentsOf(flipFormats, &FlipFormat::label), width,
                         indexIn(flipFormats, state.format, &FlipFormat::format), [](std::size_t i) {
                             item(fmt::format("flip:format {}", flipFormats.at(i).label),
                                  rowOf(flipFormats.at(i).format).help);
                         }))
        state.format = flipFormats.at(*pressed).format;
}

std::string numberText(std::size_t number) {
    return std::to_string(number);
}

void chooseHeight(BlockFlipState& state) {
    rowName(N_("Height"));
    const float width = std::min(ImGui::GetContentRegionAvail().x, ImGui::GetFontSize() * 16);
    if (const auto pressed = drawSegments(segmentsOf(flipHeights, numberText), width,
                                          indexIn(flipHeights, state.height), [](std::size_t i) {
                                              item(fmt::format("flip:height {}", flipHeights.at(i)),
                                                   flipsWithoutLoss(flipHeights.at(i))
                                                       ? N_("This height is flipped without loss.")
                                                       : N_("This height can't be flipped in blocks."));
                                          })) {
        state.height = flipHeights.at(*pressed);
        state.step = 0;
    }
}

/// A button to the step before or after this one.
bool stepButton(const char* words, const char* name, bool enabled) {
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button(label(words));
    ImGui::EndDisabled();
    noteItem(name);
    return pressed && enabled;
}

/// Previous, the steps by number, and Next.
void chooseStep(BlockFlipState& state) {
    const std::size_t now = state.step;
    if (stepButton(N_("Previous"), "flip:back", now > 0))
        state.step = now - 1;
    ImGui::SameLine();
    const auto numbers = std::views::iota(std::size_t{0}, state.steps.size());
    const float width = std::min(ImGui::GetContentRegionAvail().x,
                                 ImGui::GetFontSize() * 1.8F * static_cast<float>(numbers.size()));
    if (const auto pressed = drawSegments(segmentsOf(numbers, numberText), width, now, [](std::size_t i) {
            item(fmt::format("flip:step {}", i), "The step; 0 is the image as stored.");
        }))
        state.step = *pressed;
    ImGui::SameLine();
    if (stepButton(N_("Next"), "flip:next", now + 1 < state.steps.size()))
        state.step = now + 1;
}

/// Computed once for each format and height.
void followFlip(BlockFlipState& state) {
    if (state.stepsHeight == state.height && state.stepsFormat == state.format)
        return;
    if (auto steps = flipSteps(stripedBlocks(state.format, state.height)))
        state.steps = *std::move(steps);
    state.stepsHeight = state.height;
    state.stepsFormat = state.format;
    state.step = std::min(state.step, state.steps.size() - 1);
}

/// The layout of a picture's rows.
struct StripeLook {
    float row;   ///< height
    float names; ///< width of the rows' labels
    float width;
    float gap; ///< between blocks

    [[nodiscard]] float topOf(int number) const {
        return static_cast<float>(number) * row + static_cast<float>(number / 4) * gap;
    }
};

StripeLook stripeLook(int blockRows, float room) {
    const float em = ImGui::GetFontSize();
    const float gap = std::floor(em * 0.3F);
    const auto rows = static_cast<float>(4 * blockRows);
    const float row =
        std::floor(std::clamp((room - gap * static_cast<float>(blockRows)) / rows, em * 0.78F, em * 2.0F));
    return {row, em * 1.4F, em * 5.4F, gap};
}

/// The rows of a step, with their numbers from the beginning.
void drawStripes(const BlockFlipState& state, std::size_t step, const StripeLook& look) {
    const BlockImage& image = state.steps[step].after;
    const BlockImage& stored = state.steps.front().after;
    const bool again = state.steps[step].act == Act::Recompress;
    const bool hasAlpha = alphaCount(image.format) > 0;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const auto rows = 4 * static_cast<int>(image.blockRows());
    const float left = corner.x + look.names;
    const float alphaFrom = left + look.width * (hasAlpha ? 0.62F : 1.0F);
    const float em = ImGui::GetFontSize();
    for (int row = 0; row < rows; ++row) {
        const bool isInside = row < image.height;
        const BlockColor color =
            texelsOf(image.format, blockAt(image, 0, row / 4))[static_cast<std::size_t>(row % 4) * 4];
        const ImVec2 low(left, corner.y + look.topOf(row));
        const ImVec2 high = low + ImVec2(look.width, look.row - 1);
        drawSwatch(low, {alphaFrom, high.y}, {color[0], color[1], color[2], 255});
        if (hasAlpha)
            drawSwatch({alphaFrom, low.y}, high, {color[3], color[3], color[3], 255});
        const int from = again ? image.height - 1 - row : stripeAt(image, stored, row);
        const bool wasInside = from >= 0 && from < image.height;
        const std::string name = wasInside ? std::to_string(from) : "✕";
        drawOnSwatch(low, {alphaFrom, high.y}, name.c_str());
        if (hasAlpha && look.width * 0.38F > em * 1.6F)
            drawOnSwatch({alphaFrom, low.y}, high, std::to_string(color[3]).c_str());
        if (!isInside)
            draw.AddRectFilled(low, high, color::shade);
        const std::string place = std::to_string(row);
        const float letters = std::min(em, look.row);
        const float wide = ImGui::CalcTextSize(place.c_str()).x * letters / em;
        draw.AddText(ImGui::GetFont(), letters,
                     {left - wide - em * 0.3F, std::floor(low.y + (look.row - letters) / 2)},
                     isInside ? color::dim : color::faint, place.c_str());
        noteDrawn(fmt::format("flip:row {} of step {} is {}", row, step, isInside ? name : "outside"), low,
                  high);
    }
    for (int block = 0; block < rows / 4; ++block)
        draw.AddRect({left - 2, corner.y + look.topOf(4 * block) - 2},
                     {left + look.width + 2, corner.y + look.topOf(4 * block + 3) + look.row + 1},
                     color::outline, 0, 0, plotLine());
    if (image.height < rows) {
        const float y = corner.y + look.topOf(image.height) - 1;
        draw.AddLine({corner.x, y}, {left + look.width + look.names / 2, y}, color::chosen,
                     std::max(1.5F, em / 8));
    }
    ImGui::Dummy({look.names + look.width, look.topOf(rows - 1) + look.row + 2});
}

/// A bracket between two positions, with an arrowhead at both ends, that extends `out` to the right.
void drawBracket(ImDrawList& draw, float x, float from, float to, float out) {
    const float em = ImGui::GetFontSize();
    const float thick = std::max(1.5F, em / 9);
    const float head = em * 0.25F;
    draw.AddLine({x + head, from}, {x + out, from}, color::accent, thick);
    draw.AddLine({x + out, from}, {x + out, to}, color::accent, thick);
    draw.AddLine({x + out, to}, {x + head, to}, color::accent, thick);
    for (const float y : {from, to})
        draw.AddTriangleFilled({x, y}, {x + 1.6F * head, y - head}, {x + 1.6F * head, y + head},
                               color::accent);
}

float bracketRoom() {
    return ImGui::GetFontSize() * 1.9F;
}

/// The exchanges of the step, next to its picture.
void drawBrackets(const FlipStep& step, ImVec2 corner, const StripeLook& look) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float x = corner.x + look.names + look.width + ImGui::GetFontSize() * 0.35F;
    const float out = ImGui::GetFontSize();
    if (step.act == Act::SwapBlockRows) {
        const auto middle = [&](int block) { return corner.y + look.topOf(4 * block + 2) - 1; };
        drawBracket(draw, x, middle(step.first), middle(step.second), out * 1.4F);
    }
    if (step.act != Act::TurnRows)
        return;
    const auto middle = [&](int row) { return corner.y + look.topOf(4 * step.first + row) + look.row / 2; };
    const int rows = turnedRows(step.after.height);
    for (int row = 0; row < rows / 2; ++row)
        drawBracket(draw, x, middle(row), middle(rows - 1 - row), out * (row == 1 ? 0.8F : 1.4F));
}

/// The texel row of the block to which a byte belongs; -1: to all, or to two rows.
int rowOfByte(BlockFormat format, int byte) {
    const int colors = alphaCount(format) > 0 ? 8 : 0;
    if (byte >= colors + 4)
        return byte - colors - 4;
    return format == BlockFormat::Dxt3 && byte < 8 ? byte / 2 : -1;
}

/// Some digits with a label below them, highlighted if the step has changed them.
void drawDigits(ImVec2 at, const std::string& digits, const BlockColor* meaning, bool changed) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float em = ImGui::GetFontSize();
    const float width = ImGui::CalcTextSize(digits.c_str()).x;
    const float stripe = std::max(2.0F, std::round(em / 7));
    if (changed)
        draw.AddRectFilled({at.x - 2, at.y}, {at.x + width + 2, at.y + em}, color::lit);
    draw.AddText(at, color::text, digits.c_str());
    if (meaning)
        draw.AddRectFilled({at.x, at.y + em - 1}, {at.x + width, at.y + em - 1 + stripe},
                           IM_COL32((*meaning)[0], (*meaning)[1], (*meaning)[2], 255));
}

float bytesNames() {
    return ImGui::CalcTextSize(tr("block 0")).x + ImGui::GetFontSize() * 0.7F;
}

float bytesWidth() {
    return bytesNames() + codeLetter() * 25;
}

/// The bytes of every row of blocks; for DXT5 also the twelve bits of each row of alphas.
void drawFlipBytes(const BlockFlipState& state) {
    const FlipStep& step = state.steps[state.step];
    const BlockImage& before = state.steps[state.step > 0 ? state.step - 1 : 0].after;
    const BlockFormat format = step.after.format;
    const bool hasAlpha = alphaCount(format) > 0;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    for (int block = 0; block < static_cast<int>(step.after.blockRows()); ++block) {
        const BlockBytes bytes = blockAt(step.after, 0, block);
        const BlockBytes old = blockAt(before, 0, block);
        const std::array<BlockColor, 16> texels = texelsOf(format, bytes);
        ImVec2 corner = ImGui::GetCursorScreenPos();
        const ImVec2 top = corner;
        draw.AddText(corner, color::dim, tr(Sentence("block {0}", block)).c_str());
        ImGui::PushFont(codeFont());
        const float letter = codeLetter();
        const float line = std::floor(ImGui::GetFontSize() * 1.2F);
        const float names = bytesNames();
        for (int i = 0; i < static_cast<int>(bytesPerBlock(format)); ++i) {
            const auto at = static_cast<std::size_t>(i);
            if (i == 8)
                corner.y += line;
            const int row = rowOfByte(format, i);
            BlockColor meaning = row < 0 ? BlockColor{} : texels.at(static_cast<std::size_t>(row) * 4);
            if (hasAlpha && i < 8)
                meaning = {meaning[3], meaning[3], meaning[3], 255};
            drawDigits({corner.x + names + letter * 3 * static_cast<float>(i % 8), corner.y},
                       fmt::format("{:02X}", std::to_integer<int>(bytes[at])), row < 0 ? nullptr : &meaning,
                       bytes[at] != old[at]);
            if (format != BlockFormat::Dxt5 || i != 7)
                continue;
            corner.y += line;
            const auto twelve = [&](const BlockBytes& of, int number) {
                return readField(of, {BlockPart::Alpha, 0, 16 + 12 * number, 12});
            };
            for (int number = 0; number < 4; ++number) {
                const std::uint8_t alpha = texels.at(static_cast<std::size_t>(number) * 4)[3];
                const BlockColor grey{alpha, alpha, alpha, 255};
                drawDigits({corner.x + names + letter * (6 + 4.5F * static_cast<float>(number)), corner.y},
                           fmt::format("{:03X}", twelve(bytes, number)), &grey,
                           twelve(bytes, number) != twelve(old, number));
            }
        }
        ImGui::PopFont();
        ImGui::Dummy({bytesWidth(), corner.y - top.y + line});
        item(fmt::format("flip:bytes {}", block),
             format == BlockFormat::Dxt5
                 ? N_("The bytes of the alphas, the 12 bits of each alpha row as three digits, and the bytes "
                      "of the colours. The stripe is the row's alpha or colour; changes are highlighted.")
                 : N_("The stripe is the alpha or the colour of the byte's row. Changes of the step are "
                      "highlighted."));
    }
}

} // namespace

void drawBlockFlip(BlockFlipState& state) {
    const float em = ImGui::GetFontSize();
    const float room = ImGui::GetContentRegionAvail().x;
    chooseFormat(state);
    if (room > em * 34)
        ImGui::SameLine(0, em);
    chooseHeight(state);
    followFlip(state);
    if (room > em * 58)
        ImGui::SameLine(0, em);
    chooseStep(state);
    const FlipStep& now = state.steps[state.step];
    const StripeLook look =
        stripeLook(static_cast<int>(now.after.blockRows()), ImGui::GetContentRegionAvail().y - em * 1.6F);
    const float picture = look.names + look.width;
    const FigureColumn stored{picture + em * 0.3F, [&] {
                                  dimText("As stored");
                                  drawStripes(state, 0, look);
                              }};
    const FigureColumn shown{picture + bracketRoom(), [&] {
                                 text(Sentence("Step {0}", state.step));
                                 const ImVec2 corner = ImGui::GetCursorScreenPos();
                                 drawStripes(state, state.step, look);
                                 drawBrackets(now, corner, look);
                             }};
    const FigureColumn bytes{bytesWidth(), [&] {
                                 dimText("Bytes after the step");
                                 drawFlipBytes(state);
                             }};
    const float used = stored.width + shown.width + bytes.width + 3 * figureColumnGap();
    const FigureColumn words{std::clamp(room - used, std::min(room, em * 11), em * 30), [&] {
                                 for (const Sentence& sentence : flipSentences(state.steps, state.step))
                                     wrappedText(sentence);
                                 noteItem("flip:words");
                             }};
    if (used + em * 11 <= room)
        return drawFigureColumns(std::array{stored, shown, bytes, words});
    drawFigureColumns(std::array{FigureColumn{room, words.draw}, stored, shown, bytes});
}

} // namespace texplorer::ui
