#include "texplorer/codec/jpeg/jpeg_markers.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstring>

namespace texplorer {

namespace {

unsigned byteAt(ByteView bytes, std::size_t offset) {
    return offset < bytes.size() ? std::to_integer<unsigned>(bytes[offset]) : 0;
}

unsigned big16(ByteView bytes, std::size_t offset) {
    return byteAt(bytes, offset) << 8 | byteAt(bytes, offset + 1);
}

bool isRestart(unsigned marker) {
    return marker >= jpegRst0 && marker <= jpegRst7;
}

// Where the entropy-coded data ends that begins here: at the FF of the next marker that is no RSTn.
std::size_t endOfCodedData(ByteView file, std::size_t at) {
    while (at < file.size()) {
        const void* found = std::memchr(file.data() + at, 0xFF, file.size() - at);
        if (found == nullptr)
            return file.size();
        at = static_cast<std::size_t>(static_cast<const std::byte*>(found) - file.data());
        const unsigned next = byteAt(file, at + 1);
        if (at + 1 >= file.size())
            return file.size();
        if (next == 0xFF)
            ++at; // a fill byte
        else if (next == 0 || isRestart(next))
            at += 2;
        else
            return at;
    }
    return file.size();
}

} // namespace

bool JpegSegment::hasLength() const {
    return marker != jpegSoi && marker != jpegEoi && marker != 0x01 && !isRestart(marker);
}

bool JpegSegment::isFrame() const {
    return marker >= jpegSof0 && marker <= jpegSof15 && marker != jpegDht && marker != jpegJpg &&
           marker != jpegDac;
}

std::optional<JpegSegment> JpegSegments::next() {
    if (ended_)
        return std::nullopt;
    JpegSegment segment;
    std::size_t at = offset_;
    // A marker is an FF, or several, and a byte that is neither 00 nor FF.
    while (at + 1 < file_.size() &&
           (byteAt(file_, at) != 0xFF || byteAt(file_, at + 1) == 0 || byteAt(file_, at + 1) == 0xFF)) {
        segment.strayBytes += byteAt(file_, at) == 0xFF && byteAt(file_, at + 1) == 0xFF ? 0U : 1U;
        ++at;
    }
    if (at + 1 >= file_.size()) {
        ended_ = true;
        return std::nullopt;
    }
    segment.offset = at;
    segment.marker = static_cast<std::uint8_t>(byteAt(file_, at + 1));
    at += 2;
    if (segment.hasLength()) {
        const std::size_t said = big16(file_, at);
        segment.length = said < 2 ? 0 : said - 2;
        at = std::min(at + 2, file_.size());
        segment.payload = file_.subspan(at, std::min(segment.length, file_.size() - at));
        at += segment.payload.size();
    }
    if (segment.marker == jpegSos) {
        segment.codedBytes = endOfCodedData(file_, at) - at;
        at += segment.codedBytes;
    }
    ended_ = segment.marker == jpegEoi;
    offset_ = at;
    return segment;
}

std::uint64_t JpegFrame::blocks() const {
    std::uint64_t mostAcross = 1;
    std::uint64_t mostDown = 1;
    for (const JpegComponent& each : components) {
        mostAcross = std::max<std::uint64_t>(mostAcross, each.horizontal);
        mostDown = std::max<std::uint64_t>(mostDown, each.vertical);
    }
    const auto blocksAlong = [](std::uint64_t extent, std::uint64_t sampling, std::uint64_t most) {
        const std::uint64_t samples = (extent * sampling + most - 1) / most;
        return (samples + 7) / 8;
    };
    std::uint64_t sum = 0;
    for (const JpegComponent& each : components)
        sum += blocksAlong(width, each.horizontal, mostAcross) * blocksAlong(height, each.vertical, mostDown);
    return sum;
}

JpegFrame readJpegFrame(const JpegSegment& segment) {
    const ByteView data = segment.payload;
    JpegFrame frame;
    frame.marker = segment.marker;
    frame.precision = static_cast<std::uint8_t>(byteAt(data, 0));
    frame.height = big16(data, 1);
    frame.width = big16(data, 3);
    const std::size_t count = byteAt(data, 5);
    for (std::size_t at = 6; frame.components.size() < count && at + 3 <= data.size(); at += 3) {
        const unsigned sampling = byteAt(data, at + 1);
        frame.components.push_back(
            {static_cast<std::uint8_t>(byteAt(data, at)), static_cast<std::uint8_t>(sampling >> 4),
             static_cast<std::uint8_t>(sampling & 15), static_cast<std::uint8_t>(byteAt(data, at + 2))});
    }
    return frame;
}

// "Exif" 00 00, then TIFF: "II" or "MM", 42, the offset of the first directory; a directory has a count and
// entries of 12 bytes: tag, type, count, value. Orientation is tag 0x0112.
int exifOrientation(ByteView payload) {
    constexpr std::size_t head = 6;
    if (payload.size() < head + 8 || std::memcmp(payload.data(), "Exif\0", head) != 0)
        return 0;
    const ByteView tiff = payload.subspan(head);
    const bool little = byteAt(tiff, 0) == 'I';
    const auto number16 = [&](std::size_t at) {
        return little ? byteAt(tiff, at + 1) << 8 | byteAt(tiff, at) : big16(tiff, at);
    };
    const std::size_t directory = little ? number16(6) << 16 | number16(4) : number16(4) << 16 | number16(6);
    if (directory > tiff.size())
        return 0;
    const std::size_t entries = number16(directory);
    for (std::size_t i = 0; i < entries; ++i) {
        const std::size_t at = directory + 2 + 12 * i;
        if (at + 12 > tiff.size())
            return 0;
        if (number16(at) == 0x0112) {
            const unsigned value = number16(at + 8);
            return value >= 1 && value <= 8 ? static_cast<int>(value) : 0;
        }
    }
    return 0;
}

Sentence jpegMarkerName(std::uint8_t marker) {
    const auto numbered = [&](const char* name, unsigned first) {
        return fmt::format("{}{}", name, marker - first);
    };
    switch (marker) {
    case jpegSoi:
        return "SOI";
    case jpegEoi:
        return "EOI";
    case jpegSos:
        return "SOS";
    case jpegDqt:
        return "DQT";
    case jpegDri:
        return "DRI";
    case jpegDht:
        return "DHT";
    case jpegDac:
        return "DAC";
    case jpegJpg:
        return "JPG";
    case jpegCom:
        return "COM";
    default:
        break;
    }
    if (marker >= jpegApp0 && marker <= jpegApp15)
        return numbered("APP", jpegApp0);
    if (marker >= jpegSof0 && marker <= jpegSof15)
        return numbered("SOF", jpegSof0);
    if (isRestart(marker))
        return numbered("RST", jpegRst0);
    return Sentence("marker {0}", marker);
}

} // namespace texplorer
