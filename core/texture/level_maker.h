#pragma once

// Makes the levels of a texture: the implementation of texture_levels.h and level_plan.h. Its functions are
// in level_maker.cpp (levels from pictures), level_upload.cpp (custom calls), level_subimages.cpp (replaced
// parts), level_blocks.cpp (compressed levels) and level_plan.cpp (extents only).

#include "texplorer/base/result.h"
#include "texplorer/gl/sampling.h"
#include "texplorer/image/cube_faces.h"
#include "texplorer/image/float_pixels.h"
#include "texplorer/texture/level_plan.h"
#include "texplorer/texture/step_operation.h"
#include "texplorer/texture/texture_levels.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace texplorer {

/// The effective settings for an image. The light's view is unchanged in a depth texture: a mean of depths is
/// not a meaningful depth.
[[nodiscard]] Texture settingsFor(const Texture& texture, const TextureImage& image);

/// Whether there is a picture, also as an outline.
[[nodiscard]] bool holdsPicture(const TextureImage* image);

/// The source of a level.
struct LevelPicture {
    int number = 0;                      ///< GL's
    const TextureImage* image = nullptr; ///< never null
    SourceKind source = SourceKind::Pattern;
    int fileLevel = 0; ///< the index of the image's level
    int place = 0; ///< the number that it has in the scene: more than `number` if larger ones are left out
    bool fitted = false; ///< scaled to the required size of the level
};

class LevelMaker {
public:
    /// `pictures` has a base. `lends`: whether results may share its surfaces.
    LevelMaker(const Texture& texture, const TexturePictures& pictures, Target target, const LevelWork& work,
               bool lends = false)
        : texture_(settingsFor(texture, *pictures.base))
        , pictures_(pictures)
        , image_(*pictures.base)
        , lends_(lends)
        , target_(target)
        , work_(work)
        , readsFirst_(isMadeByDriver(texture.mipmaps)     ? ReadsFirst::ForDriver
                      : texture.mipmaps == MipPolicy::Glu ? ReadsFirst::ForGlu
                                                          : ReadsFirst::No)
        , base_{0, &image_, texture_.source} {
        takeSmaller();
    }

    Result<TextureLevels> run();
    [[nodiscard]] LevelPlan plan();
    void eachStep(const std::function<void(const Image&)>& visit) const;
    [[nodiscard]] Image subimageOf(std::size_t index) const;

private:
    /// Whether rows are taken in the order of a simple loader: the file's first row first.
    [[nodiscard]] bool fileOrder(SourceKind source) const {
        const bool drawnHere = isCube() && source == SourceKind::Pattern; // has no file
        return !drawnHere && (texture_.flip == FlipMode::Coordinates || texture_.flip == FlipMode::Matrix ||
                              texture_.flip == FlipMode::None);
    }
    /// Whether the top row of a picture is at t = 0. A late flip applies to all levels, according to the base
    /// level.
    [[nodiscard]] bool isTopFirst(const LevelPicture& picture) const {
        if (!fileOrder(picture.source))
            return isCube();
        const bool turnedLater = !isCube() && texture_.flip != FlipMode::None;
        return turnedLater ? base_.image->fileTopFirst : picture.image->fileTopFirst;
    }
    /// Whether the rows are reversed before the upload.
    [[nodiscard]] bool turns(const LevelPicture& picture) const {
        return picture.image->topFirst != isTopFirst(picture);
    }
    /// In that case, the top row of a picture is at t = 0 (texplorer/image/cube_faces.h).
    [[nodiscard]] bool isCube() const { return target_ == Target::CubeMap; }
    /// Whether the faces of a cube map are parts of one picture.
    [[nodiscard]] bool cutsFaces(const TextureImage& image) const {
        const Surface& whole = image.surface(0, 0);
        return isCube() && image.faces != cubeFaceCount &&
               cubeLayout(widthOf(whole), heightOf(whole)) != CubeLayout::Same;
    }
    /// The result is then discarded.
    [[nodiscard]] bool isStopped() const { return work_.stop.stop_requested(); }
    [[nodiscard]] bool prepares() const { return !texture_.preparation.empty(); }
    /// Whether levels above the base have their own pictures.
    [[nodiscard]] bool hasPictures() const {
        return texture_.mipmaps == MipPolicy::FromFile || texture_.mipmaps == MipPolicy::Given;
    }
    [[nodiscard]] bool generates() const {
        return texture_.mipmaps == MipPolicy::Generated || texture_.mipmaps == MipPolicy::Colored ||
               texture_.mipmaps == MipPolicy::Missing;
    }
    [[nodiscard]] bool hasBorder() const { return texture_.border != 0; }
    [[nodiscard]] const Surface& base() const { return base_.image->surface(0, base_.fileLevel); }
    /// For a file without faces, all faces are the same.
    [[nodiscard]] static const Surface& surface(const TextureImage& image, int face, int level) {
        return image.surface(image.faces == cubeFaceCount ? face : 0, level);
    }

