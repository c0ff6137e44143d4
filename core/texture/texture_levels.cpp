#include "core/texture/texture_levels.h"

#include "core/image/border.h"
#include "core/image/cube_faces.h"
#include "core/image/depth_pixels.h"
#include "core/image/power_of_two.h"
#include "core/image/preparation.h"
#include "core/image/resample.h"
#include "core/image/stored_numbers.h"
#include "core/s3tc/decode.h"
#include "core/s3tc/flip.h"
#include "core/s3tc/surface_pixels.h"
#include "core/texture/image_budget.h"
#include "core/texture/level_plan.h"
#include "core/texture/target_image.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <new>
#include <span>

namespace texplorer {

namespace {

std::string extentsOf(const Surface& surface) {
    return fmt::format("{} x {}", widthOf(surface), heightOf(surface));
}

std::array<std::uint8_t, 3> stencil(const Texture& texture) {
    const auto byte = [&](int i) {
        return static_cast<std::uint8_t>(std::lround(255 * std::clamp(texture.stencilColor[i], 0.0F, 1.0F)));
    };
    return {byte(0), byte(1), byte(2)};
}

/// The slice that stands for a volume where a picture is wanted: that of imageForTarget.
BlockImage middleSlice(const BlockImage& from) {
    BlockImage slice = BlockImage::uninitialised(from.format, from.width, from.height);
    const auto first = static_cast<std::ptrdiff_t>(slice.blocks.size()) * (from.depth / 2);
    std::copy_n(from.blocks.begin() + first, slice.blocks.size(), slice.blocks.begin());
    return slice;
}

bool areDepths(const TextureImage& image) {
    const Image* base = image.surfaces.empty() ? nullptr : std::get_if<Image>(&image.surfaces.front());
    return base && base->format == PixelFormat::Depth32;
}

/// The settings that count for an image. What the light sees stays as it is in a depth texture: an average of
/// depths is the depth of nothing.
Texture settingsFor(const Texture& texture, const TextureImage& image) {
    Texture settings = texture;
    if (!areDepths(image) || !isDepth(texture.internalFormat))
        return settings;
    if (texture.mipmaps != MipPolicy::FromFile)
        settings.mipmaps = MipPolicy::None;
    settings.npot = NpotPolicy::Keep;
    settings.transparency = Transparency::File;
    settings.levels.clear();
    settings.preparation.clear();
    return settings;
}

/// Whether there is a picture, be it an outline.
bool holdsPicture(const TextureImage* image) {
    return image && !image->surfaces.empty() && byteCount(image->surfaces.front()) > 0;
}

/// What a level is made of.
struct LevelPicture {
    int number = 0;                      ///< GL's
    const TextureImage* image = nullptr; ///< never null
    SourceKind source = SourceKind::Pattern;
    int fileLevel = 0;   ///< which of the image's levels
    bool fitted = false; ///< it is scaled to the size that the level has to have
};

class Preparation {
public:
    /// `pictures` has a base. `lends`: whether its surfaces may be lent.
    Preparation(const Texture& texture, const TexturePictures& pictures, Target target, const LevelWork& work,
                bool lends = false)
        : texture_(settingsFor(texture, *pictures.base))
        , pictures_(pictures)
        , image_(*pictures.base)
        , lends_(lends)
        , target_(target)
        , work_(work) {}

