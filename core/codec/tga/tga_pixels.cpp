#include "texplorer/codec/tga/tga_pixels.h"

#include "texplorer/base/sentence.h"
#include "texplorer/codec/common/swizzle.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <utility>

namespace texplorer::tga {

namespace {

using Packed = PixelReader::Packed;
using ColorMap = PixelReader::ColorMap;

constexpr Packed strayColor = 0xFF000000; // opaque black

Packed u8(std::byte byte) {
    return std::to_integer<Packed>(byte);
}

Packed u16(const std::byte* from) {
    return u8(from[0]) | u8(from[1]) << 8;
}

/// The same bytes in memory on every machine.
std::uint64_t littleEndian(std::uint64_t value) {
    return std::endian::native == std::endian::little ? value : __builtin_bswap64(value);
}

template<std::size_t Size>
void store(Packed pixel, std::byte* to) {
    const std::uint64_t bytes = littleEndian(pixel);
    std::memcpy(to, &bytes, Size);
}

// Five bits are worth v / 31 (OpenGL 2.1, section 3.6.4); of eight bits, the nearest value.
constexpr auto fiveBits = [] {
    std::array<Packed, 32> table{};
    for (Packed v = 0; v < table.size(); ++v)
        table[v] = (v * 255 * 2 + 31) / 62;
    return table;
}();

//   bit   15      14-10   9-5     4-0
//         alpha   red     green   blue
template<std::size_t To>
struct Color16 {
    static constexpr std::size_t from = 2;
    static constexpr std::size_t to = To;
    static Packed one(ColorMap&, const std::byte* in) {
        const Packed value = u16(in);
        const Packed color =
            fiveBits[value >> 10 & 31] | fiveBits[value >> 5 & 31] << 8 | fiveBits[value & 31] << 16;
        return value >> 15 != 0 ? color | 0xFF000000 : color;
    }
};

struct Color24 {
    static constexpr std::size_t from = 3;
    static constexpr std::size_t to = 3;
    static Packed one(ColorMap&, const std::byte* in) { return u8(in[2]) | u8(in[1]) << 8 | u8(in[0]) << 16; }
    static void many(const std::byte* in, std::byte* out, std::size_t count) { swapRedBlue(in, out, count); }
};

struct Color32 {
    static constexpr std::size_t from = 4;
    static constexpr std::size_t to = 4;
    static Packed one(ColorMap& map, const std::byte* in) { return Color24::one(map, in) | u8(in[3]) << 24; }
    static void many(const std::byte* in, std::byte* out, std::size_t count) {
        swapRedBlueAlpha(in, out, count);
    }
};

template<std::size_t Size>
struct Gray {
    static constexpr std::size_t from = Size;
    static constexpr std::size_t to = Size;
    static Packed one(ColorMap&, const std::byte* in) { return Size == 1 ? u8(in[0]) : u16(in); }
    static void many(const std::byte* in, std::byte* out, std::size_t count) {
        std::memcpy(out, in, count * Size);
    }
};

template<std::size_t From, std::size_t To>
struct Index {
    static constexpr std::size_t from = From;
    static constexpr std::size_t to = To;
    static Packed one(ColorMap& map, const std::byte* in) {
        // An index below the first wraps around to one far beyond the last.
        const std::size_t entry = std::size_t{From == 1 ? u8(in[0]) : u16(in)} - map.firstEntry;
        if (entry < map.entries.size())
            return map.entries[entry];
        ++map.strays;
        return strayColor;
    }
};

template<class Format>
void convert(ColorMap& map, const std::byte* in, std::byte* out, std::size_t count) {
    if constexpr (requires { Format::many(in, out, count); }) {
        Format::many(in, out, count);
    } else {
        for (; count > 0; --count, in += Format::from, out += Format::to)
            store<Format::to>(Format::one(map, in), out);
    }
}

template<class Format>
std::vector<Packed> readEntries(ByteView bytes) {
    ColorMap none;
    std::vector<Packed> entries(bytes.size() / Format::from);
    for (std::size_t i = 0; i < entries.size(); ++i)
        entries[i] = Format::one(none, bytes.data() + i * Format::from);
    return entries;
}

ColorMap readMap(const Header& header, ByteView bytes) {
    if (!header.mapped())
        return {};
    return {header.entryBits == 24   ? readEntries<Color24>(bytes)
            : header.entryBits == 32 ? readEntries<Color32>(bytes)
                                     : readEntries<Color16<4>>(bytes),
            header.firstEntry, 0};
}

// An array would be put together in memory, and its load would wait for the two stores.
using Block [[gnu::vector_size(16)]] = std::uint64_t;

/// Sixteen bytes full of a pixel, in memory's order.
template<std::size_t Size>
Block repeated(Packed pixel) {
    const std::uint64_t p = pixel;
    if constexpr (Size == 3) {
        const std::uint64_t c = p & 0xFFFFFF;
        return Block{littleEndian(c | c << 24 | c << 48), littleEndian(c >> 16 | c << 8 | c << 32 | c << 56)};
    } else {
        constexpr std::uint64_t ones = Size == 1   ? 0x0101010101010101
                                       : Size == 2 ? 0x0001000100010001
                                                   : 0x0000000100000001;
        return Block{littleEndian(p * ones), littleEndian(p * ones)};
    }
}

// `room`: how many bytes may be written from `to` on, if pixels that follow are written later.
template<std::size_t Size>
void fill(Packed pixel, std::byte* to, std::size_t count, std::size_t room) {
    const Block block = repeated<Size>(pixel);
    constexpr std::size_t step =
        16 / Size * Size; // whole pixels only: of three bytes, five and a byte too much
    constexpr std::size_t stores = 13;
    std::byte* const end = to + count * Size;
    if (room >= count * Size + stores * sizeof block) {
        // Runs of most lengths take the same path: a wrong guess of the processor costs more than the stores.
        do {
            for (std::size_t i = 0; i < stores; ++i)
                std::memcpy(to + i * step, &block, sizeof block);
            to += stores * step;
        } while (to < end);
        return;
    }
    for (; static_cast<std::size_t>(end - to) >= sizeof block; to += step)
        std::memcpy(to, &block, sizeof block);
    std::memcpy(to, &block, static_cast<std::size_t>(end - to));
}

} // namespace

AlphaReading readAlpha(const Header& header, ByteView extension, std::vector<Sentence>& notes) {
    if (header.alphaBits() == 0)
        return {AlphaRule::Absent, {}};
    // The one bit of a 16-bit colour has different meanings in different programs; most leave it 0 without
    // a meaning.
    const char* meaningless =
        header.alphaBits() == 1 ? N_("the meaning of the attribute bit is not specified") : "";
    if (!extension.empty()) {
        switch (const auto type = std::to_integer<int>(extension[attributesTypeOffset])) {
        case 0:
            if (header.attributeBits() == 0)
                return {AlphaRule::Ignore, {}};
            return {AlphaRule::Unknown,
                    Sentence("the extension area says no alpha, the descriptor {0}",
                             Sentence::plural("{0} bit", "{0} bits", header.attributeBits()))};
        case 1:
            return {AlphaRule::Ignore, {}};
        case 2:
            return {AlphaRule::Unknown, meaningless};
        case 3:
            return {AlphaRule::Straight, {}};
        case 4:
            return {AlphaRule::Premultiplied, {}};
        default:
            notes.push_back(
                Sentence("the extension area's attributes type is {0}, expected 0 to 4: ignored", type));
        }
    }
    if (header.attributeBits() != 0)
        return {AlphaRule::Straight, meaningless};
    if (header.alphaBits() == 1)
        return {AlphaRule::Ignore, {}};
    return {AlphaRule::Unknown, N_("the descriptor has 0 attribute bits")};
}

AlphaMeaning meaningOf(AlphaRule rule, PixelFormat format) {
    if (format != PixelFormat::Rgba8 && format != PixelFormat::LuminanceAlpha8)
        return AlphaMeaning::None;
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

AlphaMeaning applyAlpha(const AlphaReading& reading, Image& image, std::vector<Sentence>& notes) {
    const auto size = static_cast<std::size_t>(bytesPerPixel(image.format));
    if (image.format != PixelFormat::Rgba8 && image.format != PixelFormat::LuminanceAlpha8)
        return AlphaMeaning::None;
    AlphaRule rule = reading.rule;
    if (!reading.doubt.empty()) {
        bool allZero = true;
        for (std::size_t i = size - 1; i < image.pixels.size(); i += size)
            allZero = allZero && image.pixels[i] == std::byte{0};
        if (allZero) {
            rule = AlphaRule::Ignore;
            notes.push_back(Sentence("{0}, and every alpha is 0: ignored", reading.doubt));
        } else if (rule == AlphaRule::Unknown) {
            notes.push_back(Sentence("{0}, but not every alpha is 0: kept", reading.doubt));
        }
    }
    if (rule == AlphaRule::Ignore)
        for (std::size_t i = size - 1; i < image.pixels.size(); i += size)
            image.pixels[i] = std::byte{255};
    return meaningOf(rule, image.format);
}

PixelFormat decodedFormat(const Header& header, AlphaRule rule) {
    if (header.gray())
        return header.alphaBits() == 0 ? PixelFormat::Luminance8 : PixelFormat::LuminanceAlpha8;
    const bool hasAlpha = header.alphaBits() == 8 || (header.alphaBits() == 1 && rule != AlphaRule::Ignore);
    return hasAlpha ? PixelFormat::Rgba8 : PixelFormat::Rgb8;
}

std::uint64_t minDataBytes(const Header& header) {
    const std::uint64_t pixels = header.pixelCount();
    return header.runLengthCoded() ? (pixels + 127) / 128 * (1 + header.pixelBytes())
                                   : pixels * header.pixelBytes();
}

PixelReader::PixelReader(const Header& header, PixelFormat format, ByteView map, ByteView data)
    : runLengthCoded_(header.runLengthCoded())
    , rest_(data)
    , map_(readMap(header, map))
    , read_(choose(header, format)) {}

PixelReader::Read PixelReader::choose(const Header& header, PixelFormat format) const {
    const bool four = format == PixelFormat::Rgba8;
    if (header.gray())
        return header.pixelBytes() == 1 ? readerOf<Gray<1>>() : readerOf<Gray<2>>();
    if (header.mapped() && header.pixelBytes() == 1)
        return four ? readerOf<Index<1, 4>>() : readerOf<Index<1, 3>>();
    if (header.mapped())
        return four ? readerOf<Index<2, 4>>() : readerOf<Index<2, 3>>();
    switch (header.pixelBytes()) {
    case 4:
        return readerOf<Color32>();
    case 3:
        return readerOf<Color24>();
    default:
        return four ? readerOf<Color16<4>>() : readerOf<Color16<3>>();
    }
}

template<class Format>
PixelReader::Read PixelReader::readerOf() const {
    return runLengthCoded_ ? &PixelReader::readPackets<Format> : &PixelReader::readRaw<Format>;
}

bool PixelReader::read(std::byte* to, std::size_t count) {
    return (this->*read_)(to, count);
}

template<class Format>
bool PixelReader::readRaw(std::byte* to, std::size_t count) {
    if (rest_.size() / Format::from < count)
        return false;
    convert<Format>(map_, rest_.data(), to, count);
    rest_ = rest_.subspan(count * Format::from);
    return true;
}

//   bit   7            6-0           then
//         1: a run     pixels - 1    one pixel, to be repeated
//         0: raw       pixels - 1    as many pixels
//
// A single raw pixel is treated as a run of one, so that these two need not be told apart. Members are copied
// into local variables, because the compiler can't know that the pixels don't overwrite them.
template<class Format>
bool PixelReader::readPackets(std::byte* to, std::size_t count) {
    const std::byte* in = rest_.data();
    const std::byte* const end = in + rest_.size();
    Packet packet = packet_;
    while (count > 0) {
        if (packet.pixels == 0) {
            if (static_cast<std::size_t>(end - in) < 1 + Format::from)
                return false;
            const auto head = std::to_integer<unsigned>(*in++);
            packet.pixels = (head & 127) + 1;
            packet.isRun = head >= 128 || head == 0;
            if (packet.isRun) {
                const std::size_t strays = std::exchange(map_.strays, 0);
                packet.pixel = Format::one(map_, in);
                packet.straysEach = std::exchange(map_.strays, strays);
                in += Format::from;
            }
        }
        const std::size_t pixels = std::min(packet.pixels, count);
        if (packet.isRun) {
            fill<Format::to>(packet.pixel, to, pixels, count * Format::to);
            map_.strays += packet.straysEach * pixels;
        } else {
            if (static_cast<std::size_t>(end - in) < pixels * Format::from)
                return false;
            convert<Format>(map_, in, to, pixels);
            in += pixels * Format::from;
        }
        packet.pixels -= pixels;
        count -= pixels;
        to += pixels * Format::to;
    }
    rest_ = {in, end};
    packet_ = packet;
    return true;
}

void PixelReader::describeStrays(std::vector<Sentence>& notes) const {
    if (map_.strays > 0) {
        const std::size_t last = map_.firstEntry + map_.entries.size() - 1;
        notes.push_back(
            map_.strays == 1
                ? Sentence("1 pixel is outside the colour map ({0} to {1}): black", map_.firstEntry, last)
                : Sentence("{0} pixels are outside the colour map ({1} to {2}): black", map_.strays,
                           map_.firstEntry, last));
    }
}

} // namespace texplorer::tga
