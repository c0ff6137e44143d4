// Which levels there will be, and how large they are.

#include "texplorer/texture/level_plan.h"

#include "texplorer/base/sentence_format.h"
#include "texplorer/image/border.h"
#include "texplorer/image/power_of_two.h"
#include "texplorer/image/resample.h"
#include "texplorer/texture/level_maker.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>

namespace texplorer {
namespace {

int largestOf(const PlannedLevel& level) {
    return std::max({level.width, level.height, level.depth});
}

} // namespace

/// The part of a picture that is prepared, with its number in the scene: for a line the whole picture.
PlannedLevel LevelMaker::fullExtentsOf(const LevelPicture& picture) const {
    const Surface& surface = picture.image->surface(0, picture.fileLevel);
    if (cutsFaces(*picture.image)) {
        const auto [width, height] = cubeFaceExtents(widthOf(surface), heightOf(surface));
        return {picture.place, width, height, 1};
    }
    return {picture.place, widthOf(surface), heightOf(surface),
            target_ == Target::Texture3D ? depthOf(surface) : 1};
}

/// The part of a picture that the target takes, after the preparation.
PlannedLevel LevelMaker::extentsOfPicture(const LevelPicture& picture) const {
    PlannedLevel level = fullExtentsOf(picture);
    for (const ImageStep& step : texture_.preparation)
        level = resizedBy(step, level);
    level = {picture.number, level.width, target_ == Target::Texture1D ? 1 : level.height, level.depth};
    if (picture.fitted)
        level = levelAbove(whole_, picture.place);
    if (picture.number == 0 && halvings_ > 0) {
        const PlannedLevel inside = withoutOwnBorder(level);
        const PlannedLevel half = levelAbove(inside, halvings_);
        level = {0, half.width + level.width - inside.width, half.height + level.height - inside.height,
                 half.depth + level.depth - inside.depth};
    }
    level.number = picture.number;
    return level;
}

/// What is left where the outermost texels are taken for the border.
PlannedLevel LevelMaker::withoutOwnBorder(PlannedLevel level) const {
    const int axes = axesOf(target_);
    if (!hasBorder() || !hasBorderExtents(level.width, level.height, level.depth, axes))
        return level;
    return {level.number, level.width - 2, level.height - (axes > 1 ? 2 : 0),
            level.depth - (axes > 2 ? 2 : 0)};
}

/// As it is uploaded, without its border.
PlannedLevel LevelMaker::extentsOfBase() const {
    const PlannedLevel whole = extentsOfPicture(base_);
    const PlannedLevel level = withoutOwnBorder(whole);
    if (level != whole || texture_.npot != NpotPolicy::PowerOfTwo)
        return level;
    return {0, nearestPowerOfTwo(level.width), nearestPowerOfTwo(level.height),
            nearestPowerOfTwo(level.depth)};
}

/// The same, or of a base from a file with levels, which are uploaded as they are.
PlannedLevel LevelMaker::drawnExtents() const {
    return texture_.mipmaps == MipPolicy::FromFile ? extentsOfPicture(base_) : extentsOfBase();
}

/// Chooses a base that the driver takes: the first level with a picture that is small enough, or else the
/// last one, halved.
void LevelMaker::takeSmaller() {
    whole_ = drawnExtents();
    const int limit = std::max(1, pictures_.limits.of(target_));
    if (texture_.oversize != Oversize::Smaller || largestOf(whole_) <= limit)
        return;
    const std::vector<LevelPicture> levels =
        texture_.mipmaps == MipPolicy::Given ? givenLevels() : fileLevels();
    for (std::size_t next = 1; largestOf(drawnExtents()) > limit; ++next) {
        if (next >= levels.size())
            ++halvings_;
        else {
            base_ = levels[next];
            base_.number = 0;
        }
    }
    const auto text = [](const PlannedLevel& level) {
        return fmt::format("{} × {}{}", level.width, level.height,
                           level.depth > 1 ? fmt::format(" × {}", level.depth) : "");
    };
    const std::string whole = text(whole_);
    const std::string drawn = text(drawnExtents());
    const ProperName target{rowOf(target_).name};
    if (halvings_ > 0)
        fallback_ = Sentence("{0} texels exceed the driver's {1} for {2}: scaled down to {3}",
                             ProperName{whole}, limit, target, ProperName{drawn});
    else
        fallback_ =
            Sentence("{0} texels exceed the driver's {1} for {2}: drawn from level {3}, which has {4}",
                     ProperName{whole}, limit, target, base_.place, ProperName{drawn});
}

/// The base as the program holds it: GLU scales what it has read.
PlannedUpload LevelMaker::plannedUpload() const {
    PlannedLevel level = extentsOfBase();
    if (texture_.mipmaps == MipPolicy::FromFile)
        level = extentsOfPicture(base_);
    else if (readsFirst_ == ReadsFirst::ForGlu)
        level = withoutOwnBorder(extentsOfPicture(base_));
    const int axes = axesOf(target_);
    const int sides = hasBorder() ? 2 : 0;
    PlannedUpload upload{
        memoryOfBase(),
        {level.width + sides, level.height + (axes > 1 ? sides : 0), level.depth + (axes > 2 ? sides : 0)}};
    if (const Result<void> accepted = checkUpload(); !accepted)
        upload.refusal = accepted.error().message;
    return upload;
}

LevelPlan LevelMaker::planWithoutSubimages() {
    LevelPlan plan;
    if (isDepth(texture_.internalFormat) && !takesDepths(target_))
        return plan;
    plan.fallback = fallback_;
    for (const LevelPicture& picture : levelPictures())
        plan.levels.push_back(extentsOfPicture(picture));
    if (texture_.mipmaps == MipPolicy::FromFile)
        plan.lastLevel = plan.levels.back().number;
    takesBlocks_ = keepsBlocks();
    if (takesBlocks_) {
        plan.blocks = std::get<BlockImage>(base()).format;
        return plan;
    }
    if (const Result<void> accepted = checkFormat(); !accepted) {
        plan.levels.clear();
        plan.refusal = accepted.error().message;
        return plan;
    }
    if (readsMemory()) {
        plan.upload = plannedUpload();
        if (!plan.upload->refusal.empty()) {
            plan.levels.clear();
            return plan;
        }
    }
    const bool compresses =
        texture_.compression == Compression::Driver || texture_.compression == Compression::Cached;
    if (compresses && axesOf(target_) == 2 && !hasBorder() && !isDepth(texture_.internalFormat))
        plan.blocks = blockFormat(texture_.compressedFormat);
    plan.border = hasBorder() ? 1 : 0;
    if (texture_.mipmaps == MipPolicy::FromFile)
        return plan;
    const PlannedLevel level = extentsOfBase();
    plan.levels = {level};
    for (const LevelPicture& picture : levelPictures()) {
        if (picture.number > 0)
            plan.levels.push_back(picture.fitted ? extentsOfPicture(picture)
                                                 : withoutOwnBorder(extentsOfPicture(picture)));
    }
    if (!generates())
        return plan;
    const int count = mipLevelCount(level.width, level.height, level.depth);
    for (int number = 1; number < count; ++number)
        plan.levels.push_back(levelAbove(level, number));
    if (const int missing = missingLevel(count); texture_.mipmaps == MipPolicy::Missing && missing >= 0)
        plan.levels.erase(plan.levels.begin() + missing);
    return plan;
}

LevelPlan LevelMaker::plan() {
    LevelPlan plan = planWithoutSubimages();
    if (!plan.levels.empty())
        plan.refusedSubimages = refusedSubimages(plan.levels);
    return plan;
}

PlannedLevel levelAbove(const PlannedLevel& base, int number) {
    const auto extent = [number](int texels) { return std::max(1, texels >> number); };
    return {number, extent(base.width), extent(base.height), extent(base.depth)};
}

LevelPlan planLevels(const Texture& texture, const TexturePictures& pictures, Target target) {
    return holdsPicture(pictures.base.get()) ? LevelMaker(texture, pictures, target, {}).plan() : LevelPlan{};
}

} // namespace texplorer
