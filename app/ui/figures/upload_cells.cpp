// The bytes and the texels of the figure.

#include "app/ui/figures/plot.h"
#include "app/ui/figures/upload_figure.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/points.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_places.h"
#include "app/ui/widgets/wrapped_text.h"
#include "texplorer/image/convert.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace texplorer::ui {
namespace {

constexpr std::size_t maxLines = 512;
constexpr int maxTexels = 32; ///< of each side

/// The colour of a byte: its component's, as bright as the byte is large.
glm::vec3 colorOf(const HeldByte& held, int value) {
    const float light = 0.2F + 0.8F * static_cast<float>(value) / 255;
    switch (held.kind == HeldByte::Kind::Component ? held.component : ' ') {
    case 'r':
        return glm::vec3(0.95F, 0.22F, 0.18F) * light;
    case 'g':
        return glm::vec3(0.25F, 0.85F, 0.3F) * light;
    case 'b':
        return glm::vec3(0.28F, 0.45F, 1) * light;
    case 'a':
        return glm::vec3(0.85F, 0.6F, 0.95F) * light;
    default:
        return glm::vec3(1) * light;
    }
}

/// Which bytes of a row have room, and where: all of it, or its beginning and its end.
struct LineLook {
    float left;
    float cell;
    float gap;        ///< between the beginning and the end
    std::size_t head; ///< bytes
    std::size_t tail;
    std::size_t stride;

    [[nodiscard]] std::size_t count() const { return head + tail; }
    [[nodiscard]] std::size_t columnOf(std::size_t place) const {
        return place < head ? place : stride - tail + (place - head);
    }
    [[nodiscard]] float xOf(std::size_t place) const {
        return std::round(left + static_cast<float>(place) * cell + (place < head ? 0 : gap));
    }
};

LineLook lineLook(const UploadBytes& bytes, float left, float room) {
    const float em = ImGui::GetFontSize();
    const std::size_t stride = bytes.heldStride();
    const auto all = static_cast<float>(stride);
    if (all * em * 0.55F <= room)
        return {left, std::min(room / all, em * 1.7F), 0, stride, 0, stride};
    const float cell = std::floor(em * 0.75F);
    const float gap = em * 1.4F;
    const auto pixel = static_cast<std::size_t>(bytesPerPixel(bytes.held.pixels));
    const std::size_t padding = stride - pixel * static_cast<std::size_t>(bytes.extent.width);
    const auto count = static_cast<std::size_t>(std::max(0.0F, (room - gap) / cell));
    const std::size_t half = std::max(count / 2, padding + pixel);
    const std::size_t tail = (half - padding) / pixel * pixel + padding;
    const std::size_t head = std::max(pixel, (std::max(count, tail) - tail) / pixel * pixel);
    return {left, cell, gap, head, tail, stride};
}

struct MemoryDrawing {
    ImDrawList& draw;
    const UploadLook& look;
    const LineLook& line;
    float band; ///< height of what is above the cells
    float cell; ///< and of the cells