    Result<TextureLevels> run();
    [[nodiscard]] LevelPlan plan();
    void eachStep(const std::function<void(const Image&)>& visit) const;

private:
    /// Whether rows are wanted as a naive loader gives them to OpenGL: the file's first row first.
    [[nodiscard]] bool fileOrder(SourceKind source) const {
        const bool drawnHere = isCube() && source == SourceKind::Pattern; // has no file
        return !drawnHere && (texture_.flip == FlipMode::Coordinates || texture_.flip == FlipMode::Matrix ||
                              texture_.flip == FlipMode::None);
    }
    /// Whether the top row of a picture goes to t = 0. What is turned later, is turned with the base level.
    [[nodiscard]] bool isTopFirst(const LevelPicture& picture) const {
        if (!fileOrder(picture.source))
            return isCube();
        const bool turnedLater = !isCube() && texture_.flip != FlipMode::None;
        return turnedLater ? image_.fileTopFirst : picture.image->fileTopFirst;
    }
    /// Whether the rows have to change places before the upload.
    [[nodiscard]] bool turns(const LevelPicture& picture) const {
        return picture.image->topFirst != isTopFirst(picture);
    }
    /// Then the top row of a picture goes to t = 0 (core/image/cube_faces.h).
    [[nodiscard]] bool isCube() const { return target_ == Target::CubeMap; }
    /// Whether the faces of a cube map have to be found in one picture.
    [[nodiscard]] bool cutsFaces(const TextureImage& image) const {
        const Surface& whole = image.surface(0, 0);
        return isCube() && image.faces != cubeFaceCount &&
               cubeLayout(widthOf(whole), heightOf(whole)) != CubeLayout::Same;
    }
    /// What is made until then is of no use.
    [[nodiscard]] bool isStopped() const { return work_.stop.stop_requested(); }
    [[nodiscard]] bool prepares() const { return !texture_.preparation.empty(); }
    /// Whether levels above the base have pictures of their own.
    [[nodiscard]] bool hasPictures() const {
        return texture_.mipmaps == MipPolicy::FromFile || texture_.mipmaps == MipPolicy::Given;
    }
    [[nodiscard]] bool generates() const {
        return texture_.mipmaps == MipPolicy::Generated || texture_.mipmaps == MipPolicy::Colored ||
               texture_.mipmaps == MipPolicy::Missing;
    }
    [[nodiscard]] bool hasBorder() const { return texture_.border != 0; }
    [[nodiscard]] const Surface& base() const { return image_.surface(0, 0); }
    [[nodiscard]] LevelPicture basePicture() const { return {0, &image_, texture_.source}; }
    /// A file without faces has the same for all.
    [[nodiscard]] static const Surface& surface(const TextureImage& image, int face, int level) {
        return image.surface(image.faces == cubeFaceCount ? face : 0, level);
    }

    [[nodiscard]] int levelCount() const;
    [[nodiscard]] std::vector<LevelPicture> levelPictures() const;
    [[nodiscard]] PlannedLevel extentsOfPicture(const LevelPicture& picture) const;
    [[nodiscard]] PlannedLevel withoutOwnBorder(PlannedLevel level) const;
    [[nodiscard]] PlannedLevel extentsOfBase() const;
    [[nodiscard]] bool keepsBlocks();
    [[nodiscard]] bool haveSameBlocks();
    [[nodiscard]] Result<void> takeBlocks();
    [[nodiscard]] Image decoded(const TextureImage& image, int face, int level, bool turned) const;
    template<class Visit>
    [[nodiscard]] Image preparedPart(Image part, bool topFirst, int face, const Visit& visit) const;
    [[nodiscard]] Image pixels(const LevelPicture& picture, int face) const;
    [[nodiscard]] bool isTakenAsItIs(const LevelPicture& picture, const Surface& surface) const;
    [[nodiscard]] SharedSurface lend(const Surface& surface) const;
    void takePixels();
    void takePicture(const LevelPicture& picture, int face);
    void takeMade(int face);
    [[nodiscard]] Result<void> checkRoom() const;
    void noteMissing();
    [[nodiscard]] Result<void> compress();
    [[nodiscard]] Result<void> compressHere();
    [[nodiscard]] Result<void> compressHere(std::span<TextureLevel> levels);
    void leaveOneOut();
    void roundToBits();
    void note(std::string sentence) { out_.notes.push_back(std::move(sentence)); }

