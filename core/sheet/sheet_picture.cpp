#include "texplorer/sheet/sheet_picture.h"

#include "texplorer/sheet/label_text.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace texplorer::sheet {
namespace {

// Contrasts on the ground, as WCAG 2.1 has them: 16.6, 7.2, and 8.1 of what went wrong on its own ground.
constexpr Ink ground{251, 251, 250};
constexpr Ink strongInk{27, 27, 30};
constexpr Ink dimInk{85, 85, 90};
constexpr Ink frameColor{200, 200, 200};
constexpr Ink refusalGround{243, 234, 232};
constexpr Ink refusalInk{140, 24, 20};
constexpr int refusalMargin = 6;

Ink inkOf(TextRole role) {
    return role == TextRole::Note ? dimInk : strongInk;
}

void putColor(std::span<std::byte> pixel, Ink color) {
    for (std::size_t i = 0; i < color.size(); ++i)
        pixel[i] = static_cast<std::byte>(color[i]);
}

} // namespace

SheetPicture::SheetPicture(Layout layout)
    : layout_(std::move(layout))
    , image_(Image::uninitialised(PixelFormat::Rgb8, layout_.size.x, layout_.size.y))
    , notes_(layout_.cells.size())
    , refusals_(layout_.cells.size()) {
    fill({0, 0, image_.width, image_.height}, ground);
    for (const PixelRect& cell : layout_.cells)
        frame(cell);
}

void SheetPicture::fill(const PixelRect& rect, Ink color) {
    for (int y = rect.y; y < rect.y + rect.height; ++y) {
        for (int x = rect.x; x < rect.x + rect.width; ++x)
            putColor(image_.at(x, image_.height - 1 - y), color);
    }
}

/// Just outside of it.
void SheetPicture::frame(const PixelRect& rect) {
    fill({rect.x - 1, rect.y - 1, rect.width + 2, 1}, frameColor);
    fill({rect.x - 1, rect.y + rect.height, rect.width + 2, 1}, frameColor);
    fill({rect.x - 1, rect.y, 1, rect.height}, frameColor);
    fill({rect.x + rect.width, rect.y, 1, rect.height}, frameColor);
}

void SheetPicture::put(std::size_t cell, const Image& picture) {
    const PixelRect& rect = layout_.cells[cell];
    assert(picture.format == PixelFormat::Rgba8 && picture.width == rect.width &&
           picture.height == rect.height);
    const int bottom = image_.height - rect.y - rect.height; // rows of images begin at the bottom
    for (int y = 0; y < rect.height; ++y) {
        const std::byte* from = picture.pixels.data() + picture.offset(0, y, 0);
        std::byte* to = image_.pixels.data() + image_.offset(rect.x, bottom + y, 0);
        for (int x = 0; x < rect.width; ++x, from += 4, to += 3)
            std::copy_n(from, 3, to);
    }
}

void SheetPicture::refuse(std::size_t cell, std::string words) {
    refusals_[cell] = std::move(words);
}

void SheetPicture::note(std::size_t cell, std::string words) {
    notes_[cell] = std::move(words);
}

void SheetPicture::writeRefusal(const Lettering& lettering, const PixelRect& cell, const std::string& words) {
    fill(cell, refusalGround);
    const int line = lettering.lineHeight(TextRole::Note);
    const int room = cell.width - 2 * refusalMargin;
    const int lines = (cell.height - 2 * refusalMargin) / line;
    const auto measure = [&](std::string_view text) { return lettering.width(TextRole::Note, text); };
    if (lines < 1 || room < measure("…"))
        return;
    int top = cell.y + refusalMargin;
    for (const std::string& each : labelLines(words, room, static_cast<std::size_t>(lines), measure)) {
        lettering.draw(image_, cell.x + refusalMargin, top, TextRole::Note, each, refusalInk);
        top += line;
    }
}

Image SheetPicture::take(const Lettering& lettering) && {
    for (const Line& line : layout_.lines)
        lettering.draw(image_, line.left, line.top, line.role, line.text, inkOf(line.role));
    const auto measure = [&](std::string_view text) { return lettering.width(TextRole::Note, text); };
    for (std::size_t i = 0; i < layout_.cells.size(); ++i) {
        if (!refusals_[i].empty())
            writeRefusal(lettering, layout_.cells[i], refusals_[i]);
        if (notes_[i].empty() || layout_.notes.empty())
            continue;
        const PixelRect& room = layout_.notes[i];
        const std::string words = shortenedMiddle(notes_[i], room.width, measure);
        lettering.draw(image_, room.x + std::max(0, room.width - measure(words)) / 2, room.y, TextRole::Note,
                       words, dimInk);
    }
    return std::move(image_);
}

} // namespace texplorer::sheet
