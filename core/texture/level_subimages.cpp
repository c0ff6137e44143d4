// Parts of levels that are replaced after the upload: glTexSubImage (OpenGL 2.1, section 3.8.2).

#include "texplorer/image/convert.h"
#include "texplorer/image/resample.h"
#include "texplorer/texture/level_maker.h"
#include "texplorer/texture/target_image.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace texplorer {

Image LevelMaker::subimageOf(std::size_t index) const {
    const Subimage& subimage = texture_.subimages[index];
    const TextureImage* image = pictures_.subimage(index);
    if (!holdsPicture(image) || !hasPixels(*image))
        return {};
    Image part = decoded(*image, 0, 0, image->topFirst != isTopFirst(base_));
    if (target_ == Target::Texture1D)
        part = imageForTarget(part, target_);
    if (subimage.source == SourceKind::Pattern)
        part = scaleByCoverage(part, subimage.width, target_ == Target::Texture1D ? 1 : subimage.height);
    return asRgba(std::move(part));
}

/// Why a subimage is not made, whatever the level's extents are; empty: it may be.
Sentence LevelMaker::subimageRefusal(std::size_t index) const {
    const Subimage& subimage = texture_.subimages[index];
    if (takesBlocks_ || texture_.compression == Compression::Cached)
        return "a level that is uploaded as blocks is not changed";
    if (!holdsPicture(pictures_.subimage(index)))
        return subimage.file.empty() ? Sentence("no file is chosen")
                                     : Sentence("{0} is not loaded", ProperName{subimage.file});
    const Image* pixels = std::get_if<Image>(&base());
    if (isDepth(texture_.internalFormat) || (pixels && pixels->format == PixelFormat::Depth32))
        return "colours cannot replace depths"; // GL_INVALID_OPERATION (section 3.8.2)
    if (isCube() && subimage.z >= facesOf(target_))
        return Sentence("a cube map has the faces 0 to {0}, not {1}", facesOf(target_) - 1, subimage.z);
    return {};
}

/// Why OpenGL refuses a subimage of a level with these extents; empty: it doesn't.
Sentence LevelMaker::subimageRefusal(std::size_t index, const PlannedLevel& level) const {
    const Subimage& subimage = texture_.subimages[index];
    const int axes = axesOf(target_);
    PlannedLevel part{subimage.level, subimage.width, subimage.height, 1};
    if (subimage.source == SourceKind::File) {
        const Surface& surface = pictures_.subimage(index)->surface(0, 0);
        part = {subimage.level, widthOf(surface), heightOf(surface), axes > 2 ? depthOf(surface) : 1};
    }
    const auto beyond = [](const Sentence& what, int first, int count, int extent) {
        return count > extent - first
                   ? Sentence("GL_INVALID_VALUE: {0} {1} to {2} are to change, but the level has {3}", what,
                              first, first + count - 1, extent)
                   : Sentence();
    };
    Sentence refusal = beyond(N_("the columns"), subimage.x, part.width, level.width);
    if (refusal.empty() && axes > 1)
        refusal = beyond(N_("the rows"), subimage.y, part.height, level.height);
    if (refusal.empty() && axes > 2)
        refusal = beyond(N_("the slices"), subimage.z, part.depth, level.depth);
    return refusal;
}

/// Those of all subimages, by index, with these levels.
std::vector<RefusedSubimage> LevelMaker::refusedSubimages(const std::vector<PlannedLevel>& levels) const {
    std::vector<RefusedSubimage> refused;
    for (std::size_t i = 0; i < texture_.subimages.size(); ++i) {
        Sentence why = subimageRefusal(i);
        const auto level = std::ranges::find(levels, texture_.subimages[i].level, &PlannedLevel::number);
        const bool isCalled = why.empty();
        if (isCalled)
            why = level == levels.end()
                      ? Sentence("GL_INVALID_OPERATION: there is no level {0}", texture_.subimages[i].level)
                      : subimageRefusal(i, *level);
        if (!why.empty())
            refused.push_back({i, std::move(why), isCalled});
    }
    return refused;
}

/// The extents without the border.
PlannedLevel LevelMaker::withoutRim(PlannedLevel level) const {
    const int rim = 2 * out_.border;
    const int axes = axesOf(target_);
    return {level.number, level.width - rim, axes > 1 ? level.height - rim : 1,
            axes > 2 ? level.depth - rim : 1};
}

void LevelMaker::replacePart(Image& level, Image part, const Subimage& subimage) const {
    const int rim = out_.border;
    if (level.format == PixelFormat::RgbaFloat)
        part = stored(std::move(part));
    else
        level = asRgba(std::move(level));
    const int x = subimage.x + rim;
    const int y = axesOf(target_) > 1 ? subimage.y + rim : 0;
    const int z = axesOf(target_) > 2 ? subimage.z + rim : 0;
    for (int slice = 0; slice < part.depth; ++slice) {
        for (int row = 0; row < part.height; ++row) {
            const std::byte* from = part.pixels.data() + part.offset(0, row, slice);
            std::copy_n(from, part.rowBytes(), level.pixels.data() + level.offset(x, y + row, z + slice));
        }
    }
}

/// Of a cube map, z is the face.
bool LevelMaker::hasSubimage(int level, int face) const {
    return std::ranges::any_of(texture_.subimages, [&](const Subimage& subimage) {
        return subimage.level == level && (!isCube() || subimage.z == face);
    });
}

/// Replaces the parts of a level in their order. Where OpenGL refuses a call, the level stays as it is.
void LevelMaker::replaceIn(Image& image, int level, int face) const {
    for (std::size_t i = 0; i < texture_.subimages.size(); ++i) {
        const Subimage& subimage = texture_.subimages[i];
        if (subimage.level == level && (!isCube() || subimage.z == face) && subimageRefusal(i).empty() &&
            subimageRefusal(i, withoutRim({level, image.width, image.height, image.depth})).empty())
            replacePart(image, subimageOf(i), subimage);
    }
}

/// All levels but those that the driver makes of a changed base.
void LevelMaker::replaceInLevels() {
    std::vector<PlannedLevel> levels;
    for (TextureLevel& level : out_.levels) {
        if (level.face == 0)
            levels.push_back(withoutRim(
                {level.number, widthOf(*level.surface), heightOf(*level.surface), depthOf(*level.surface)}));
        const bool isDone = level.number == 0 && readsFirst_ == ReadsFirst::ForDriver;
        if (isDone || !hasSubimage(level.number, level.face) ||
            !std::holds_alternative<Image>(*level.surface))
            continue;
        Image changed = std::get<Image>(*level.surface);
        replaceIn(changed, level.number, level.face);
        level.surface = std::move(changed);
        level.memory.reset(); // it is uploaded as its pixels
    }
    for (const RefusedSubimage& each : refusedSubimages(levels))
        note(Sentence("subimages[{0}]: {1}; not changed", each.index, each.why));
}

} // namespace texplorer