    void drawByte(ImVec2 low, std::size_t byte) const;
    void drawReader(ImVec2 low, std::size_t byte) const;
};

void MemoryDrawing::drawByte(ImVec2 low, std::size_t byte) const {
    const HeldByte held = heldByte(look.bytes, byte);
    const ImVec2 at = low + ImVec2(0, band);
    const float space = line.cell > 5 ? 1 : 0;
    const ImVec2 end = at + ImVec2(std::round(line.cell) - space, cell);
    const std::array corners{at, ImVec2(end.x, at.y), end, ImVec2(at.x, end.y)};
    const float em = ImGui::GetFontSize();
    if (held.kind == HeldByte::Kind::Beyond) {
        draw.AddRectFilled(at, end, color::shade);
        hatch(corners, em * 0.35F, color::problem, plotLine());
    } else if (held.kind == HeldByte::Kind::Padding) {
        draw.AddRectFilled(at, end, color::ground);
        hatch(corners, em * 0.35F, color::dim, plotLine() * 0.75F);
    } else {
        const int value = byte < look.memory->size() ? std::to_integer<int>((*look.memory)[byte]) : 0;
        const glm::vec3 tint = colorOf(held, value);
        draw.AddRectFilled(at, end, plotColor(tint));
        if (line.cell > em * 1.35F)
            plotText((at + end) * 0.5F, {0.5F, 0.5F}, fmt::format("{:02X}", value), inkOn(tint));
    }
}

/// A bracket over the bytes of each texel, alternately coloured by rows; the number of the row where it
/// begins.
void MemoryDrawing::drawReader(ImVec2 low, std::size_t byte) const {
    const std::optional<TexelPlace> texel = readerOf(look.bytes, byte);
    if (!texel)
        return;
    const ByteRange range = bytesOf(look.bytes.call, look.bytes.extent, texel->x, texel->y);
    const bool begins = byte == range.first;
    const bool ends = byte + 1 == range.end();
    const float thick = std::max(2.0F, plotLine() * 1.5F);
    const float y = low.y + band - thick * 1.5F;
    const ImU32 ink = texel->y % 2 == 0 ? ImU32{color::accent} : ImU32{color::text};
    const float inset = std::min(1.5F, line.cell / 4);
    const float from = low.x + (begins ? inset : 0);
    const float to = low.x + line.cell - (ends ? inset + 1 : 0);
    draw.AddLine({from, y}, {to, y}, ink, thick);
    if (begins && texel->x == 0) {
        draw.AddLine({low.x, low.y + 1}, {low.x, low.y + band + cell}, ink, thick);
        plotText({low.x + thick + 1, low.y - 1}, {0, 0}, std::to_string(texel->y), ink);
    }
}

/// The byte at a position in the window.
std::optional<std::size_t> byteAt(const LineLook& line, ImVec2 top, float height, ImVec2 at) {
    if (at.y < top.y)
        return std::nullopt;
    const auto row = static_cast<std::size_t>((at.y - top.y) / height);
    for (std::size_t place = 0; place < line.count(); ++place) {
        if (at.x >= line.xOf(place) && at.x < line.xOf(place) + line.cell)
            return row * line.stride + line.columnOf(place);
    }
    return std::nullopt;
}

ImU32 texelColor(const Image& image, int x, int y) {
    const std::array<std::uint8_t, 4> c = rgbaOf(image.format, image.at(x, y).data());
    return IM_COL32(c[0], c[1], c[2], 255);
}

/// The texel under the pointer, or the one that reads the byte there.
std::optional<TexelPlace> litTexel(const UploadMark& mark, const UploadBytes& bytes) {
    return mark.texel ? mark.texel : mark.byte ? readerOf(bytes, *mark.byte) : std::nullopt;
}

std::optional<ByteRange> litBytes(const UploadMark& mark, const UploadBytes& bytes) {
    if (const std::optional<TexelPlace> texel = litTexel(mark, bytes))
        return bytesOf(bytes.call, bytes.extent, texel->x, texel->y);
    return mark.byte ? std::optional(ByteRange{*mark.byte, 1}) : std::nullopt;
}

void frame(ImDrawList& draw, ImVec2 low, ImVec2 high) {
    const float thick = std::max(1.0F, plotLine());
    draw.AddRect(low - ImVec2(thick, thick), high + ImVec2(thick, thick), color::shade, 0, 0, 3 * thick);
    draw.AddRect(low - ImVec2(thick, thick), high + ImVec2(thick, thick), color::chosen, 0, 0, thick * 1.5F);
}

} // namespace

