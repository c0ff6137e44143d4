#include "app/ui/figures/block_microscope.h"
#include "app/ui/figures/block_swatch.h"
#include "app/ui/language/translate.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/text_field.h"
#include "app/ui/widgets/theme.h"
#include "texplorer/base/sentence_format.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace texplorer::ui {
namespace {

/// Red, green or blue, of a bit of an end colour.
int componentOf(const BlockField& field, int bit) {
    const int place = bit - field.first;
    return place >= 11 ? 0 : place >= 5 ? 1 : 2;
}

/// The layout of a line of bits: its name, its bytes, and its number, the highest bit first.
struct BitLine {
    float letter = 0; ///< width of a bit
    float names = 0;
    float bytes = 0;
    float gap = 0; ///< between fields

    BitLine(BlockFormat format, float spread) {
        for (const char* name : {N_("colour 0"), N_("index row 0"), N_("α rows 0, 1")})
            names = std::max(names, ImGui::CalcTextSize(tr(name)).x);
        names += ImGui::GetFontSize() * 0.5F;
        const float digit = codeLetter();
        letter = std::floor(digit * spread);
        bytes = digit * (format == BlockFormat::Dxt5 ? 9.0F : 6.0F);
        gap = std::floor(digit * 0.6F);
    }
    /// The left edge of a bit, counted from the field's left end.
    [[nodiscard]] float placeOf(const BlockField& field, int bit) const {
        const int before = field.part == BlockPart::Color ? componentOf(field, bit) : 0;
        return letter * static_cast<float>(field.bits - 1 - (bit - field.first)) +
               gap * static_cast<float>(before);
    }
    [[nodiscard]] float widthOf(const BlockField& field) const {
        return placeOf(field, field.first) + letter;
    }
    [[nodiscard]] float widthOf(BlockFormat format, const BlockBytesGroup& group) const {
        float width = -gap;
        for (const BlockField& field : fieldsOfGroup(format, group))
            width += widthOf(field) + gap;
        return width;
    }
    [[nodiscard]] static std::span<const BlockField> fieldsOfGroup(BlockFormat format,
                                                                   const BlockBytesGroup& group) {
        const std::size_t first = fieldAtBit(format, 8 * group.first);
        const std::size_t last = fieldAtBit(format, 8 * (group.first + group.count) - 1);
        return blockFields(format).subspan(first, last - first + 1);
    }
};

Sentence nameOfGroup(BlockFormat format, const BlockBytesGroup& group) {
    const BlockField& field = blockFields(format)[fieldAtBit(format, 8 * group.first)];
    switch (field.part) {
    case BlockPart::Color:
        return {N_("colour {0}"), field.number};
    case BlockPart::ColorIndex:
        return {N_("index row {0}"), field.number / 4};
    case BlockPart::AlphaEnd:
        return {N_("α {0}"), field.number};
    case BlockPart::Alpha:
        break;
    }
    const int row = field.number / 4;
    return format == BlockFormat::Dxt3 ? Sentence("α row {0}", row)
                                       : Sentence("α rows {0}, {1}", row, row + 1);
}

/// Of a bit, its byte, and the number of a colour or an alpha, or a texel.
using BitTip = Sentence::Key<int, int, int, int>;

constexpr std::array<BitTip, 3> componentTips{N_("Bit {0} of byte {1}: red of colour {2}"),
                                              N_("Bit {0} of byte {1}: green of colour {2}"),
                                              N_("Bit {0} of byte {1}: blue of colour {2}")};

/// The meaning of a bit in words.
Sentence tipOf(BlockFormat format, int bit, const BlockField& field) {
    const bool isEnd = field.part == BlockPart::Color || field.part == BlockPart::AlphaEnd;
    const BitTip words =
        field.part == BlockPart::Color ? componentTips.at(static_cast<std::size_t>(componentOf(field, bit)))
        : field.part == BlockPart::AlphaEnd ? BitTip(N_("Bit {0} of byte {1}: alpha {2}"))
        : field.part == BlockPart::ColorIndex
            ? BitTip(N_("Bit {0} of byte {1}: the colour index of texel {2}, {3}"))
        : format == BlockFormat::Dxt3 ? BitTip(N_("Bit {0} of byte {1}: the alpha of texel {2}, {3}"))
                                      : BitTip(N_("Bit {0} of byte {1}: the alpha index of texel {2}, {3}"));
    return {words, bit % 8, bit / 8, isEnd ? field.number : field.number % 4, field.number / 4};
}

/// The colour of a bit: red, green and blue of an end have their own.
ImU32 inkOf(const BlockField& field, int bit) {
    if (field.part == BlockPart::Color)
        return componentColor(componentOf(field, bit));
    return field.part == BlockPart::AlphaEnd ? componentColor(3) : static_cast<ImU32>(color::text);
}

/// The meaning of a field, as a stripe below its bits.
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
    const float width = line.widthOf(field);
    const float em = ImGui::GetFontSize();
    const float stripe = std::max(2.0F, std::round(em / 7));
    if (look.lit.fields.test(number))
        draw.AddRectFilled({at.x - 1, at.y}, {at.x + width + 1, at.y + em}, color::lit);
    drawSwatch({at.x, at.y + em - 1}, {at.x + width, at.y + em - 1 + stripe}, meaningOf(field, look));
    const float indent = (line.letter - ImGui::CalcTextSize("0").x) / 2;
    for (int bit = field.first + field.bits - 1; bit >= field.first; --bit) {
        const ImVec2 place(at.x + line.placeOf(field, bit), at.y);
        ImGui::SetCursorScreenPos(place);
        const Spot spot = spotHere(fmt::format("bit {}", bit).c_str(), {line.letter, em + stripe});
        noteItem(fmt::format("block:bit {}", bit));
        const bool isSet = (readField(state.block, field) >> (bit - field.first) & 1) != 0;
        draw.AddText({place.x + indent, place.y}, inkOf(field, bit), isSet ? "1" : "0");
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
        state.hexProblem = block ? Sentence() : block.error().message;
        if (block)
            state.block = *block;
    } else if (!ImGui::IsItemActive()) {
        state.hex = hexOf(state.format, state.block);
        state.hexProblem = {};
    }
    if (state.hexProblem.empty())
        return helpTip("The block's bytes in hexadecimal, in file order");
    wrappedText(state.hexProblem, color::problem);
    noteItem("block:hex problem");
}

} // namespace

