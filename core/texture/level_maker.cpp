#include "texplorer/texture/level_maker.h"

#include "texplorer/image/border.h"
#include "texplorer/image/depth_pixels.h"
#include "texplorer/image/power_of_two.h"
#include "texplorer/image/resample.h"
#include "texplorer/image/stored_numbers.h"
#include "texplorer/s3tc/surface_pixels.h"
#include "texplorer/texture/image_budget.h"
#include "texplorer/texture/late_flip.h"
#include "texplorer/texture/target_image.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace texplorer {

namespace {

std::array<std::uint8_t, 3> stencil(const Texture& texture) {
    const auto byte = [&](int i) {
        return static_cast<std::uint8_t>(std::lround(255 * std::clamp(texture.stencilColor[i], 0.0F, 1.0F)));
    };
    return {byte(0), byte(1), byte(2)};
}

bool areDepths(const TextureImage& image) {
    const Image* base = image.surfaces.empty() ? nullptr : std::get_if<Image>(&image.surfaces.front());
    return base && base->format == PixelFormat::Depth32;
}

} // namespace

Texture settingsFor(const Texture& texture, const TextureImage& image) {
    Texture settings = withGeneratedLevels(texture);
    if (isDrawn(texture.source)) { // the driver copies it
        settings.upload = {};
        settings.oversize = Oversize::None;
    }
    if (!areDepths(image) || !isDepth(texture.internalFormat))
        return settings;
    if (texture.mipmaps != MipPolicy::FromFile)
        settings.mipmaps = MipPolicy::None;
    settings.npot = NpotPolicy::Keep;
    settings.oversize = Oversize::None;
    settings.transparency = Transparency::File;
    settings.levels.clear();
    settings.preparation.clear();
    return settings;
}

bool holdsPicture(const TextureImage* image) {
    return image && !image->surfaces.empty() && byteCount(image->surfaces.front()) > 0;
}

/// The levels of the scene's base image that a full chain has, the base first.
std::vector<LevelPicture> LevelMaker::fileLevels() const {
    const int full = mipLevelCount(whole_.width, whole_.height, whole_.depth);
    std::vector<LevelPicture> levels;
    for (int level = 0; level < std::min(image_.levels, full); ++level)
        levels.push_back({level, &image_, texture_.source, level, level});
    return levels;
}

/// The base and the levels that the scene gives, except those that are not loaded.
std::vector<LevelPicture> LevelMaker::givenLevels() const {
    std::vector<LevelPicture> levels{{0, &image_, texture_.source}};
    for (std::size_t i = 0; i < texture_.levels.size(); ++i) {
        const SourceKind source = texture_.levels[i].source;
        const int number = static_cast<int>(i) + 1;
        if (const TextureImage* image = pictures_.level(i); holdsPicture(image))
            levels.push_back({number, image, source, 0, number, source == SourceKind::Pattern});
    }
    return levels;
}

/// Those of all levels that aren't made of others.
std::vector<LevelPicture> LevelMaker::levelPictures() const {
    if (!hasPictures())
        return {base_};
    std::vector<LevelPicture> levels = texture_.mipmaps == MipPolicy::Given ? givenLevels() : fileLevels();
    std::erase_if(levels, [this](const LevelPicture& each) { return each.place < base_.place; });
    for (LevelPicture& level : levels)
        level.number -= base_.place;
    return levels;
}

/// The part of a picture after all steps; visit(part) after each.
template<class Visit>
Image LevelMaker::preparedPart(Image part, const LevelPicture& picture, int face, const Visit& visit) const {
    const bool topFirst = isTopFirst(picture);
    for (std::size_t i = 0; i < texture_.preparation.size() && !isStopped(); ++i) {
        const ImageStep& step = texture_.preparation[i];
        const TextureImage* from = readsOther(step) ? pictures_.other(i) : nullptr;
        Image other;
        if (from && hasPixels(*from))
            other = decoded(*from, face, 0, from->topFirst != topFirst);
        const PlannedLevel level{picture.place, part.width, part.height, part.depth};
        part = prepared(std::move(part), operationOf(step, level, topFirst, &other));
        visit(part);
    }
    return part;
}

