#pragma once

// From the pixels of a TGA file to those of an Image, in the file's order.

#include "core/codec/tga/tga_format.h"
#include "core/image/texture_image.h"

#include <vector>

namespace texplorer::tga {

/// What becomes of the bits that could be alpha.
enum class AlphaRule : std::uint8_t {
    Absent, ///< there are none
    Ignore, ///< they mean nothing: 255 instead
    Straight,
    Premultiplied,
    Unknown,
};

struct AlphaReading {
    AlphaRule rule;
    /// Why they may be padding after all: "the descriptor says 0 attribute bits". Then Ignore takes the
    /// rule's place where all of them are 0. Empty: there is no doubt.
    std::string doubt;
};

[[nodiscard]] AlphaReading readAlpha(const Header& header, ByteView extension,
                                     std::vector<std::string>& notes);

/// What a picture's alpha means by a rule without doubt.
[[nodiscard]] AlphaMeaning meaningOf(AlphaRule rule, PixelFormat format);

/// Carries the rule out on a decoded picture.
[[nodiscard]] AlphaMeaning applyAlpha(const AlphaReading& reading, Image& image,
                                      std::vector<std::string>& notes);

/// For a header without fatal complaints.
[[nodiscard]] PixelFormat decodedFormat(const Header& header, AlphaRule rule);

/// The fewest bytes that hold the picture: a packet of 1 + pixelBytes gives 128 pixels at most.
[[nodiscard]] std::uint64_t leastDataBytes(const Header& header);

/// Reads raw or run-length coded pixels one after the other.
class PixelReader {
public:
    /// `map` and `data` must outlive the reader; of raw pixels `data` must hold all that will be read.
    PixelReader(const Header& header, PixelFormat format, ByteView map, ByteView data);

    /// The next `count` pixels, in `format`. False where the data ends before; then some are not written.
    [[nodiscard]] bool read(std::byte* to, std::size_t count);

    /// Adds a note where pixels named entries that the colour map doesn't have.
    void describeStrays(std::vector<std::string>& notes) const;

    /// A pixel of `format` in a register: its first component in the lowest eight bits.
    using Packed = std::uint32_t;

    struct ColorMap {
        std::vector<Packed> entries;
        std::size_t firstEntry = 0;
        std::size_t strays = 0; ///< pixels that named no entry
    };

private:
    using Read = bool (PixelReader::*)(std::byte* to, std::size_t count);

    // A Format says how many bytes a pixel takes here and there, and how one becomes the other.
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
        std::size_t pixels = 0; // that it still has
        bool isRun = false;
        Packed pixel = 0;           // of a run
        std::size_t straysEach = 0; // 1 where that pixel names no entry
    };
    Packet packet_;
};

} // namespace texplorer::tga
