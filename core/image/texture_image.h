#pragma once

// The content of an image file for a texture: one picture, or faces and mip levels, compressed or not.

#include "texplorer/base/sentence.h"
#include "texplorer/image/block_image.h"
#include "texplorer/image/image.h"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace texplorer {

/// One level of one face.
using Surface = std::variant<Image, BlockImage>;

/// What a file says about the meaning of its fourth component.
enum class AlphaMeaning : std::uint8_t { None, Straight, Premultiplied, Unknown };

/// Content of a file that is missing in its texture image, or in another file made of it.
struct Loss {
    std::string_view what; ///< an identifier: "componentBits"
    Sentence sentence;     ///< "16 bits a component become 8"
    bool ofPixels = true;  ///< false: it describes the pixels, all of whose numbers stay
    bool operator==(const Loss&) const = default;
};

/// Data of a file other than its picture that can be copied to another file of the same format: PNG's chunks.
struct FilePart {
    std::string name; ///< "iCCP"
    Bytes data;
};

/// All surfaces have the same pixel or block format. A value type.
struct TextureImage {
    std::string_view format;       ///< of the file: "DDS"
    int layers = 1;                ///< of an array; decoders read only the first unless told to read all
    int faces = 1;                 ///< 6 for a cube map: +x, -x, +y, -y, +z, -z
    int levels = 1;                ///< in the file; fewer than a full chain is normal
    std::vector<Surface> surfaces; ///< layers * faces * levels, the levels of a face together, largest first
    /// Whether row 0 of the surfaces is the top row (as in DDS files). Decoders of pictures return the bottom
    /// row first, as reversing the rows while decoding costs nothing.
    bool topFirst = false;
    bool fileTopFirst = true; ///< the order in the file: what a simple loader would show
    bool srgb = false;
    AlphaMeaning alpha = AlphaMeaning::None;
    std::vector<Sentence> notes;   ///< sentences about irregularities of the file that are tolerated
    std::vector<Sentence> remarks; ///< sentences about valid features of the file that are ignored
    int componentBits = 8;         ///< of the file's widest component, if more than the 8 that are stored
    std::vector<Loss> losses;      ///< of decoding, except those that follow from the other members
    std::vector<FilePart> parts;   ///< only with DecodeLimits::everything

    /// `face` counts across layers: in other layers than the first, it is layer * faces + face.
    [[nodiscard]] const Surface& surface(int face, int level) const {
        return surfaces[static_cast<std::size_t>(face) * static_cast<std::size_t>(levels) +
                        static_cast<std::size_t>(level)];
    }
};

[[nodiscard]] int widthOf(const Surface& surface);
[[nodiscard]] int heightOf(const Surface& surface);
[[nodiscard]] int depthOf(const Surface& surface);
/// The size that its extents and format need, also without pixels (DecodeLimits::pixels).
[[nodiscard]] std::size_t byteCount(const Surface& surface);
[[nodiscard]] std::size_t byteCount(const TextureImage& texture); ///< of all surfaces
/// The actual size: 0 for an outline.
[[nodiscard]] std::size_t bytesHeld(const Surface& surface);
[[nodiscard]] bool hasPixels(const TextureImage& texture); ///< there is a picture, and not only an outline

/// Flips every slice upside down, in place.
void flipVertically(Image& image);

/// Makes a TextureImage with one surface.
[[nodiscard]] TextureImage textureOf(Image image, std::string_view format);

} // namespace texplorer
