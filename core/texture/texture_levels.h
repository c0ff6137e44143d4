#pragma once

// Converts the content of a file to the levels to upload: here, flip, compression and mipmaps of a Texture
// are applied. Every renderer starts from the result.

#include "texplorer/base/result.h"
#include "texplorer/image/mipmaps.h"
#include "texplorer/image/shared_surface.h"
#include "texplorer/image/texture_image.h"
#include "texplorer/s3tc/encode.h"
#include "texplorer/scene/scene.h"
#include "texplorer/texture/block_cache.h"
#include "texplorer/texture/texture_pictures.h"

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace texplorer {

/// How the renderer must flip a picture that is uploaded upside down.
enum class LateFlip : std::uint8_t { None, Coordinates, Matrix };

struct TextureLevel {
    int number = 0;        ///< GL's: 0 is the base
    SharedSurface surface; ///< shared with the image if unchanged
    int face = 0;          ///< of a cube map: as in CubeFace
    /// Of a custom upload: what the program holds, followed by zeros up to the last byte that
    /// TextureLevels::call reads. The surface is what OpenGL makes of it.
    std::shared_ptr<const Bytes> memory{};
    std::size_t held = 0;  ///< the bytes of the memory that the program holds
    MemoryLayout layout{}; ///< of the memory
};

struct TextureLevels {
    std::vector<TextureLevel> levels; ///< ascending, one face after the other; row 0 is at t = 0
    /// The last level of a file with fewer levels than a full chain: GL_TEXTURE_MAX_LEVEL must not exceed it.
    int lastLevel = 1000;
    LateFlip lateFlip = LateFlip::None;
    int border = 0; ///< width of the border, included in every level's extents, on each side of each axis
    /// Of levels that are uploaded as pixels and not compressed.
    InternalFormat internalFormat = InternalFormat::Rgba;
    std::optional<BlockFormat> driverFormat; ///< the format that the driver compresses to
    /// Only the base is uploaded, and the driver makes the other levels. Those here are Texplorer's own,
    /// which differ by the driver's rounding and, where an extent is odd, by its weights.
    bool madeByDriver = false;
    /// The source of compressed levels, in the same order, to measure the loss. Empty if nothing was
    /// compressed here.
    MipChain source;
    /// Of a custom upload, whose levels have a memory; other levels are uploaded as their pixels.
    std::optional<UploadCall> call{};
    bool fromCache = false;      ///< the blocks were read from the cache
    std::vector<Sentence> notes; ///< sentences about what was done differently than specified, and why
};

/// Options for compression at run time (Compression::Cached). Without cached blocks it is slow, at best
/// quality two seconds per megatexel, and so are many preparation steps: a caller that must not block calls
/// prepareLevels on another thread, with a `stop` to cancel it.
struct LevelWork {
    BlockCache cache{};  ///< where blocks are read and stored
    Progress progress{}; ///< of compression, on the calling thread
    std::stop_token stop{};
    /// Called for the base level's first face, if there is a preparation: with the image before it and after
    /// each step, and whether row 0 is the top one.
    std::function<void(const Image& image, bool topFirst)> step{};
};

/// Applies `texture`'s preparation, flip, compression, mipmaps and power-of-two settings to the part of
/// `image` that a target uses: face 0; of a volume the middle slice, unless the target is 3D; of a picture
/// the middle row for 1D. OpenGL compresses only pictures, so lines and volumes are uploaded decompressed. If
/// the internal format has few bits, each level's pixels are rounded to them. Those of a depth texture become
/// PixelFormat::Depth32; OpenGL allows it only for 1D and 2D targets, without compression. In a depth
/// texture, the light's view is unchanged, without mip levels; in a colour texture it is grey. Errors: an
/// image without surfaces; no memory; Cancelled after a stop request; Unsupported for depths with another
/// target. An unusable cache is a note.
[[nodiscard]] Result<TextureLevels> prepareLevels(const Texture& texture, const TextureImage& image,
                                                  Target target = Target::Texture2D,
                                                  const LevelWork& work = {});

/// The same with the images of levels and of the preparation, if there are any; the base must not be null.
/// Unchanged surfaces are not copied, so a large image needs only its own memory and that of the mip levels
/// above it. A level from a file has the size of its picture, a level from a pattern the required size; if an
/// image is not loaded, its level is missing, with a note. TooLarge: the pictures of given levels exceed
/// sceneImageBytes together.
[[nodiscard]] Result<TextureLevels> prepareLevels(const Texture& texture, const TexturePictures& pictures,
                                                  Target target = Target::Texture2D,
                                                  const LevelWork& work = {});

/// Calls visit(image) with the texture's picture before its preparation and after each step: upright, bottom
/// row first; of a cube map the first face, of a volume the middle slice. Not called if it is not loaded. A
/// stop request in visit() ends the calls.
void eachPreparationStep(const Texture& texture, const TexturePictures& pictures,
                         const std::function<void(const Image&)>& visit, const std::stop_token& stop = {});

/// The pixels of a subimage, Rgba8, with the rows in the texture's order; empty if its image is not loaded.
/// Which ones are made is part of a plan (texplorer/texture/level_plan.h).
[[nodiscard]] Image subimageOf(const Texture& texture, const TexturePictures& pictures, Target target,
                               std::size_t index);

/// Makes every level pixels of 8 bits per component of the format's base format, for drivers without S3TC or
/// floats: blocks are decompressed, floats limited to 0 … 1. The other members are unchanged.
void makeBytes(TextureLevels& levels);

/// Returns the texture with MipPolicy::Generated and the settings that make the levels of a mipmap function
/// of OpenGL or GLU; unchanged if it calls none.
[[nodiscard]] Texture withGeneratedLevels(const Texture& texture);

/// Returns the texture with every parameter that prepareLevels ignores at its initial value: textures with
/// equal results have equal levels.
[[nodiscard]] Texture imageSettings(const Texture& texture);

struct LevelReport {
    int number = 0;
    int width = 0;
    int height = 0;
    int depth = 1;
    int faces = 1;         ///< 6 for a cube map
    std::size_t bytes = 0; ///< of all faces
    /// Of the worst face: the peak signal-to-noise ratio against the source, in dB over `components`;
    /// infinite if equal, empty without a source.
    std::optional<double> psnr;
    /// "RGB": the components that the format stores and the source has. Alpha that is 255 everywhere does not
    /// count.
    std::string_view components;
};

struct TextureReport {
    std::vector<LevelReport> levels;
    std::size_t bytes = 0;   ///< of all levels
    double ratioToBase = 0;  ///< close to 4/3 for a full chain of a picture
    double shareOfRgba8 = 0; ///< relative to the same levels with 4 bytes per texel
    double shareOfRgb8 = 0;  ///< and with 3 bytes per texel
};

[[nodiscard]] TextureReport reportOn(const std::vector<TextureLevel>& levels, const MipChain& source = {});
/// For pixels, the bytes are those of the internal format, or of the blocks that the driver makes.
[[nodiscard]] TextureReport reportOn(const TextureLevels& levels);

/// The report as a small table: a line per level, and the total.
[[nodiscard]] std::string describe(const TextureReport& report);

} // namespace texplorer
