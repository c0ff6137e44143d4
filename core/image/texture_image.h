#pragma once

// Everything that an image file holds for a texture: one picture, or faces and mip levels, compressed or not.

#include "core/image/block_image.h"
#include "core/image/image.h"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace texplorer {

/// One level of one face.
using Surface = std::variant<Image, BlockImage>;

/// What a file says its fourth component means.
enum class AlphaMeaning : std::uint8_t { None, Straight, Premultiplied, Unknown };

/// Something that a file holds and that its texture image, or another file made of it, doesn't.
struct Loss {
    std::string_view what; ///< for programs: "componentBits"
    std::string sentence;  ///< "16 bits a component become 8"
    bool ofPixels = true;  ///< false: it describes the pixels, all of whose numbers stay
    bool operator==(const Loss&) const = default;
};

/// What stands in a file beside its picture and can be put into another one of the same format: PNG's chunks.
struct FilePart {
    std::string name; ///< "iCCP"
    Bytes data;
};

/// All surfaces have the same pixel or block format. A value.
struct TextureImage {
    std::string_view format; ///< of the file: "DDS"
    int layers = 1;          ///< of an array; a decoder reads the first alone unless it is told to read all
    int faces = 1;           ///< 6 for a cube map: +x, -x, +y, -y, +z, -z
    int levels = 1;          ///< that the file holds; fewer than a full chain is normal
    std::vector<Surface> surfaces; ///< layers * faces * levels, the levels of a face together, largest first
    /// Whether row 0 of the surfaces is the top row (as DDS stores it). Decoders of pictures give the bottom
    /// row first, because turning rows around while decoding costs nothing.
    bool topFirst = false;
    bool fileTopFirst = true; ///< what the file itself does: what a naive loader would have shown
    bool srgb = false;
    AlphaMeaning alpha = AlphaMeaning::None;
    std::vector<std::string> notes;   ///< sentences: what was odd about the file and was survived
    std::vector<std::string> remarks; ///< sentences: what is right about the file and isn't followed
    int componentBits = 8;    ///< of the file's widest component, where that is more than the 8 that are kept
    std::vector<Loss> losses; ///< of decoding, but for those that follow from the other members
    std::vector<FilePart> parts; ///< only with DecodeLimits::everything

    /// `face` counts those of all layers: that of another than the first is layer * faces + face.
    [[nodiscard]] const Surface& surface(int face, int level) const {
        return surfaces[static_cast<std::size_t>(face) * static_cast<std::size_t>(levels) +
                        static_cast<std::size_t>(level)];
    }
};

[[nodiscard]] int widthOf(const Surface& surface);
[[nodiscard]] int heightOf(const Surface& surface);
[[nodiscard]] int depthOf(const Surface& surface);
/// What its extents and format need, whether it has pixels or is that of an outline (DecodeLimits::pixels).
[[nodiscard]] std::size_t byteCount(const Surface& surface);
[[nodiscard]] std::size_t byteCount(const TextureImage& texture); ///< of all surfaces
/// What it holds: none in an outline.
[[nodiscard]] std::size_t bytesHeld(const Surface& surface);
[[nodiscard]] bool hasPixels(const TextureImage& texture); ///< there is a picture, and it is no outline

/// Turns every slice upside down, in place.
void flipVertically(Image& image);

/// A picture as a TextureImage of one surface.
[[nodiscard]] TextureImage textureOf(Image image, std::string_view format);

} // namespace texplorer
