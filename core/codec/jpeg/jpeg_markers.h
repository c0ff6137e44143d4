#pragma once

// The structure of a JPEG file (ITU-T T.81, annex B), read without decoding: the decoder checks it before it
// allocates memory, and the anatomy shows it.
//
//   FF marker   length (2, itself included)   payload        all numbers big-endian
//
// SOI, EOI and RSTn have no length. The payload of SOS is followed by the entropy-coded data, in which FF is
// followed by 00 or RSTn.

#include "texplorer/base/bytes.h"
#include "texplorer/base/sentence.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace texplorer {

enum JpegMarker : std::uint8_t {
    jpegSof0 = 0xC0,
    jpegDht = 0xC4,
    jpegJpg = 0xC8,
    jpegDac = 0xCC,
    jpegSof15 = 0xCF,
    jpegRst0 = 0xD0,
    jpegRst7 = 0xD7,
    jpegSoi = 0xD8,
    jpegEoi = 0xD9,
    jpegSos = 0xDA,
    jpegDqt = 0xDB,
    jpegDri = 0xDD,
    jpegApp0 = 0xE0,
    jpegApp1 = 0xE1,
    jpegApp2 = 0xE2,
    jpegApp14 = 0xEE,
    jpegApp15 = 0xEF,
    jpegCom = 0xFE,
};

struct JpegSegment {
    std::size_t offset = 0; ///< of the FF before the marker
    std::uint8_t marker = 0;
    std::size_t length = 0;     ///< of the payload, as the file says
    ByteView payload;           ///< shorter where the file ends
    std::size_t codedBytes = 0; ///< SOS: bytes of entropy-coded data after it
    std::size_t strayBytes = 0; ///< unknown bytes before it

    [[nodiscard]] bool hasLength() const;
    [[nodiscard]] std::size_t size() const { return 2 + (hasLength() ? 2 + length : 0); }
    [[nodiscard]] bool complete() const { return payload.size() == length; }
    [[nodiscard]] bool isFrame() const; ///< SOF0 … SOF15
};

/// Iterates over the segments of a file, from SOI on.
class JpegSegments {
public:
    explicit JpegSegments(ByteView file)
        : file_(file) {}

    /// Returns the next segment. Empty after EOI and if no further marker follows.
    [[nodiscard]] std::optional<JpegSegment> next();
    [[nodiscard]] std::size_t offset() const { return offset_; } ///< after the last segment and its data

private:
    ByteView file_;
    std::size_t offset_ = 0;
    bool ended_ = false;
};

struct JpegComponent {
    std::uint8_t id = 0;
    std::uint8_t horizontal = 0; ///< sampling factors, 1 … 4
    std::uint8_t vertical = 0;
    std::uint8_t quantization = 0;
};

struct JpegFrame {
    std::uint8_t marker = 0;
    std::uint8_t precision = 0;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<JpegComponent> components; ///< those in the segment

    [[nodiscard]] bool arithmetic() const { return marker >= 0xC9; }
    /// The blocks of 8 x 8 samples of all components.
    [[nodiscard]] std::uint64_t blocks() const;
};

[[nodiscard]] JpegFrame readJpegFrame(const JpegSegment& segment);

/// Returns Exif's orientation (1 … 8) in an APP1 segment, or 0.
[[nodiscard]] int exifOrientation(ByteView payload);

/// "SOF2", "APP1", "DQT"
[[nodiscard]] Sentence jpegMarkerName(std::uint8_t marker);

} // namespace texplorer
