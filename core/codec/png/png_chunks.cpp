#include "texplorer/codec/png/png_chunks.h"

#include <libdeflate.h>

namespace texplorer {

bool hasPngSignature(ByteView file) {
    return file.size() >= pngSignature.size() &&
           std::ranges::equal(file.first(pngSignature.size()), std::as_bytes(std::span(pngSignature)));
}

bool beginsWithPngHeader(ByteView file) {
    PngChunks chunks(file);
    const std::optional<PngChunk> first = chunks.next();
    return first && first->type == "IHDR" && first->length == 13;
}

std::uint32_t bigEndian32(ByteView bytes, std::size_t offset) {
    std::uint32_t value = 0;
    for (std::size_t i = offset; i < offset + 4; ++i)
        value = value << 8 | (i < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i]) : 0);
    return value;
}

std::uint64_t PngHeader::filteredBytes() const {
    constexpr std::array<std::uint64_t, 7> channels{1, 0, 3, 1, 2, 0, 4};
    const std::uint64_t bits = (colorType < channels.size() ? channels[colorType] : 0) * depth;
    const auto pass = [&](std::uint64_t columns, std::uint64_t rows) {
        return columns == 0 ? 0 : rows * (1 + (columns * bits + 7) / 8);
    };
    if (interlace != 1)
        return pass(width, height);

    struct Adam7 {
        std::uint64_t x, y, stepX, stepY;
    };
    constexpr std::array<Adam7, 7> passes{{
        {0, 0, 8, 8},
        {4, 0, 8, 8},
        {0, 4, 4, 8},
        {2, 0, 4, 4},
        {0, 2, 2, 4},
        {1, 0, 2, 2},
        {0, 1, 1, 2},
    }};
    std::uint64_t sum = 0;
    for (const Adam7& each : passes)
        sum += pass((width + each.stepX - 1 - each.x) / each.stepX,
                    (height + each.stepY - 1 - each.y) / each.stepY);
    return sum;
}

PngHeader readPngHeader(ByteView data) {
    const auto byte = [&](std::size_t offset) {
        return offset < data.size() ? std::to_integer<std::uint8_t>(data[offset]) : std::uint8_t{0};
    };
    return {bigEndian32(data, 0), bigEndian32(data, 4), byte(8), byte(9), byte(10), byte(11), byte(12)};
}

std::uint32_t pngCrc(const PngChunk& chunk) {
    const std::uint32_t ofType = libdeflate_crc32(0, chunk.type.data(), chunk.type.size());
    return libdeflate_crc32(ofType, chunk.data.data(), chunk.data.size());
}

std::optional<PngChunk> PngChunks::next() {
    const std::size_t left = file_.size() - offset_;
    if (left < 8)
        return std::nullopt;
    PngChunk chunk;
    chunk.offset = offset_;
    chunk.length = bigEndian32(file_, offset_);
    for (std::size_t i = 0; i < 4; ++i)
        chunk.type += std::to_integer<char>(file_[offset_ + 4 + i]);
    chunk.data = file_.subspan(offset_ + 8, std::min<std::size_t>(chunk.length, left - 8));
    if (left >= chunk.size())
        chunk.crc = bigEndian32(file_, offset_ + 8 + chunk.length);
    offset_ += static_cast<std::size_t>(std::min<std::uint64_t>(left, chunk.size()));
    return chunk;
}

} // namespace texplorer
