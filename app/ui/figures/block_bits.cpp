#include "app/ui/figures/block_columns.h"
#include "app/ui/figures/block_swatch.h"
#include "app/ui/language/translate.h"
#include "app/ui/widgets/param_tips.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/text_field.h"
#include "app/ui/widgets/theme.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace texplorer::ui {
namespace {

/// How a line of bits lies: what it is, its bytes, and then its number, the highest bit first.
struct BitLine {
    float letter; ///< width of a digit
    float names;
    float bytes;

    explicit BitLine(BlockFormat format)
        : letter(0)
        , names(std::max(ImGui::CalcTextSize(tr("alphas, rows 2, 3")).x,
                         ImGui::CalcTextSize(tr("indices, row 3")).x) +
                ImGui::GetFontSize() * 0.5F)
        , bytes(0) {
        ImGui::PushFont(codeFont());
        letter = ImGui::CalcTextSize("0").x;
        ImGui::PopFont();
        bytes = letter * (format == BlockFormat::Dxt5 ? 9.0F : 6.0F);
    }
    [[nodiscard]] float fieldGap() const { return std::floor(letter * 0.6F); }
};

std::string nameOfGroup(BlockFormat format, const BlockBytesGroup& group) {
    const BlockField& field = blockFields(format)[fieldAtBit(format, 8 * group.first)];
    switch (field.part) {
    case BlockPart::Color:
        return fmt::format("colour {}", field.number);
    case BlockPart::ColorIndex:
        return fmt::format("indices, row {}", field.number / 4);
    case BlockPart::AlphaEnd:
        return fmt::format("alpha {}", field.number);
    case BlockPart::Alpha:
        break;
    }
    const int row = field.number / 4;
    return format == BlockFormat::Dxt3 ? fmt::format("alphas, row {}", row)
                                       : fmt::format("alphas, rows {}, {}", row, row + 1);
}

/// What a bit says, in words.
std::string tipOf(BlockFormat format, int bit, const BlockField& field) {
    const int inByte = bit % 8;
    const int byte = bit / 8;
    const int column = field.number % 4;
    const int row = field.number / 4;
    switch (field.part) {
    case BlockPart::Color: {
        const int place = bit - field.first;
        if (place >= 11)
            return fmt::format("Bit {} of byte {}: red of colour {}", inByte, byte, field.number);
        return place >= 5 ? fmt::format("Bit {} of byte {}: green of colour {}", inByte, byte, field.number)
                          : fmt::format("Bit {} of byte {}: blue of colour {}", inByte, byte, field.number);
    }
    case BlockPart::ColorIndex:
        return fmt::format("Bit {} of byte {}: the colour index of texel {}, {}", inByte, byte, column, row);
    case BlockPart::AlphaEnd:
        return fmt::format("Bit {} of byte {}: alpha {}", inByte, byte, field.number);
    case BlockPart::Alpha:
        break;
    }
    return format == BlockFormat::Dxt3
               ? fmt::format("Bit {} of byte {}: the alpha of texel {}, {}", inByte, byte, column, row)
               : fmt::format("Bit {} of byte {}: the alpha index of texel {}, {}", inByte, byte, column, row);
}

/// The ink of a bit: red, green and blue of an end have theirs.
ImU32 inkOf(const BlockField& field, int bit) {
    if (field.part == BlockPart::Color) {
        const int place = bit - field.first;
        return componentColor(place >= 11 ? 0 : place >= 5 ? 1 : 2);
    }
    return field.part == BlockPart::AlphaEnd ? componentColor(3) : static_cast<ImU32>(color::text);
}

/// What a field means, as a stripe under its bits.
BlockColor meaningOf(const BlockField& field, const BlockLook& look) {
    const auto number = static_cast<std::size_t>(field.number);
    const auto grey = [](std::uint8_t value) { return BlockColor{value, value, value, 255}; };
    switch (field.part) {
    case BlockPart::Color:
        return look.colors.at(number);
    case BlockPart::ColorIndex:
        return look.colors.at(look.fields.indices[number]);
    case BlockPart::AlphaEnd:
        return grey(look.fields.alphaEnds.at(number));
    case BlockPart::Alpha:
        break;
    }
    return grey(look.alphas.at(look.fields.alphas[number]));
}

void drawField(BlockMicroscopeState& state, const BlockLook& look, const BitLine& line, std::size_t number,
               ImVec2 at) {
    const BlockField field = blockFields(state.format)[number];
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float width = line.letter * static_cast<float>(field.bits);
    const float em = ImGui::GetFontSize();
    const float stripe = std::max(2.0F, std::round(em / 7));
    if (look.lit.fields.test(number))
        draw.AddRectFilled({at.x - 1, at.y}, {at.x + width + 1, at.y + em}, color::lit);
    drawSwatch(draw, {at.x, at.y + em - 1}, {at.x + width, at.y + em - 1 + stripe}, meaningOf(field, look));
    for (int i = 0; i < field.bits; ++i) {
        const int bit = field.first + field.bits - 1 - i;
        const ImVec2 place(at.x + line.letter * static_cast<float>(i), at.y);
        ImGui::SetCursorScreenPos(place);
        const Spot spot = spotHere(fmt::format("bit {}", bit).c_str(), {line.letter, em + stripe});
        noteItem(fmt::format("block:bit {}", bit));
        const bool isSet = (readField(state.block, field) >> (bit - field.first) & 1) != 0;
        draw.AddText(place, inkOf(field, bit), isSet ? "1" : "0");
        if (spot.hovered) {
            draw.AddLine({place.x, place.y + 1}, {place.x + line.letter, place.y + 1}, color::text);
            state.hovering = BlockMark{BlockMark::Kind::Field, number};
            helpTip(tipOf(state.format, bit, field));
        }
        if (spot.pressed)
            toggleBit(state.block, bit);
    }
}

/// A text field with all bytes.
void drawHex(BlockMicroscopeState& state, float width) {
    ImGui::PushFont(codeFont());
    ImGui::SetNextItemWidth(width);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ImGui::GetFontSize() * 0.3F, 1});
    const bool typed = textField("##hex", state.hex, ImGuiInputTextFlags_CharsUppercase);
    ImGui::PopStyleVar();
    ImGui::PopFont();
    noteItem("block:hex");
    if (typed) {
        const Result<BlockBytes> block = blockOfHex(state.format, state.hex);
        state.hexProblem = block ? std::string() : block.error().message;
        if (block)
            state.block = *block;
    } else if (!ImGui::IsItemActive()) {
        state.hex = hexOf(state.format, state.block);
        state.hexProblem.clear();
    }
    if (state.hexProblem.empty())
        return helpTip("The block's bytes in hexadecimal, in the order of the file");
    ImGui::PushStyleColor(ImGuiCol_Text, color::problem);
    wrappedText(state.hexProblem);
    ImGui::PopStyleColor();
    noteItem("block:hex problem");
}

} // namespace