/// The mip level that the texture's filter makes of a base that is too large.
Image LevelMaker::halved(Image part) const {
    const MipOptions options{texture_.mipFilter, texture_.mipGamma, NpotPolicy::Keep, texture_.mipCoverage};
    const int axes = axesOf(target_);
    MipChain chain = hasBorder() && hasBorderExtents(part, axes)
                         ? applyMipPolicyWithBorder(MipPolicy::Generated, std::move(part), axes, options)
                         : buildMipChain(std::move(part), options);
    return std::move(chain[static_cast<std::size_t>(halvings_)]);
}

/// One face's part of a level for the target, the right way up.
Image LevelMaker::pixels(const LevelPicture& picture, int face) const {
    const bool topFirst = isTopFirst(picture);
    const bool shown = work_.step && prepares() && picture.number == 0 && face == 0;
    const auto show = [&](const Image& image) {
        if (shown)
            work_.step(image, topFirst);
    };
    Image part = decoded(*picture.image, face, picture.fileLevel, turns(picture));
    show(part);
    part = preparedPart(std::move(part), picture, face, show);
    if (texture_.transparency != Transparency::File)
        part = applyTransparency(std::move(part), texture_.transparency, stencil(texture_));
    // A line is the middle row of the picture as it is uploaded: it is taken after the flip.
    if (target_ == Target::Texture1D)
        part = imageForTarget(part, target_);
    if (picture.fitted) {
        const PlannedLevel fit = levelAbove(whole_, picture.place);
        part = scaleByCoverage(part, fit.width, fit.height, fit.depth);
    }
    return picture.number == 0 && halvings_ > 0 ? halved(std::move(part)) : part;
}

void LevelMaker::eachStep(const std::function<void(const Image&)>& visit) const {
    Image first = decoded(*base_.image, 0, base_.fileLevel, turns(base_));
    visit(first);
    static_cast<void>(preparedPart(std::move(first), base_, 0, visit));
}

/// Whether `pixels` and a policy's base would be a copy and nothing else.
bool LevelMaker::isTakenAsItIs(const LevelPicture& picture, const Surface& surface) const {
    const Image* image = std::get_if<Image>(&surface);
    const bool whole = image && (image->depth == 1 || axesOf(target_) == 3) &&
                       (target_ != Target::Texture1D || image->height == 1) &&
                       (image->format != PixelFormat::Depth32 || isDepth(texture_.internalFormat));
    const bool averages = keepsFloats() && readsFirst_ == ReadsFirst::ForDriver;
    return lends_ && halvings_ == 0 && whole && !averages && picture.image == &image_ && !picture.fitted &&
           !turns(picture) && !cutsFaces(image_) && !hasBorder() && !prepares() &&
           texture_.subimages.empty() && texture_.transparency == Transparency::File &&
           (texture_.npot != NpotPolicy::PowerOfTwo || texture_.mipmaps == MipPolicy::FromFile ||
            arePowersOfTwo(image->width, image->height, image->depth));
}

SharedSurface LevelMaker::lend(const Surface& surface) const {
    return SharedSurface(std::shared_ptr<const Surface>(pictures_.base, &surface));
}

/// A level that has a picture of its own: one of the base's file, or a given one.
void LevelMaker::takePicture(const LevelPicture& picture, int face) {
    if (const Surface& from = surface(*picture.image, face, picture.fileLevel);
        isTakenAsItIs(picture, from)) {
        out_.levels.push_back({picture.number, lend(from), face});
        return;
    }
    Image image = pixels(picture, face);
    const bool repeatsEdges = texture_.mipmaps == MipPolicy::FromFile || picture.fitted ||
                              !hasBorderExtents(image, axesOf(target_));
    if (hasBorder() && repeatsEdges)
        image = repeatEdges(image, axesOf(target_));
    out_.levels.push_back({picture.number, std::move(image), face});
}

MipChain LevelMaker::chainOf(MipPolicy policy, Image base, const MipOptions& options) const {
    return hasBorder() ? applyMipPolicyWithBorder(policy, std::move(base), axesOf(target_), options)
                       : applyMipPolicy(policy, std::move(base), options);
}