float blockBitsWidth(BlockFormat format, float spread) {
    const BitLine line(format, spread);
    float numbers = 0;
    for (const BlockBytesGroup& group : blockGroups(format))
        numbers = std::max(numbers, line.widthOf(format, group));
    return std::ceil(line.names + line.bytes + numbers) + 2;
}

float blockBitsSpread(BlockFormat format, float more) {
    const float digit = BitLine(format, 1).letter;
    const float bits = format == BlockFormat::Dxt5 ? 24 : 16;
    return std::clamp(1 + more / (digit * bits), 1.0F, 1.5F);
}

float blockHexWidth(BlockFormat format) {
    ImGui::PushFont(codeFont());
    const auto digits = static_cast<float>(3 * bytesPerBlock(format) - 1);
    const float width = ImGui::CalcTextSize("0").x * digits + ImGui::GetFontSize() * 0.8F;
    ImGui::PopFont();
    return std::ceil(width);
}

void drawBlockBits(BlockMicroscopeState& state, const BlockLook& look, float spread, float room) {
    const BlockFormat format = state.format;
    const BitLine line(format, spread);
    const float width = blockBitsWidth(format, spread);
    const float top = ImGui::GetCursorPosY();
    drawHex(state, std::min(ImGui::GetContentRegionAvail().x, blockHexWidth(format)));
    const float em = ImGui::GetFontSize();
    const float left = room - (ImGui::GetCursorPosY() - top);
    const float height =
        std::floor(std::clamp(left / static_cast<float>(blockGroups(format).size()), em * 0.95F, em * 1.4F));
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
        draw.AddText({corner.x + line.names, corner.y}, color::text, bytes.c_str());
        float x = corner.x + line.names + line.bytes;
        const std::span<const BlockField> fields = BitLine::fieldsOfGroup(format, group);
        for (std::size_t i = fields.size(); i > 0; --i) { // the highest bits first
            drawField(state, look, line, fieldAtBit(format, fields[i - 1].first), {x, corner.y});
            x += line.widthOf(fields[i - 1]) + line.gap;
        }
        ImGui::PopFont();
        ImGui::SetCursorScreenPos(corner);
        ImGui::Dummy({width, height});
    }
    ImGui::PopStyleVar();
}

} // namespace texplorer::ui
