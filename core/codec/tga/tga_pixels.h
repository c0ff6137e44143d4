#pragma once

// Converts the pixels of a TGA file to those of an Image, in the file's order.

#include "texplorer/base/sentence.h"
#include "texplorer/codec/tga/tga_format.h"
#include "texplorer/image/texture_image.h"

#include <vector>

namespace texplorer::tga {

/// How the bits that could be alpha are treated.
enum class AlphaRule : std::uint8_t {
    Absent, ///< there are no such bits
    Ignore, ///< meaningless: replaced by 255
    Straight,
    Premultiplied,
    Unknown,
};

struct AlphaReading {
    AlphaRule rule;
    /// Why the bits may be padding: "the descriptor says 0 attribute bits". In that case Ignore replaces the
    /// rule if all of them are 0. Empty: no doubt.
    Sentence doubt;
};

[[nodiscard]] AlphaReading readAlpha(const Header& header, ByteView extension, std::vector<Sentence>& notes);

/// The meaning of a picture's alpha under a rule without doubt.
[[nodiscard]] AlphaMeaning meaningOf(AlphaRule rule, PixelFormat format);

/// Applies the rule to a decoded picture.
[[nodiscard]] AlphaMeaning applyAlpha(const AlphaReading& reading, Image& image,
                                      std::vector<Sentence>& notes);

/// For a header without fatal errors.
[[nodiscard]] PixelFormat decodedFormat(const Header& header, AlphaRule rule);

/// The minimum number of bytes of the picture's data: a packet of 1 + pixelBytes gives at most 128 pixels.
[[nodiscard]] std::uint64_t minDataBytes(const Header& header);

/// Reads raw or run-length coded pixels in sequence.
class PixelReader {
public:
    /// `map` and `data` must outlive the reader; for raw pixels, `data` must hold all pixels that will be
    /// read.
    PixelReader(const Header& header, PixelFormat format, ByteView map, ByteView data);

    /// Reads the next `count` pixels in `format`. Returns false if the data ends before; some pixels are then
    /// not written.
    [[nodiscard]] bool read(std::byte* to, std::size_t count);

    /// Adds a note if pixels used entries that the colour map does not have.
    void describeStrays(std::vector<Sentence>& notes) const;

    /// A pixel of `format` as a number: its first component in the lowest eight bits.
    using Packed = std::uint32_t;

    struct ColorMap {
        std::vector<Packed> entries;
        std::size_t firstEntry = 0;
        std::size_t strays = 0; ///< pixels with a missing entry
    };

private:
    using Read = bool (PixelReader::*)(std::byte* to, std::size_t count);

    // A Format defines the bytes per pixel on both sides, and the conversion.
    template<class Format>
    [[nodiscard]] Read readerOf() const;
    template<class Format>
    [[nodiscard]] bool readRaw(std::byte* to, std::size_t count);
    template<class Format>
    [[nodiscard]] bool readPackets(std::byte* to, std::size_t count);
    [[nodiscard]] Read choose(const Header& header, PixelFormat format) const;

    const bool runLengthCoded_;
    ByteView rest_;
    ColorMap map_;
    Read read_;

    struct Packet {
        std::size_t pixels = 0; // left in the packet
        bool isRun = false;
        Packed pixel = 0;           // of a run
        std::size_t straysEach = 0; // 1 if the entry of that pixel is missing
    };
    Packet packet_;
};

} // namespace texplorer::tga