void drawUploadMemory(UploadFigureState& state, const UploadLook& look, ImVec2 size) {
    const float em = ImGui::GetFontSize();
    ImGui::BeginChild("memory", size);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 top = ImGui::GetCursorScreenPos();
    const float names = em * 2.2F;
    const LineLook line = lineLook(look.bytes, top.x + names, ImGui::GetContentRegionAvail().x - names - em);
    const float band = std::round(em * 1.05F);
    const float cell = std::round(em * 1.05F);
    const float height = band + cell + std::round(em * 0.25F);
    const std::size_t bytes = std::max(look.bytes.heldBytes(), look.memory->size());
    const std::size_t lines = std::min(maxLines, (bytes + line.stride - 1) / line.stride);
    const std::optional<ByteRange> lit = litBytes(state.hovered, look.bytes);
    const MemoryDrawing drawing{draw, look, line, band, cell};
    if (const auto wanted = std::exchange(state.scrollsTo, std::nullopt))
        ImGui::SetScrollY(static_cast<float>(*wanted / line.stride) * height - size.y / 3);
    const auto first = static_cast<std::size_t>(std::max(0.0F, ImGui::GetScrollY() / height));
    const auto shown = static_cast<std::size_t>(size.y / height) + 2;
    for (std::size_t row = first; row < std::min(lines, first + shown); ++row) {
        const float y = std::round(top.y + static_cast<float>(row) * height);
        const bool isHeld = std::cmp_less(row, look.bytes.extent.height);
        plotText({top.x + names - em * 0.5F, y + band + cell / 2}, {1, 0.5F},
                 isHeld ? std::to_string(row) : "+", isHeld ? ImU32{color::dim} : ImU32{color::problem});
        const bool hidesLit = lit && lit->first / line.stride == row &&
                              lit->first % line.stride >= line.head &&
                              lit->first % line.stride < line.stride - line.tail;
        if (line.tail > 0)
            plotText({line.xOf(line.head) - line.gap / 2, y + band + cell / 2}, {0.5F, 0.5F}, "…",
                     hidesLit ? color::chosen : color::dim);
        for (int layer = 0; layer < 3; ++layer) { // over the neighbours
            for (std::size_t place = 0; place < line.count(); ++place) {
                const std::size_t byte = row * line.stride + line.columnOf(place);
                if (byte >= bytes)
                    break;
                const ImVec2 low(line.xOf(place), y);
                const ImVec2 high(low.x + line.cell, y + band + cell);
                if (layer == 0)
                    drawing.drawByte(low, byte);
                else if (layer == 1)
                    drawing.drawReader(low, byte);
                else if (lit && byte >= lit->first && byte < lit->end())
                    frame(draw, low + ImVec2(0, band), {high.x - 1, high.y});
                if (layer == 0 && arePlacesWanted())
                    noteDrawn(fmt::format("upload:byte {}", byte), low + ImVec2(0, band), high);
            }
        }
    }
    ImGui::Dummy({1, static_cast<float>(lines) * height});
    if (ImGui::IsWindowHovered())
        state.hovering.byte = byteAt(line, top, height, ImGui::GetIO().MousePos);
    if (state.hovering.byte && *state.hovering.byte >= bytes)
        state.hovering.byte.reset();
    ImGui::EndChild();
}

void drawUploadTexels(UploadFigureState& state, const UploadLook& look, ImVec2 size) {
    const int wide = std::min(look.read->width, maxTexels);
    const int high = std::min(look.read->height, maxTexels);
    ImGui::BeginGroup();
    const bool isPart = wide < look.read->width || high < look.read->height;
    fittedText(isPart ? Sentence("The first {0} × {1} texels", wide, high)
                      : Sentence("The {0} × {1} texels", wide, high),
               color::dim);
    const float room = std::min(size.x / static_cast<float>(wide),
                                (size.y - ImGui::GetTextLineHeightWithSpacing()) / static_cast<float>(high));
    const float cell = std::clamp(std::floor(room), 1.0F, ImGui::GetFontSize() * 3);
    const ImVec2 low = rounded(ImGui::GetCursorScreenPos());
    const ImVec2 extent(cell * static_cast<float>(wide), cell * static_cast<float>(high));
    const auto placeOf = [&](TexelPlace texel) {
        const int row = look.topFirst ? texel.y : high - 1 - texel.y;
        return low + ImVec2(static_cast<float>(texel.x), static_cast<float>(row)) * cell;
    };
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float line = cell >= 5 ? 1 : 0;
    for (int y = 0; y < high; ++y) {
        for (int x = 0; x < wide; ++x) {
            const ImVec2 at = placeOf({x, y});
            const ImVec2 end = at + ImVec2(cell - line, cell - line);
            draw.AddRectFilled(at, end, texelColor(*look.read, x, y));
            if (arePlacesWanted())
                noteDrawn(fmt::format("upload:texel {} {}", x, y), at, end);
        }
    }
    const bool pressed =
        ImGui::InvisibleButton("texels", {std::max(extent.x, 1.0F), std::max(extent.y, 1.0F)});
    noteItem("upload:texels");
    if (ImGui::IsItemHovered()) {
        const ImVec2 at = (ImGui::GetIO().MousePos - low) * (1 / cell);
        const int row = std::clamp(static_cast<int>(at.y), 0, high - 1);
        state.hovering.texel =
            TexelPlace{std::clamp(static_cast<int>(at.x), 0, wide - 1), look.topFirst ? row : high - 1 - row};
    }
    if (pressed && state.hovering.texel)
        state.scrollsTo =
            bytesOf(look.bytes.call, look.bytes.extent, state.hovering.texel->x, state.hovering.texel->y)
                .first;
    const std::optional<TexelPlace> lit = litTexel(state.hovered, look.bytes);
    if (lit && lit->x < wide && lit->y < high)
        frame(draw, placeOf(*lit), placeOf(*lit) + ImVec2(cell - line, cell - line));
    ImGui::EndGroup();
}

} // namespace texplorer::ui