/// The base, and what the policy makes of it.
Result<void> LevelMaker::takeMade(int face) {
    const MipOptions options{texture_.mipFilter, texture_.mipGamma, texture_.npot, texture_.mipCoverage};
    if (readsMemory() && readsFirst_ != ReadsFirst::No)
        return takeMadeOfRead(face, options);
    MipChain chain;
    int number = 0;
    if (const Surface& from = surface(*base_.image, face, base_.fileLevel); isTakenAsItIs(base_, from)) {
        out_.levels.push_back({number++, lend(from), face});
        chain = mipLevelsAbove(texture_.mipmaps, std::get<Image>(from), options);
    } else {
        Image made = pixels(base_, face);
        if (readsFirst_ == ReadsFirst::ForDriver)
            made = stored(std::move(made));
        if (readsFirst_ == ReadsFirst::ForDriver && hasSubimage(0, face)) {
            made = std::move(chainOf(MipPolicy::None, std::move(made), options).front());
            replaceIn(made, 0, face);
        }
        chain = chainOf(texture_.mipmaps, std::move(made), options);
    }
    for (Image& level : chain)
        out_.levels.push_back({number++, std::move(level), face});
    return {};
}

/// The arguments of glTexImage other than those of an upload: OpenGL 2.1, section 3.8.1. A texture that is
/// compressed has another internal format.
Result<void> LevelMaker::checkFormat() const {
    const bool isCompressed =
        texture_.compression == Compression::Driver || texture_.compression == Compression::Cached;
    if (isRefused(texture_.internalFormat) && !isCompressed)
        return fail(ErrorCode::Unsupported, Sentence("GL_INVALID_VALUE: {0} is not an internal format",
                                                     rowOf(texture_.internalFormat).name));
    if (texture_.border > 1)
        return fail(
            ErrorCode::Unsupported,
            Sentence("GL_INVALID_VALUE: OpenGL has borders of 0 and 1 texels, not of {0}", texture_.border));
    return {};
}

Result<void> LevelMaker::takePixels() {
    if (Result<void> accepted = checkFormat(); !accepted)
        return accepted;
    if (readsMemory()) {
        if (Result<void> accepted = checkUpload(); !accepted)
            return accepted;
        out_.call = callOf(texture_.upload);
    }
    out_.border = hasBorder() ? 1 : 0;
    for (int face = 0; face < facesOf(target_); ++face) {
        if (texture_.mipmaps != MipPolicy::FromFile) {
            if (Result<void> made = takeMade(face); !made)
                return made;
        }
        for (const LevelPicture& picture : levelPictures()) {
            if (isStopped())
                return {};
            if (texture_.mipmaps == MipPolicy::FromFile || picture.number > 0)
                takePicture(picture, face);
        }
    }
    return readsMemory() && readsFirst_ == ReadsFirst::No ? readLevels() : Result<void>();
}

/// Each given level may name a picture as large as a file may be, and many textures may name the same one. A
/// step may enlarge a volume's slices.
Result<void> LevelMaker::checkRoom() const {
    PlannedLevel level = fullExtentsOf(base_);
    for (std::size_t i = 0; i < texture_.preparation.size(); ++i) {
        level = resizedBy(texture_.preparation[i], level);
        const auto texels = static_cast<double>(level.width) * level.height * level.depth;
        if (4 * texels > static_cast<double>(sceneImageBytes))
            return fail(ErrorCode::TooLarge,
                        Sentence("preparation[{0}]: an image of {1} texels needs more than {2}", i,
                                 ProperName{fmt::format("{:.0f}", texels)},
                                 ProperName{sceneImageBytesText()}));
    }
    if (texture_.mipmaps != MipPolicy::Given)
        return {};
    std::uint64_t bytes = 0;
    for (const LevelPicture& picture : levelPictures()) {
        if (picture.number > 0 && !picture.fitted)
            bytes += std::uint64_t{byteCount(picture.image->surface(0, 0))} *
                     static_cast<std::uint64_t>(facesOf(target_));
    }
    if (bytes <= sceneImageBytes)
        return {};
    return fail(ErrorCode::TooLarge,
                Sentence("the images of the levels above the base need {0} bytes, but may have at most "
                         "{1} together",
                         bytes, ProperName{sceneImageBytesText()}));
}

