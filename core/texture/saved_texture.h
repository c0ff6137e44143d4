#pragma once

// A texture as the content of an image file.

#include "texplorer/codec/losses.h"
#include "texplorer/texture/level_plan.h"
#include "texplorer/texture/texture_levels.h"

#include <string_view>
#include <vector>

namespace texplorer {

enum class SavedBlocks : std::uint8_t {
    AsTexture, ///< blocks if the texture has some
    None,
    Chosen,
};

/// How a texture is saved.
struct TextureSaving {
    std::string_view file = "DDS";     ///< the format of the file, CodecRow::name
    Target target = Target::Texture2D; ///< as in prepareLevels
    // Of DDS, which has all levels.
    SavedBlocks blocks = SavedBlocks::AsTexture;
    BlockFormat format = BlockFormat::Dxt1;        ///< for SavedBlocks::Chosen
    EncodeQuality quality = EncodeQuality::Normal; ///< of blocks that are made for the file
    // Of other formats, which have one picture.
    int level = 0;

    [[nodiscard]] bool hasAllLevels() const { return file == "DDS"; }
    /// Whether blocks are made for the file of such a texture, if it is compressed at all.
    [[nodiscard]] bool encodes(const Texture& texture) const {
        return hasAllLevels() &&
               (blocks == SavedBlocks::Chosen ||
                (blocks == SavedBlocks::AsTexture && texture.compression == Compression::Driver));
    }
};

struct SavedTexture {
    TextureImage image;            ///< for the encoder of the file's format
    std::vector<Loss> losses;      ///< all of them
    std::vector<Sentence> remarks; ///< whole sentences about other differences from OpenGL's texture
};

/// Whether such levels can be saved. Errors: there are none; a level that the file needs is missing or has
/// another size than in a mip chain; blocks of a volume.
[[nodiscard]] Result<void> checkSaving(const LevelPlan& plan, const TextureSaving& how);

/// Returns the levels of a texture as it is looked up: t = 0 is the bottom row, except for cube maps; a late
/// flip is made. The components are those of the internal format, borders are removed. Blocks stay as they
/// are if the file has the same format and they can be turned without loss. Errors: those of prepareLevels,
/// checkSaving and encodeLevels.
[[nodiscard]] Result<SavedTexture> savedTexture(const Texture& texture, const TexturePictures& pictures,
                                                const TextureSaving& how, const LevelWork& work = {});

} // namespace texplorer
