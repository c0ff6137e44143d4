#pragma once

// From what a file holds to what is uploaded: the one place where flip, compression and mipmaps of a Texture
// take effect. Every renderer starts from its result.

#include "core/base/result.h"
#include "core/image/mipmaps.h"
#include "core/image/shared_surface.h"
#include "core/image/texture_image.h"
#include "core/s3tc/encode.h"
#include "core/scene/scene.h"
#include "core/texture/block_cache.h"
#include "core/texture/texture_pictures.h"

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace texplorer {

/// What is left to do about a picture that is upside down when it is uploaded.
enum class LateFlip : std::uint8_t { None, Coordinates, Matrix };

struct TextureLevel {
    int number = 0;        ///< GL's: 0 is the base
    SharedSurface surface; ///< lent by the image where nothing had to be done to it
    int face = 0;          ///< of a cube map: counted as CubeFace
};

struct TextureLevels {
    std::vector<TextureLevel> levels; ///< ascending, one face after the other; row 0 goes to t = 0
    /// The last level of a file that holds fewer than a full chain: GL_TEXTURE_MAX_LEVEL must not exceed it.
    int lastLevel = 1000;
    LateFlip lateFlip = LateFlip::None;
    int border = 0; ///< how many texels of every level's extents are border, on each side of each axis
    InternalFormat internalFormat = InternalFormat::Rgba; ///< of levels that are pixels and stay pixels
    std::optional<BlockFormat> driverFormat;              ///< what the driver shall compress the levels to
    /// What compressed levels were made of, in the same order: what their loss is measured against. Empty
    /// where nothing was compressed here.
    MipChain source;
    bool fromCache = false;         ///< the blocks were found in the cache and not made anew
    std::vector<std::string> notes; ///< sentences: what was done otherwise than asked for, and why
};

/// What compressing at run time (Compression::Cached) needs. It takes long where the cache doesn't have the
/// blocks, at best quality two seconds a megatexel, and so do many steps of a preparation: a caller that must
/// not wait calls prepareLevels on a thread of his own, with a `stop` that he can request.
struct LevelWork {
    BlockCache cache{};  ///< where blocks are looked for and kept
    Progress progress{}; ///< of the compressing, on the thread that calls
    std::stop_token stop{};
    /// Of the base level's first face, where there is a preparation: the image before it and after each step,
    /// and whether its row 0 is the top one.
    std::function<void(const Image& image, bool topFirst)> step{};
};

/// Applies `texture`'s preparation, flip, compression, mipmaps and power-of-two choices to the part of
/// `image` that a target takes: face 0; of a volume the middle slice, unless the target is 3D; of a picture
/// the middle row for 1D. OpenGL compresses pictures only, so that lines and volumes are uploaded
/// decompressed. Errors: an image without surfaces; no memory; Cancelled after a stop request. A cache that
/// can't be used is a note. Where the internal format has few bits each level's pixels are rounded to them.
/// Those of a depth texture become PixelFormat::Depth32; OpenGL has it for 1D and 2D targets alone, and not
/// compressed. What the light sees stays as it is there, without mip levels; a texture of colours has it as
/// greys. Unsupported: depths for another target.
[[nodiscard]] Result<TextureLevels> prepareLevels(const Texture& texture, const TextureImage& image,
                                                  Target target = Target::Texture2D,
                                                  const LevelWork& work = {});

/// The same with the images of levels that are given one by one and of the preparation, where there are any;
/// the base is not null. What of it needs no change is not copied, so that a large image takes no more than
/// its own memory and that of the mip levels above it. A file's level has the size of its picture, a
/// pattern's the one that it has to have; where one isn't loaded there is no such level, which is a note.
/// TooLarge: the pictures of given levels take more than sceneImageBytes together.
[[nodiscard]] Result<TextureLevels> prepareLevels(const Texture& texture, const TexturePictures& pictures,
                                                  Target target = Target::Texture2D,
                                                  const LevelWork& work = {});

/// Calls visit(image) with the texture's picture before its preparation, and after each step of it: upright,
/// bottom row first; of a cube map the first face, of a volume the middle slice. Never where it isn't loaded.
/// A stop request within visit() makes it the last call.
void eachPreparationStep(const Texture& texture, const TexturePictures& pictures,
                         const std::function<void(const Image&)>& visit, const std::stop_token& stop = {});

/// Every level as pixels, 8 bits a component of the blocks' base format: for a driver without S3TC. The rest
/// stays as it is.
void decompress(TextureLevels& levels);

/// The texture with everything that prepareLevels ignores at its initial value: two textures whose settings
/// are equal have equal levels.
[[nodiscard]] Texture imageSettings(const Texture& texture);

struct LevelReport {
    int number = 0;
    int width = 0;
    int height = 0;
    int depth = 1;
    int faces = 1;         ///< 6 for a cube map
    std::size_t bytes = 0; ///< of all faces
    /// Of the worst face: peak signal-to-noise ratio against the source, in dB over `components`; infinite
    /// where they are equal, none where there is no source to compare with.
    std::optional<double> psnr;
    /// "RGB": those of red, green, blue and alpha that the format keeps and the source has. Alpha that is 255
    /// everywhere is none.
    std::string_view components;
};

struct TextureReport {
    std::vector<LevelReport> levels;
    std::size_t bytes = 0;   ///< of all levels
    double ratioToBase = 0;  ///< tends to 4/3 for a full chain of a picture
    double shareOfRgba8 = 0; ///< of the bytes that the same levels would take with 4 bytes a texel
    double shareOfRgb8 = 0;  ///< and with 3
};

[[nodiscard]] TextureReport reportOn(const std::vector<TextureLevel>& levels, const MipChain& source = {});
/// Of pixels the bytes are those of the internal format, or of the blocks that the driver is to make of them.
[[nodiscard]] TextureReport reportOn(const TextureLevels& levels);

/// The report as a small table, a line a level and one for the sum.
[[nodiscard]] std::string describe(const TextureReport& report);

} // namespace texplorer
