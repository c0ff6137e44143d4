#include "texplorer/codec/bmp/bmp_palette.h"

#include <algorithm>
#include <cstring>

namespace texplorer::bmp {

Palette::Palette(ByteView file, const Header& header)
    : entries_(header.paletteEntries)
    , complete_(entries_ == std::size_t{1} << header.bitsPerPixel) {
    bool ramp = entries_ == 256;
    for (std::size_t i = 0; i < entries_; ++i) {
        const ByteView entry = partOf(file, header.palettePos + i * header.paletteEntryBytes, 3);
        colors_[i] = {entry[2], entry[1], entry[0], std::byte{0}};
        const auto grey = static_cast<std::byte>(i);
        ramp = ramp && entry[0] == grey && entry[1] == grey && entry[2] == grey;
    }
    greyRamp_ = ramp;
}

void Palette::paint(ByteView indices, std::byte* to) {
    if (indices.empty())
        return;
    if (greyRamp_) {
        std::memcpy(to, indices.data(), indices.size());
        return;
    }
    if (!complete_)
        highest_ = std::max(highest_, std::to_integer<std::size_t>(*std::ranges::max_element(indices)));
    // Four bytes a pixel are one store; the fourth is the next pixel's first, so the last pixel has three.
    const std::size_t last = indices.size() - 1;
    for (std::size_t x = 0; x < last; ++x, to += 3)
        std::memcpy(to, colors_[std::to_integer<std::size_t>(indices[x])].data(), 4);
    std::memcpy(to, colors_[std::to_integer<std::size_t>(indices[last])].data(), 3);
}

} // namespace texplorer::bmp
