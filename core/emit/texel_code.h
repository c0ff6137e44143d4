#pragma once

// How a program comes by the texels of a texture: what it computes in a few lines, what it has to be given.

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"
#include "texplorer/gl/sampling.h"
#include "texplorer/reference/sampling/sampled_texture.h"
#include "texplorer/texture/texture_levels.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace texplorer::emit {

/// Where the texels of a level come from.
enum class TexelSource : std::uint8_t {
    Checker,    ///< the board of a pattern: checkerboard()
    Gradient,   ///< gradient()
    Flat,       ///< one colour everywhere: fill()
    Halved,     ///< the level before it, by averages of four: halve()
    Read,       ///< an image file of which a few lines read the picture
    Listed,     ///< few: their numbers stand in the program
    Packed,     ///< many: packed, and unpack() makes them
    Compressed, ///< blocks, as they are
    Depths,     ///< 32 bits each
    Floats,     ///< RGBA of 32 bits each
    Memory,     ///< of a custom upload: the bytes that glTexImage is given
};

/// A level of all faces.
struct LevelCode {
    int number = 0;
    int width = 0; ///< with a border
    int height = 1;
    int depth = 1;
    TexelSource source = TexelSource::Listed;
    std::array<std::uint8_t, 4> color{}; ///< of Flat; what is light of Checker
    int square = 0;                      ///< of Checker: texels
    /// Of all faces, one after the other: RGBA texels of Listed, the packed ones, blocks, depths of 32 bits,
    /// floats, memory.
    Bytes bytes{};
};

/// A part that is replaced after the upload.
struct SubimageCode {
    std::size_t index = 0; ///< into Texture::subimages
    LevelCode texels{};    ///< with the number of the level
};

/// The files that a program reads in a few lines.
enum class FileReader : std::uint8_t {
    None,
    Bmp, ///< 24 bits a pixel, not compressed
    Tga, ///< 24 or 32 bits a pixel, not compressed
    Dds, ///< DXT1, DXT3 or DXT5 of a picture
};

struct TextureCode {
    std::vector<LevelCode> levels; ///< ascending
    std::vector<SubimageCode> subimages{};
    int faces = 1;
    int border = 0;
    int lastLevel = 1000; ///< as TextureLevels has it
    LateFlip lateFlip = LateFlip::None;
    std::optional<BlockFormat> blocks{}; ///< of Compressed
    bool driverCompresses = false;
    /// GenerateMipmap, OnUpload or Glu: a call makes the levels above the base, which is the only one here.
    MipPolicy mipmaps = MipPolicy::Generated;
    FileReader reader = FileReader::None; ///< of the level with TexelSource::Read, or of all of a DDS file
    bool flipsBlocks = false;             ///< of a DDS file: its blocks are turned around when they are read
    int firstLevel = 0;                   ///< of a DDS file: larger ones are left out
    std::optional<UploadCall> call{};     ///< of Memory
    reference::SampledTexture shape{};    ///< the extents of its levels
};

/// Levels that are uploaded by one loop: the first, and those that are made of it by averages.
struct LevelGroup {
    std::span<const LevelCode> levels;
    int missing = -1; ///< the number of one between them that there isn't; -1: none

    [[nodiscard]] const LevelCode& first() const { return levels.front(); }
    [[nodiscard]] int last() const { return levels.back().number; }
    [[nodiscard]] bool isOne() const { return levels.size() == 1; }
};

/// All levels of `code`, which they point into.
[[nodiscard]] std::vector<LevelGroup> groupsOf(const TextureCode& code);

/// Most texels that are listed.
inline constexpr int maxListed = 64;

/// What reads a file that begins with these bytes: at least the first 128, or all.
[[nodiscard]] FileReader readerOf(ByteView start);

/// `reader`: what may read the file; it does where the texture has what it gives. `readsMemory`: custom
/// uploads are calls; otherwise there are the texels that come of them. Errors: those of prepareLevels.
[[nodiscard]] Result<TextureCode> textureCode(const Texture& texture, const TexturePictures& pictures,
                                              Target target, FileReader reader = FileReader::None,
                                              const LevelWork& work = {}, bool readsMemory = false);

/// RGBA texels as the "Quite OK Image Format" packs them (qoiformat.org), without its header and end.
[[nodiscard]] Bytes packed(ByteView texels);

/// Without zeros at its end, which C fills in, but for the first byte.
[[nodiscard]] Bytes withoutZerosAtEnd(Bytes bytes);

/// What bytes are in a program: all but the first are of 4 bytes each, in the processor's order.
enum class NumberType : std::uint8_t { Byte, UnsignedInt, Float };

/// "12, 255, 0,\n": C's numbers, in rows of up to 100 letters; unsigned ones of 4 bytes are hexadecimal.
/// Floats that C has no number for become the largest, or 0.
[[nodiscard]] std::string numbersText(ByteView bytes, NumberType type = NumberType::Byte);

} // namespace texplorer::emit