    const Texture texture_;
    const TexturePictures& pictures_;
    const TextureImage& image_; ///< the base's
    bool lends_;
    Target target_;
    const LevelWork& work_;
    TextureLevels out_;
};

/// How many levels of the base's file are taken.
int Preparation::levelCount() const {
    if (texture_.mipmaps != MipPolicy::FromFile)
        return 1;
    const PlannedLevel first = extentsOfPicture(basePicture());
    const int full = mipLevelCount(first.width, first.height, first.depth);
    return std::min(image_.levels, full);
}

/// Those of all levels that aren't made of others.
std::vector<LevelPicture> Preparation::levelPictures() const {
    std::vector<LevelPicture> pictures;
    for (int level = 0; level < levelCount(); ++level)
        pictures.push_back({level, &image_, texture_.source, level});
    if (texture_.mipmaps != MipPolicy::Given)
        return pictures;
    for (std::size_t i = 0; i < texture_.levels.size(); ++i) {
        const SourceKind source = texture_.levels[i].source;
        if (const TextureImage* image = pictures_.level(i); holdsPicture(image))
            pictures.push_back({static_cast<int>(i) + 1, image, source, 0, source == SourceKind::Pattern});
    }
    return pictures;
}

bool Preparation::keepsBlocks() {
    if (!std::holds_alternative<BlockImage>(base()) || texture_.compression != Compression::FromFile)
        return false;
    if (isDepth(texture_.internalFormat)) {
        note("OpenGL has no compressed depth textures: decompressed");
        return false;
    }
    if (axesOf(target_) != 2) {
        note("OpenGL has compressed pictures only: decompressed for " + std::string(rowOf(target_).name));
        return false;
    }
    if (cutsFaces(image_)) {
        note("cutting the faces of a cube map out of a picture needs pixels: decompressed");
        return false;
    }
    if (hasBorder()) {
        note("OpenGL has compressed textures without a border only: decompressed");
        return false;
    }
    if (generates()) {
        note(fmt::format(
            "the mip levels are made of pixels, so the compressed image was decompressed; mipmaps={} keeps "
            "the file's blocks",
            rowOf(MipPolicy::FromFile).name));
        return false;
    }
    if (texture_.npot == NpotPolicy::PowerOfTwo && texture_.mipmaps != MipPolicy::FromFile &&
        !arePowersOfTwo(widthOf(base()), heightOf(base()), depthOf(base()))) {
        note(fmt::format("scaling {} to powers of two needs pixels: decompressed", extentsOf(base())));
        return false;
    }
    if (texture_.transparency != Transparency::File) {
        note("another transparency than that of the file needs pixels: decompressed");
        return false;
    }
    if (prepares()) {
        note("what is done to the image before needs pixels: decompressed");
        return false;
    }
    if (!haveSameBlocks())
        return false;
    for (const LevelPicture& picture : levelPictures()) {
        if (!turns(picture))
            continue;
        if (texture_.flip == FlipMode::Pixels)
            return false;
        const Surface& surface = picture.image->surface(0, picture.fileLevel);
        if (flipsWithoutLoss(heightOf(surface)))
            continue;
        note(fmt::format(
            "level {} has {} texels: its blocks can't be turned around without loss, for which a height must "
            "be {}; the texture was decompressed and its pixels flipped",
            picture.number, extentsOf(surface), losslessExtents));
        return false;
    }
    return true;
}

/// A texture has one format for all of its levels.
bool Preparation::haveSameBlocks() {
    const BlockFormat format = std::get<BlockImage>(base()).format;
    for (const LevelPicture& picture : levelPictures()) {
        const auto* blocks = std::get_if<BlockImage>(&picture.image->surface(0, picture.fileLevel));
        if (blocks && blocks->format == format && !cutsFaces(*picture.image))
            continue;
        note(fmt::format("the base level is compressed as {} and level {} is not: all are decompressed",
                         rowOf(format).name, picture.number));
        return false;
    }
    return true;
}

Result<void> Preparation::takeBlocks() {
    for (int face = 0; face < facesOf(target_); ++face) {
        for (const LevelPicture& picture : levelPictures()) {
            const auto& from = std::get<BlockImage>(surface(*picture.image, face, picture.fileLevel));
            BlockImage blocks = from.depth > 1 ? middleSlice(from) : from;
            if (turns(picture)) {
                if (const Result<void> flipped = flipVertically(blocks); !flipped)
                    return fail(flipped.error());
            }
            out_.levels.push_back({picture.number, std::move(blocks), face});
        }
    }
    return {};
}

/// One face's part of an image for the target, with its rows turned around or not; for a line the picture.
Image Preparation::decoded(const TextureImage& image, int face, int level, bool turned) const {
    const Target picked = axesOf(target_) == 3 ? Target::Texture3D : Target::Texture2D;
    const Surface& from = surface(image, face, level);
    Image part;
    if (const Image* pixels = std::get_if<Image>(&from))
        part = imageForTarget(*pixels, picked);
    else {
        const auto& blocks = std::get<BlockImage>(from);
        part = decodeBlocks(picked == Target::Texture2D && blocks.depth > 1 ? middleSlice(blocks) : blocks);
    }
    if (!isDepth(texture_.internalFormat))
        part = greysOf(std::move(part));
    if (turned)
        flipVertically(part);
    return cutsFaces(image) ? cubeFace(part, face) : part;
}

/// The part of a picture after all steps; visit(part) after each. `topFirst`: whether row 0 is the top one.
template<class Visit>
Image Preparation::preparedPart(Image part, bool topFirst, int face, const Visit& visit) const {
    for (std::size_t i = 0; i < texture_.preparation.size() && !isStopped(); ++i) {
        const ImageStep& step = texture_.preparation[i];
        const TextureImage* from = step.op == ImageOp::AlphaFrom ? pictures_.other(i) : nullptr;
        Image other;
        if (from && hasPixels(*from))
            other = decoded(*from, face, 0, from->topFirst != topFirst);
        part = prepared(std::move(part), {step.op, step.factor, step.bias, step.amount, &other});
        visit(part);
    }
    return part;
}

/// One face's part of a level for the target, the right way up.
Image Preparation::pixels(const LevelPicture& picture, int face) const {
    Image part = preparedPart(decoded(*picture.image, face, picture.fileLevel, turns(picture)),
                              isTopFirst(picture), face, [](const Image&) {});
    if (texture_.transparency != Transparency::File)
        part = applyTransparency(std::move(part), texture_.transparency, stencil(texture_));
    // A line is the middle row of the picture as it is uploaded: it is taken after the flip.
    return target_ == Target::Texture1D ? imageForTarget(part, target_) : part;
}

void Preparation::eachStep(const std::function<void(const Image&)>& visit) const {
    Image first = decoded(image_, 0, 0, turns(basePicture()));
    visit(first);
    static_cast<void>(preparedPart(std::move(first), isTopFirst(basePicture()), 0, visit));
}

/// Whether `pixels` and a policy's base would be a copy and nothing else.
bool Preparation::isTakenAsItIs(const LevelPicture& picture, const Surface& surface) const {
    const Image* image = std::get_if<Image>(&surface);
    const bool whole = image && (image->depth == 1 || axesOf(target_) == 3) &&
                       (target_ != Target::Texture1D || image->height == 1) &&
                       (image->format != PixelFormat::Depth32 || isDepth(texture_.internalFormat));
    return lends_ && whole && picture.image == &image_ && !picture.fitted && !turns(picture) &&
           !cutsFaces(image_) && !hasBorder() && !prepares() && texture_.transparency == Transparency::File &&
           (texture_.npot != NpotPolicy::PowerOfTwo || texture_.mipmaps == MipPolicy::FromFile ||
            arePowersOfTwo(image->width, image->height, image->depth));
}

SharedSurface Preparation::lend(const Surface& surface) const {
    return SharedSurface(std::shared_ptr<const Surface>(pictures_.base, &surface));
}

/// A level that has a picture of its own: one of the base's file, or a given one.
void Preparation::takePicture(const LevelPicture& picture, int face) {
    if (const Surface& from = surface(*picture.image, face, picture.fileLevel);
        isTakenAsItIs(picture, from)) {
        out_.levels.push_back({picture.number, lend(from), face});
        return;
    }
    Image image = pixels(picture, face);
    const bool repeatsEdges = texture_.mipmaps == MipPolicy::FromFile || picture.fitted ||
                              !hasBorderExtents(image, axesOf(target_));
    if (picture.fitted) {
        const PlannedLevel fit = levelAbove(extentsOfBase(), picture.number);
        image = scaleByCoverage(image, fit.width, fit.height, fit.depth);
    }
    if (hasBorder() && repeatsEdges)
        image = repeatEdges(image, axesOf(target_));
    out_.levels.push_back({picture.number, std::move(image), face});
}

/// The base, and what the policy makes of it.
void Preparation::takeMade(int face) {
    const MipOptions options{texture_.mipFilter, texture_.mipGamma, texture_.npot};
    MipChain chain;
    int number = 0;
    if (const Surface& from = surface(image_, face, 0); isTakenAsItIs(basePicture(), from)) {
        out_.levels.push_back({number++, lend(from), face});
        chain = mipLevelsAbove(texture_.mipmaps, std::get<Image>(from), options);
    } else if (hasBorder())
        chain =
            applyMipPolicyWithBorder(texture_.mipmaps, pixels(basePicture(), face), axesOf(target_), options);
    else
        chain = applyMipPolicy(texture_.mipmaps, pixels(basePicture(), face), options);
    for (Image& level : chain)
        out_.levels.push_back({number++, std::move(level), face});
}

void Preparation::takePixels() {
    out_.border = hasBorder() ? 1 : 0;
    for (int face = 0; face < facesOf(target_); ++face) {
        if (texture_.mipmaps != MipPolicy::FromFile)
            takeMade(face);
        for (const LevelPicture& picture : levelPictures()) {
            if (isStopped())
                return;
            if (texture_.mipmaps == MipPolicy::FromFile || picture.number > 0)
                takePicture(picture, face);
        }
    }
}

/// Each given level may name a picture as large as a file may be, and many textures may name the same one.
Result<void> Preparation::checkRoom() const {
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
                fmt::format("the pictures of the levels above its base need {} bytes, and together they may "
                            "take {}",
                            bytes, sceneImageBytesText()));
}

/// Of the files that are wanted beside the base's.
void Preparation::noteMissing() {
    const auto reason = [](const std::string& file) {
        return file.empty() ? std::string("no file is chosen") : file + " is not loaded";
    };
    for (std::size_t i = 0; i < texture_.levels.size() && texture_.mipmaps == MipPolicy::Given; ++i) {
        if (!holdsPicture(pictures_.level(i)))
            note(fmt::format("levels[{}]: {}; uploaded without it", i, reason(texture_.levels[i].file)));
    }
    for (std::size_t i = 0; i < texture_.preparation.size(); ++i) {
        const ImageStep& step = texture_.preparation[i];
        if (step.op == ImageOp::AlphaFrom && !holdsPicture(pictures_.other(i)))
            note(fmt::format("preparation[{}]: {}; left out", i, reason(step.file)));
    }
}

Result<void> Preparation::compress() {
    if (texture_.compression != Compression::Driver && texture_.compression != Compression::Cached)
        return {};
    if (isDepth(texture_.internalFormat)) {
        note("OpenGL has no compressed depth textures: not compressed");
        return {};
    }
    if (axesOf(target_) != 2) {
        note("OpenGL has compressed pictures only: not compressed for " + std::string(rowOf(target_).name));
        return {};
    }
    if (hasBorder()) {
        note("OpenGL has compressed textures without a border only: not compressed");
        return {};
    }
    if (texture_.compression == Compression::Cached)
        return compressHere();
    out_.driverFormat = blockFormat(texture_.compressedFormat);
    return {};
}

/// From the cache, else anew and then kept there. Each face of a cube map is kept for itself, and each level
/// where it need not have half the size of the one before.
Result<void> Preparation::compressHere() {
    const auto perFace = texture_.mipmaps == MipPolicy::Given
                             ? 1
                             : out_.levels.size() / static_cast<std::size_t>(facesOf(target_));
    out_.fromCache = true;
    for (std::size_t first = 0; first < out_.levels.size(); first += perFace) {
        if (Result<void> made = compressHere(std::span(out_.levels).subspan(first, perFace)); !made)
            return made;
    }
    return {};
}

Result<void> Preparation::compressHere(std::span<TextureLevel> levels) {
    const BlockFormat format = blockFormat(texture_.compressedFormat);
    MipChain source;
    for (TextureLevel& level : levels)
        source.push_back(std::get<Image>(std::move(level.surface).take()));
    const std::filesystem::path file = work_.cache.fileFor(source, format, texture_.compressionQuality);
    auto blocks = work_.cache.find(file, source, format);
    out_.fromCache = out_.fromCache && blocks.has_value();
    if (!blocks) {
        auto made = encodeLevels(source, format, texture_.compressionQuality, work_.progress, work_.stop);
        if (!made)
            return fail(made.error());
        if (const Result<void> kept = work_.cache.keep(file, *made); !kept)
            note("the compressed levels are not kept for the next time: " + describe(kept.error()));
        blocks = *std::move(made);
    }
    for (std::size_t i = 0; i < levels.size(); ++i)
        levels[i].surface = std::move((*blocks)[i]);
    std::ranges::move(source, std::back_inserter(out_.source));
    return {};
}

void Preparation::leaveOneOut() {
    const int missing = missingLevel(out_.levels.empty() ? 0 : out_.levels.back().number + 1);
    if (missing < 0)
        return note("there is only a base level: none can be left out");
    for (std::size_t i = out_.levels.size(); i-- > 0;) {
        if (out_.levels[i].number != missing)
            continue;
        out_.levels.erase(out_.levels.begin() + static_cast<std::ptrdiff_t>(i));
        if (!out_.source.empty())
            out_.source.erase(out_.source.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

/// Each level for itself, after it was made of those that are not rounded.
void Preparation::roundToBits() {
    if (isDepth(out_.internalFormat)) {
        const int bits = factsOf(out_.internalFormat).bits[0];
        for (TextureLevel& level : out_.levels) {
            const Image* image = std::get_if<Image>(&*level.surface);
            if (image && (image->format != PixelFormat::Depth32 || bits < lightDepthBits))
                level.surface = depthsOf(*image, bits);
        }
        return;
    }
    if (!hasFewBits(out_.internalFormat) || out_.driverFormat)
        return;
    for (TextureLevel& level : out_.levels) {
        if (const Image* image = std::get_if<Image>(&*level.surface))
            level.surface = withStoredNumbers(*image, out_.internalFormat);
    }
}

Result<TextureLevels> Preparation::run() {
    if (isDepth(texture_.internalFormat) && !takesDepths(target_))
        return fail(ErrorCode::Unsupported,
                    "OpenGL has no depth textures for " + std::string(rowOf(target_).name));
    if (image_.faces > 1 && !isCube())
        note(fmt::format("the file is a cube map of {} faces; its first, +x, is drawn", image_.faces));
    if (const Result<void> room = checkRoom(); !room)
        return fail(room.error());
    noteMissing();
    if (fileOrder(texture_.source) && !isCube() && texture_.flip != FlipMode::None && image_.fileTopFirst)
        out_.lateFlip = texture_.flip == FlipMode::Coordinates ? LateFlip::Coordinates : LateFlip::Matrix;
    if (texture_.mipmaps == MipPolicy::FromFile)
        out_.lastLevel = levelCount() - 1;

    if (keepsBlocks()) {
        if (const Result<void> taken = takeBlocks(); !taken)
            return fail(taken.error());
    } else {
        takePixels();
        if (isStopped())
            return fail(ErrorCode::Cancelled, "making its levels was cancelled");
        if (const Result<void> compressed = compress(); !compressed)
            return fail(compressed.error());
    }
    if (texture_.mipmaps == MipPolicy::Missing)
        leaveOneOut();
    out_.internalFormat = texture_.internalFormat;
    roundToBits();
    return std::move(out_);
}

/// The part of a picture that the target takes.
PlannedLevel Preparation::extentsOfPicture(const LevelPicture& picture) const {
    const Surface& surface = picture.image->surface(0, picture.fileLevel);
    if (cutsFaces(*picture.image)) {
        const auto [width, height] = cubeFaceExtents(widthOf(surface), heightOf(surface));
        return {picture.number, width, height, 1};
    }
    return {picture.number, widthOf(surface), target_ == Target::Texture1D ? 1 : heightOf(surface),
            target_ == Target::Texture3D ? depthOf(surface) : 1};
}

/// What is left where the outermost texels are taken for the border.
PlannedLevel Preparation::withoutOwnBorder(PlannedLevel level) const {
    const int axes = axesOf(target_);
    if (!hasBorder() || !hasBorderExtents(level.width, level.height, level.depth, axes))
        return level;
    return {level.number, level.width - 2, level.height - (axes > 1 ? 2 : 0),
            level.depth - (axes > 2 ? 2 : 0)};
}

/// As it is uploaded, without its border.
PlannedLevel Preparation::extentsOfBase() const {
    const PlannedLevel whole = extentsOfPicture(basePicture());
    const PlannedLevel level = withoutOwnBorder(whole);
    if (level != whole || texture_.npot != NpotPolicy::PowerOfTwo)
        return level;
    return {0, nearestPowerOfTwo(level.width), nearestPowerOfTwo(level.height),
            nearestPowerOfTwo(level.depth)};
}

LevelPlan Preparation::plan() {
    LevelPlan plan;
    if (isDepth(texture_.internalFormat) && !takesDepths(target_))
        return plan;
    if (texture_.mipmaps == MipPolicy::FromFile)
        plan.lastLevel = levelCount() - 1;
    for (const LevelPicture& picture : levelPictures())
        plan.levels.push_back(extentsOfPicture(picture));
    if (keepsBlocks()) {
        plan.blocks = std::get<BlockImage>(base()).format;
        return plan;
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
            plan.levels.push_back(picture.fitted ? levelAbove(level, picture.number)
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

Result<TextureLevels> run(const Texture& texture, const TexturePictures& pictures, Target target,
                          const LevelWork& work, bool lends) {
    const TextureImage& image = *pictures.base;
    if (!hasPixels(image))
        return fail(ErrorCode::Malformed, "the image is empty");
    try {
        Result<TextureLevels> made = Preparation(texture, pictures, target, work, lends).run();
        if (made && settingsFor(texture, image).mipmaps != texture.mipmaps)
            made->notes.emplace_back("what the light sees has no mip levels: there is only a base level");
        return made;
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge,
                    fmt::format("there is no memory for the levels of an image of {} texels",
                                extentsOf(image.surfaces.front())));
    }
}

} // namespace

PlannedLevel levelAbove(const PlannedLevel& base, int number) {
    const auto extent = [number](int texels) { return std::max(1, texels >> number); };
    return {number, extent(base.width), extent(base.height), extent(base.depth)};
}

LevelPlan planLevels(const Texture& texture, const TexturePictures& pictures, Target target) {
    return holdsPicture(pictures.base.get()) ? Preparation(texture, pictures, target, {}).plan()
                                             : LevelPlan{};
}

Result<TextureLevels> prepareLevels(const Texture& texture, const TextureImage& image, Target target,
                                    const LevelWork& work) {
    const TexturePictures pictures(std::shared_ptr<const TextureImage>(std::shared_ptr<void>(), &image));
    return run(texture, pictures, target, work, false);
}

Result<TextureLevels> prepareLevels(const Texture& texture, const TexturePictures& pictures, Target target,
                                    const LevelWork& work) {
    return run(texture, pictures, target, work, true);
}

void eachPreparationStep(const Texture& texture, const TexturePictures& pictures,
                         const std::function<void(const Image&)>& visit, const std::stop_token& stop) {
    if (!pictures.base || !hasPixels(*pictures.base))
        return;
    Texture upright = texture;
    upright.flip = FlipMode::Pixels;
    const LevelWork work{.cache = {}, .stop = stop};
    Preparation(upright, pictures, Target::Texture2D, work).eachStep(visit);
}

std::vector<Image> preparationOf(const Texture& texture, const TexturePictures& pictures) {
    std::vector<Image> images;
    eachPreparationStep(texture, pictures, [&images](const Image& image) { images.push_back(image); });
    return images;
}

void decompress(TextureLevels& levels) {
    for (TextureLevel& level : levels.levels) {
        if (const auto* blocks = std::get_if<BlockImage>(&*level.surface))
            levels.internalFormat = internalFormat(baseFormat(blocks->format));
        level.surface = toImage(std::move(level.surface).take());
    }
    if (levels.driverFormat)
        levels.internalFormat = internalFormat(baseFormat(*levels.driverFormat));
    levels.driverFormat.reset();
}

Texture imageSettings(const Texture& texture) {
    Texture settings = texture;
    static_cast<SamplerState&>(settings) = {};
    settings.priority = Texture{}.priority;
    return settings;
}

} // namespace texplorer