    /// Whether pixels go through a custom call: glCompressedTexImage has no format.
    [[nodiscard]] bool readsMemory() const {
        return texture_.upload.custom && texture_.compression != Compression::Cached;
    }

    /// Whether the texture keeps floats: blocks have another internal format.
    [[nodiscard]] bool keepsFloats() const {
        return isFloat(texture_.internalFormat) && texture_.compression != Compression::Driver &&
               texture_.compression != Compression::Cached;
    }
    /// As the texture stores it, for levels that are made of what it stores.
    [[nodiscard]] Image stored(Image image) const {
        return keepsFloats() ? floatsOf(image, mostBits(texture_.internalFormat)) : std::move(image);
    }

    /// Who makes the other levels of the base after it was read: otherwise the program holds all of them.
    enum class ReadsFirst : std::uint8_t { No, ForDriver, ForGlu };
    struct Read {
        Image image;
        std::shared_ptr<const Bytes> memory;
        std::size_t held;
        MemoryLayout layout;
        void moveMemoryTo(TextureLevel& level) {
            level.memory = std::move(memory);
            level.held = held;
            level.layout = layout;
        }
    };

    [[nodiscard]] LevelPlan planWithoutSubimages();
    void takeSmaller();
    [[nodiscard]] std::vector<LevelPicture> fileLevels() const;
    [[nodiscard]] std::vector<LevelPicture> givenLevels() const;
    [[nodiscard]] std::vector<LevelPicture> levelPictures() const;
    [[nodiscard]] PlannedLevel fullExtentsOf(const LevelPicture& picture) const;
    [[nodiscard]] PlannedLevel extentsOfPicture(const LevelPicture& picture) const;
    [[nodiscard]] PlannedLevel withoutOwnBorder(PlannedLevel level) const;
    [[nodiscard]] PlannedLevel extentsOfBase() const;
    [[nodiscard]] PlannedLevel drawnExtents() const;
    [[nodiscard]] bool keepsBlocks();
    [[nodiscard]] bool haveSameBlocks();
    [[nodiscard]] Result<void> takeBlocks();
    [[nodiscard]] Image decoded(const TextureImage& image, int face, int level, bool turned) const;
    template<class Visit>
    [[nodiscard]] Image preparedPart(Image part, const LevelPicture& picture, int face,
                                     const Visit& visit) const;
    [[nodiscard]] Image halved(Image part) const;
    [[nodiscard]] Image pixels(const LevelPicture& picture, int face) const;
    [[nodiscard]] bool isTakenAsItIs(const LevelPicture& picture, const Surface& surface) const;
    [[nodiscard]] SharedSurface lend(const Surface& surface) const;
    [[nodiscard]] Result<void> takePixels();
    void takePicture(const LevelPicture& picture, int face);
    [[nodiscard]] Result<void> takeMade(int face);
    [[nodiscard]] PixelFormat formatOfPixels() const;
    [[nodiscard]] MemoryLayout memoryOfBase() const;
    [[nodiscard]] PlannedUpload plannedUpload() const;
    [[nodiscard]] Result<void> checkFormat() const;
    [[nodiscard]] Result<void> checkUpload() const;
    [[nodiscard]] Result<Read> readBack(const Image& image) const;
    [[nodiscard]] Result<void> takeMadeOfRead(int face, const MipOptions& options);
    [[nodiscard]] Result<void> readLevels();
    [[nodiscard]] Result<void> checkRoom() const;
    void noteMissing();
    [[nodiscard]] Sentence subimageRefusal(std::size_t index) const;
    [[nodiscard]] Sentence subimageRefusal(std::size_t index, const PlannedLevel& level) const;
    [[nodiscard]] std::vector<RefusedSubimage>
    refusedSubimages(const std::vector<PlannedLevel>& levels) const;
    [[nodiscard]] PlannedLevel withoutRim(PlannedLevel level) const;
    void replacePart(Image& level, Image part, const Subimage& subimage) const;
    [[nodiscard]] bool hasSubimage(int level, int face) const;
    void replaceIn(Image& image, int level, int face) const;
    void replaceInLevels();
    [[nodiscard]] MipChain chainOf(MipPolicy policy, Image base, const MipOptions& options) const;
    [[nodiscard]] Result<void> compress();
    [[nodiscard]] Result<void> compressHere();
    [[nodiscard]] Result<void> compressHere(std::span<TextureLevel> levels);
    void leaveOneOut();
    void roundToBits();
    void note(Sentence sentence) { out_.notes.push_back(std::move(sentence)); }

    const Texture texture_;
    const TexturePictures& pictures_;
    const TextureImage& image_; ///< of the base level in the scene
    bool lends_;
    Target target_;
    const LevelWork& work_;
    ReadsFirst readsFirst_;
    bool takesBlocks_ = false; ///< the levels are the file's blocks
    LevelPicture base_;        ///< the one that is drawn
    PlannedLevel whole_;       ///< the extents of the scene's base
    int halvings_ = 0;         ///< of the base, until it is small enough
    Sentence fallback_;        ///< why the base is not the scene's; empty: it is
    TextureLevels out_;
};

} // namespace texplorer