/// Notes the missing files other than the base's.
void LevelMaker::noteMissing() {
    const auto reason = [](const std::string& file) {
        return file.empty() ? Sentence("no file is chosen") : Sentence("{0} is not loaded", ProperName{file});
    };
    const auto first = static_cast<std::size_t>(base_.place);
    for (std::size_t i = first; i < texture_.levels.size() && texture_.mipmaps == MipPolicy::Given; ++i) {
        if (!holdsPicture(pictures_.level(i)))
            note(Sentence("levels[{0}]: {1}; uploaded without it", i, reason(texture_.levels[i].file)));
    }
    for (std::size_t i = 0; i < texture_.preparation.size(); ++i) {
        const ImageStep& step = texture_.preparation[i];
        if (readsOther(step) && !holdsPicture(pictures_.other(i)))
            note(Sentence("preparation[{0}]: {1}; skipped", i, reason(step.file)));
    }
}

void LevelMaker::leaveOneOut() {
    const int missing = missingLevel(out_.levels.empty() ? 0 : out_.levels.back().number + 1);
    if (missing < 0)
        return note("there is only a base level: none can be missing");
    for (std::size_t i = out_.levels.size(); i-- > 0;) {
        if (out_.levels[i].number != missing)
            continue;
        out_.levels.erase(out_.levels.begin() + static_cast<std::ptrdiff_t>(i));
        if (!out_.source.empty())
            out_.source.erase(out_.source.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

/// Each level for itself, after it was made of those that are not rounded.
void LevelMaker::roundToBits() {
    if (isDepth(out_.internalFormat)) {
        const int bits = factsOf(out_.internalFormat).bits[0];
        for (TextureLevel& level : out_.levels) {
            const Image* image = std::get_if<Image>(&*level.surface);
            if (image && (image->format != PixelFormat::Depth32 || bits < lightDepthBits || level.memory))
                level.surface = depthsOf(*image, bits);
        }
        return;
    }
    if (keepsFloats()) {
        for (TextureLevel& level : out_.levels) {
            if (const Image* image = std::get_if<Image>(&*level.surface))
                level.surface = stored(*image);
        }
        return;
    }
    if (!hasFewBits(out_.internalFormat) || out_.driverFormat)
        return;
    for (TextureLevel& level : out_.levels) {
        if (const Image* image = std::get_if<Image>(&*level.surface))
            level.surface = withStoredNumbers(*image, out_.internalFormat);
        level.memory.reset(); // the driver may store more bits
    }
}

Result<TextureLevels> LevelMaker::run() {
    if (isDepth(texture_.internalFormat) && !takesDepths(target_))
        return fail(ErrorCode::Unsupported,
                    Sentence("OpenGL has no depth textures for {0}", rowOf(target_).name));
    if (base_.image->faces > 1 && !isCube())
        note(Sentence("the file is a cube map of {0} faces; the first, +x, is drawn", base_.image->faces));
    if (const Result<void> room = checkRoom(); !room)
        return fail(room.error());
    noteMissing();
    if (!fallback_.empty())
        note(fallback_);
    out_.lateFlip = lateFlipOf(texture_, *base_.image, target_);
    if (texture_.mipmaps == MipPolicy::FromFile)
        out_.lastLevel = levelPictures().back().number;

    takesBlocks_ = keepsBlocks();
    if (takesBlocks_) {
        if (const Result<void> taken = takeBlocks(); !taken)
            return fail(taken.error());
    } else {
        if (const Result<void> taken = takePixels(); !taken)
            return fail(taken.error());
        if (isStopped())
            return fail(ErrorCode::Cancelled, "making its levels was cancelled");
        if (const Result<void> compressed = compress(); !compressed)
            return fail(compressed.error());
    }
    if (texture_.mipmaps == MipPolicy::Missing)
        leaveOneOut();
    replaceInLevels();
    out_.internalFormat = texture_.internalFormat;
    roundToBits();
    return std::move(out_);
}

} // namespace texplorer
