#include "core/codec/tga_pixels.h"

#include "core/codec/swizzle.h"

#include <algorithm>
#include <cstring>

namespace texplorer::tga {

namespace {

using Color = PixelReader::Color;
using ColorMap = PixelReader::ColorMap;

// Five bits are worth v / 31 (OpenGL 2.1, section 3.6.4); of eight bits, the nearest value.
constexpr auto fiveBits = [] {
    std::array<std::byte, 32> table{};
    for (unsigned v = 0; v < table.size(); ++v)
        table[v] = static_cast<std::byte>((v * 255 * 2 + 31) / 62);
    return table;
}();

//   bit   15      14-10   9-5     4-0
//         alpha   red     green   blue
template<bool WithAlpha>
void convert16(ColorMap&, const std::byte* from, std::byte* to, std::size_t count) {
    for (; count > 0; --count, from += 2, to += WithAlpha ? 4 : 3) {
        const unsigned value = std::to_integer<unsigned>(from[0]) | std::to_integer<unsigned>(from[1]) << 8;
        to[0] = fiveBits[value >> 10 & 31];
        to[1] = fiveBits[value >> 5 & 31];
        to[2] = fiveBits[value & 31];
        if constexpr (WithAlpha)
            to[3] = static_cast<std::byte>(value >> 15 != 0 ? 255 : 0);
    }
}

template<std::size_t Size>
void convertNothing(ColorMap&, const std::byte* from, std::byte* to, std::size_t count) {
    std::memcpy(to, from, count * Size);
}

void convert24(ColorMap&, const std::byte* from, std::byte* to, std::size_t count) {
    swapRedBlue(from, to, count);
}

void convert32(ColorMap&, const std::byte* from, std::byte* to, std::size_t count) {
    swapRedBlueAlpha(from, to, count);
}

template<std::size_t IndexBytes, std::size_t Size>
void convertIndex(ColorMap& map, const std::byte* from, std::byte* to, std::size_t count) {
    for (; count > 0; --count, from += IndexBytes, to += Size) {
        std::size_t index = std::to_integer<std::size_t>(from[0]);
        if constexpr (IndexBytes == 2)
            index |= std::to_integer<std::size_t>(from[1]) << 8;
        index -= map.firstEntry; // below it: wraps around to far beyond the last
        const bool stray = index >= map.entries.size();
        std::memcpy(to, stray ? map.stray.data() : map.entries[index].data(), Size);
        map.strays += stray ? 1 : 0;
    }
}

PixelReader::Convert colorConversion(int bits, PixelFormat format) {
    if (bits == 24)
        return convert24;
    if (bits == 32)
        return convert32;
    return format == PixelFormat::Rgba8 ? convert16<true> : convert16<false>;
}

PixelReader::Convert conversion(const Header& header, PixelFormat format) {
    if (header.gray())
        return header.pixelBits == 8 ? convertNothing<1> : convertNothing<2>;
    if (!header.mapped())
        return colorConversion(header.pixelBits, format);
    if (format == PixelFormat::Rgba8)
        return header.pixelBytes() == 1 ? convertIndex<1, 4> : convertIndex<2, 4>;
    return header.pixelBytes() == 1 ? convertIndex<1, 3> : convertIndex<2, 3>;
}

ColorMap readMap(const Header& header, PixelFormat format, ByteView bytes) {
    ColorMap map;
    if (!header.mapped())
        return map;
    const PixelReader::Convert convert = colorConversion(header.entryBits, format);
    map.entries.resize(bytes.size() / header.entryBytes());
    for (std::size_t i = 0; i < map.entries.size(); ++i)
        convert(map, bytes.data() + i * header.entryBytes(), map.entries[i].data(), 1);
    map.firstEntry = header.firstEntry;
    map.stray[3] = std::byte{255};
    return map;
}

template<std::size_t Size>
void repeat(const std::byte* pixel, std::byte* to, std::size_t count) {
    // As many whole pixels as fit into 16 bytes are stored at once; the step is theirs alone, so that where
    // 16 is no multiple of Size the next store begins within the last.
    constexpr std::size_t together = 16 / Size;
    std::array<std::byte, 16> block{};
    for (std::size_t i = 0; i < block.size(); ++i)
        block[i] = pixel[i % Size];
    std::byte* const end = to + count * Size;
    for (; to + block.size() <= end; to += together * Size)
        std::memcpy(to, block.data(), block.size());
    std::memcpy(to, block.data(), static_cast<std::size_t>(end - to));
}

void repeatPixel(const std::byte* pixel, std::size_t size, std::byte* to, std::size_t count) {
    switch (size) {
    case 1:
        std::memset(to, std::to_integer<int>(*pixel), count);
        break;
    case 2:
        repeat<2>(pixel, to, count);
        break;
    case 3:
        repeat<3>(pixel, to, count);
        break;
    default:
        repeat<4>(pixel, to, count);
    }
}

} // namespace

AlphaRule alphaRule(const Header& header, ByteView extension, std::vector<std::string>& notes) {
    if (header.alphaBits() == 0)
        return AlphaRule::Absent;
    if (!extension.empty()) {
        switch (const auto type = std::to_integer<int>(extension[attributesTypeOffset])) {
        case 0:
            if (header.attributeBits() == 0)
                return AlphaRule::Ignore;
            notes.push_back("the extension area says that there is no alpha, the descriptor says " +
                            std::to_string(header.attributeBits()) + " bits: kept");
            return AlphaRule::Unknown;
        case 1:
            return AlphaRule::Ignore;
        case 2:
            return AlphaRule::Unknown;
        case 3:
            return AlphaRule::Straight;
        case 4:
            return AlphaRule::Premultiplied;
        default:
            notes.push_back("the extension area's attributes type is " + std::to_string(type) +
                            ", 0 to 4 are known: ignored");
        }
    }
    if (header.attributeBits() != 0)
        return AlphaRule::Straight;
    return header.alphaBits() == 1 ? AlphaRule::Ignore : AlphaRule::Guess;
}

AlphaMeaning applyAlphaRule(AlphaRule rule, Image& image, std::vector<std::string>& notes) {
    const auto size = static_cast<std::size_t>(bytesPerPixel(image.format));
    if (image.format != PixelFormat::Rgba8 && image.format != PixelFormat::LuminanceAlpha8)
        return AlphaMeaning::None;
    if (rule == AlphaRule::Guess) {
        rule = AlphaRule::Ignore;
        for (std::size_t i = size - 1; i < image.pixels.size(); i += size)
            if (image.pixels[i] != std::byte{0})
                rule = AlphaRule::Unknown;
        notes.emplace_back(rule == AlphaRule::Ignore
                               ? "the descriptor says 0 attribute bits, and every alpha is 0: ignored"
                               : "the descriptor says 0 attribute bits, but not every alpha is 0: kept");
    }
    if (rule == AlphaRule::Ignore)
        for (std::size_t i = size - 1; i < image.pixels.size(); i += size)
            image.pixels[i] = std::byte{255};
    switch (rule) {
    case AlphaRule::Straight:
        return AlphaMeaning::Straight;
    case AlphaRule::Premultiplied:
        return AlphaMeaning::Premultiplied;
    case AlphaRule::Unknown:
        return AlphaMeaning::Unknown;
    default:
        return AlphaMeaning::None;
    }
}

PixelFormat decodedFormat(const Header& header, AlphaRule rule) {
    if (header.gray())
        return header.alphaBits() == 0 ? PixelFormat::Luminance8 : PixelFormat::LuminanceAlpha8;
    const bool hasAlpha = header.alphaBits() == 8 || (header.alphaBits() == 1 && rule != AlphaRule::Ignore);
    return hasAlpha ? PixelFormat::Rgba8 : PixelFormat::Rgb8;
}

std::size_t leastDataBytes(const Header& header) {
    const std::size_t pixels = header.pixelCount();
    return header.runLengthCoded() ? (pixels + 127) / 128 * (1 + header.pixelBytes())
                                   : pixels * header.pixelBytes();
}

PixelReader::PixelReader(const Header& header, PixelFormat format, ByteView map, ByteView data)
    : runLengthCoded_(header.runLengthCoded())
    , fromBytes_(header.pixelBytes())
    , toBytes_(static_cast<std::size_t>(bytesPerPixel(format)))
    , rest_(data)
    , map_(readMap(header, format, map))
    , convert_(conversion(header, format)) {}

bool PixelReader::read(std::byte* to, std::size_t count) {
    if (runLengthCoded_)
        return readPackets(to, count);
    if (rest_.size() / fromBytes_ < count)
        return false;
    convert_(map_, rest_.data(), to, count);
    rest_ = rest_.subspan(count * fromBytes_);
    return true;
}

//   bit   7            6-0           then
//         1: a run     pixels - 1    one pixel, to be repeated
//         0: raw       pixels - 1    as many pixels
bool PixelReader::beginPacket() {
    if (rest_.empty())
        return false;
    const auto head = std::to_integer<unsigned>(rest_[0]);
    inPacket_ = (head & 127) + 1;
    isRun_ = head >= 128;
    rest_ = rest_.subspan(1);
    if (!isRun_)
        return true;
    if (rest_.size() < fromBytes_)
        return false;
    const std::size_t strays = map_.strays;
    convert_(map_, rest_.data(), run_.data(), 1);
    runIsStray_ = map_.strays != strays;
    map_.strays = strays;
    rest_ = rest_.subspan(fromBytes_);
    return true;
}

bool PixelReader::readPackets(std::byte* to, std::size_t count) {
    while (count > 0) {
        if (inPacket_ == 0 && !beginPacket())
            return false;
        const std::size_t pixels = std::min(inPacket_, count);
        if (isRun_) {
            repeatPixel(run_.data(), toBytes_, to, pixels);
            map_.strays += runIsStray_ ? pixels : 0;
        } else {
            if (rest_.size() < pixels * fromBytes_)
                return false;
            convert_(map_, rest_.data(), to, pixels);
            rest_ = rest_.subspan(pixels * fromBytes_);
        }
        inPacket_ -= pixels;
        count -= pixels;
        to += pixels * toBytes_;
    }
    return true;
}

void PixelReader::describeStrays(std::vector<std::string>& notes) const {
    if (map_.strays > 0)
        notes.push_back(std::to_string(map_.strays) + (map_.strays == 1 ? " pixel names" : " pixels name") +
                        " no entry of the colour map (" + std::to_string(map_.firstEntry) + " to " +
                        std::to_string(map_.firstEntry + map_.entries.size() - 1) + "): black");
}

} // namespace texplorer::tga
