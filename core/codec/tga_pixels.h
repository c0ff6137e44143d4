#pragma once

// From the pixels of a TGA file to those of an Image, in the file's order.

#include "core/codec/tga_format.h"
#include "core/image/texture_image.h"

#include <array>
#include <vector>

namespace texplorer::tga {

/// What becomes of the bits that could be alpha.
enum class AlphaRule : std::uint8_t {
    Absent, ///< there are none
    Ignore, ///< they mean nothing: 255 instead
    Straight,
    Premultiplied,
    Unknown,
    Guess, ///< nobody says: padding if they are all 0, else Unknown
};

[[nodiscard]] AlphaRule alphaRule(const Header& header, ByteView extension, std::vector<std::string>& notes);

/// Carries the rule out on a decoded picture.
[[nodiscard]] AlphaMeaning applyAlphaRule(AlphaRule rule, Image& image, std::vector<std::string>& notes);

/// For a header without fatal complaints.
[[nodiscard]] PixelFormat decodedFormat(const Header& header, AlphaRule rule);

/// The fewest bytes that hold the picture: a packet of 1 + pixelBytes gives 128 pixels at most.
[[nodiscard]] std::size_t leastDataBytes(const Header& header);

/// Reads raw or run-length coded pixels one after the other.
class PixelReader {
public:
    /// `map` and `data` must outlive the reader; of raw pixels `data` must hold all that will be read.
    PixelReader(const Header& header, PixelFormat format, ByteView map, ByteView data);

    /// The next `count` pixels, in `format`. False where the data ends before; then some are not written.
    [[nodiscard]] bool read(std::byte* to, std::size_t count);

    /// Adds a note where pixels named entries that the colour map doesn't have.
    void describeStrays(std::vector<std::string>& notes) const;

    using Color = std::array<std::byte, 4>;
    struct ColorMap {
        std::vector<Color> entries;
        std::size_t firstEntry = 0;
        Color stray{};          ///< for indices that name no entry
        std::size_t strays = 0; ///< how many there were
    };
    using Convert = void (*)(ColorMap& map, const std::byte* from, std::byte* to, std::size_t count);

private:
    [[nodiscard]] bool readPackets(std::byte* to, std::size_t count);
    [[nodiscard]] bool beginPacket();

    const bool runLengthCoded_;
    const std::size_t fromBytes_; // a pixel
    const std::size_t toBytes_;
    ByteView rest_;
    ColorMap map_;
    Convert convert_;

    std::size_t inPacket_ = 0; // pixels that the packet still has
    bool isRun_ = false;
    Color run_{};
    bool runIsStray_ = false;
};

} // namespace texplorer::tga