float blockBitsWidth(BlockFormat format) {
    const BitLine line(format);
    float numbers = 0;
    for (const BlockBytesGroup& group : blockGroups(format)) {
        const std::size_t first = fieldAtBit(format, 8 * group.first);
        const std::size_t last = fieldAtBit(format, 8 * (group.first + group.count) - 1);
        numbers = std::max(numbers, line.letter * 8 * static_cast<float>(group.count) +
                                        line.fieldGap() * static_cast<float>(last - first));
    }
    return std::ceil(line.names + line.bytes + numbers) + 2;
}

void drawBlockBits(BlockMicroscopeState& state, const BlockLook& look) {
    const BlockFormat format = state.format;
    const BitLine line(format);
    drawHex(state, blockBitsWidth(format));
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    for (const BlockBytesGroup& group : blockGroups(format)) {
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        draw.AddText(corner, color::dim, tr(nameOfGroup(format, group)).c_str());
        ImGui::PushFont(codeFont());
        std::string bytes;
        for (int i = 0; i < group.count; ++i)
            bytes += fmt::format(
                "{:02X} ", std::to_integer<int>(state.block[static_cast<std::size_t>(group.first + i)]));
        const float height = ImGui::GetFontSize() * 1.22F;
        draw.AddText({corner.x + line.names, corner.y}, color::text, bytes.c_str());
        float x = corner.x + line.names + line.bytes;
        const std::size_t first = fieldAtBit(format, 8 * group.first);
        for (std::size_t i = fieldAtBit(format, 8 * (group.first + group.count) - 1) + 1; i > first; --i) {
            drawField(state, look, line, i - 1, {x, corner.y});
            x += line.letter * static_cast<float>(blockFields(format)[i - 1].bits) + line.fieldGap();
        }
        ImGui::PopFont();
        ImGui::SetCursorScreenPos(corner);
        ImGui::Dummy({blockBitsWidth(format), height});
    }
    ImGui::PopStyleVar();
}

} // namespace texplorer::ui
