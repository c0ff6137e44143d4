#include "core/texture/texture_levels.h"

#include "core/image/border.h"
#include "core/image/cube_faces.h"
#include "core/image/power_of_two.h"
#include "core/image/resample.h"
#include "core/s3tc/decode.h"
#include "core/s3tc/flip.h"
#include "core/s3tc/surface_pixels.h"
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

class Preparation {
public:
    /// `lender`: the image again where its surfaces may be lent, else null.
    Preparation(const Texture& texture, const TextureImage& image, Target target, const LevelWork& work,
                std::shared_ptr<const TextureImage> lender = nullptr)
        : texture_(texture)
        , image_(image)
        , lender_(std::move(lender))
        , target_(target)
        , work_(work)
        , turn_(fileOrder() ? image.topFirst != image.fileTopFirst : image.topFirst != isCube()) {}

    Result<TextureLevels> run();
    [[nodiscard]] LevelPlan plan();

private:
    /// Whether rows are wanted as a naive loader gives them to OpenGL: the file's first row first.
    [[nodiscard]] bool fileOrder() const {
        const bool drawnHere = isCube() && texture_.source == SourceKind::Pattern; // has no file
        return !drawnHere && (texture_.flip == FlipMode::Coordinates || texture_.flip == FlipMode::Matrix ||
                              texture_.flip == FlipMode::None);
    }
    /// Then the top row of a picture goes to t = 0 (core/image/cube_faces.h).
    [[nodiscard]] bool isCube() const { return target_ == Target::CubeMap; }
    /// Whether the faces of a cube map have to be found in one picture.
    [[nodiscard]] bool cutsFaces() const {
        return isCube() && image_.faces != cubeFaceCount &&
               cubeLayout(widthOf(base()), heightOf(base())) != CubeLayout::Same;
    }
    [[nodiscard]] bool generates() const {
        return texture_.mipmaps == MipPolicy::Generated || texture_.mipmaps == MipPolicy::Colored ||
               texture_.mipmaps == MipPolicy::Missing;
    }
    [[nodiscard]] bool hasBorder() const { return texture_.border != 0; }
    [[nodiscard]] const Surface& base() const { return image_.surface(0, 0); }
    /// A file without faces has the same for all.
    [[nodiscard]] const Surface& surface(int face, int level) const {
        return image_.surface(image_.faces == cubeFaceCount ? face : 0, level);
    }

    [[nodiscard]] int levelCount() const;
    [[nodiscard]] PlannedLevel extentsFor(int number) const;
    [[nodiscard]] bool keepsBlocks();
    [[nodiscard]] Result<void> takeBlocks();
    [[nodiscard]] Image pixels(int face, int level) const;
    [[nodiscard]] bool isTakenAsItIs(const Surface& surface) const;
    [[nodiscard]] SharedSurface lend(const Surface& surface) const;
    void takePixels();
    void takeFromFile(int face);
    void takeMade(int face);
    [[nodiscard]] Result<void> compress();
    [[nodiscard]] Result<void> compressHere();
    [[nodiscard]] Result<void> compressHere(std::span<TextureLevel> levels);
    void leaveOneOut();
    void note(std::string sentence) { out_.notes.push_back(std::move(sentence)); }

    const Texture& texture_;
    const TextureImage& image_;
    std::shared_ptr<const TextureImage> lender_;
    Target target_;
    const LevelWork& work_;
    bool turn_; ///< whether the rows have to change places before the upload
    TextureLevels out_;
};

/// How many levels of the file are taken.
int Preparation::levelCount() const {
    if (texture_.mipmaps != MipPolicy::FromFile)
        return 1;
    const PlannedLevel first = extentsFor(0);
    const int full = mipLevelCount(first.width, first.height, first.depth);
    return std::min(image_.levels, full);
}

bool Preparation::keepsBlocks() {
    if (!std::holds_alternative<BlockImage>(base()) || texture_.compression != Compression::FromFile)
        return false;
    if (axesOf(target_) != 2) {
        note("OpenGL has compressed pictures only: decompressed for " + std::string(rowOf(target_).name));
        return false;
    }
    if (cutsFaces()) {
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
    if (texture_.npot == NpotPolicy::PowerOfTwo && texture_.mipmaps == MipPolicy::None &&
        !arePowersOfTwo(widthOf(base()), heightOf(base()), depthOf(base()))) {
        note(fmt::format("scaling {} to powers of two needs pixels: decompressed", extentsOf(base())));
        return false;
    }
    if (texture_.transparency != Transparency::File) {
        note("another transparency than that of the file needs pixels: decompressed");
        return false;
    }
    if (!turn_)
        return true;
    if (texture_.flip == FlipMode::Pixels)
        return false;
    for (int level = 0; level < levelCount(); ++level) {
        const Surface& surface = image_.surface(0, level);
        if (flipsWithoutLoss(heightOf(surface)))
            continue;
        note(fmt::format(
            "level {} has {} texels: its blocks can't be turned around without loss, for which a height must "
            "be {}; the texture was decompressed and its pixels flipped",
            level, extentsOf(surface), losslessExtents));
        return false;
    }
    return true;
}

Result<void> Preparation::takeBlocks() {
    for (int face = 0; face < facesOf(target_); ++face) {
        for (int level = 0; level < levelCount(); ++level) {
            const auto& from = std::get<BlockImage>(surface(face, level));
            BlockImage blocks = from.depth > 1 ? middleSlice(from) : from;
            if (turn_) {
                if (const Result<void> flipped = flipVertically(blocks); !flipped)
                    return fail(flipped.error());
            }
            out_.levels.push_back({level, std::move(blocks), face});
        }
    }
    return {};
}

/// One face's part of a level for the target, the right way up.
Image Preparation::pixels(int face, int level) const {
    // A line is the middle row of the picture as it is uploaded: it is taken after the flip.
    const Target picked = axesOf(target_) == 3 ? Target::Texture3D : Target::Texture2D;
    const Surface& from = surface(face, level);
    Image part;
    if (const Image* image = std::get_if<Image>(&from))
        part = imageForTarget(*image, picked);
    else {
        const auto& blocks = std::get<BlockImage>(from);
        part = decodeBlocks(picked == Target::Texture2D && blocks.depth > 1 ? middleSlice(blocks) : blocks);
    }
    if (turn_)
        flipVertically(part);
    if (cutsFaces())
        part = cubeFace(part, face);
    if (texture_.transparency != Transparency::File)
        part = applyTransparency(std::move(part), texture_.transparency, stencil(texture_));
    return target_ == Target::Texture1D ? imageForTarget(part, target_) : part;
}

/// Whether `pixels` and a policy's base would be a copy and nothing else.
bool Preparation::isTakenAsItIs(const Surface& surface) const {
    const Image* image = std::get_if<Image>(&surface);
    const bool whole = image && (image->depth == 1 || axesOf(target_) == 3) &&
                       (target_ != Target::Texture1D || image->height == 1);
    return lender_ && whole && !turn_ && !cutsFaces() && !hasBorder() &&
           texture_.transparency == Transparency::File &&
           (texture_.npot != NpotPolicy::PowerOfTwo || texture_.mipmaps == MipPolicy::FromFile ||
            arePowersOfTwo(image->width, image->height, image->depth));
}

SharedSurface Preparation::lend(const Surface& surface) const {
    return SharedSurface(std::shared_ptr<const Surface>(lender_, &surface));
}

void Preparation::takeFromFile(int face) {
    for (int level = 0; level < levelCount(); ++level) {
        if (const Surface& from = surface(face, level); isTakenAsItIs(from)) {
            out_.levels.push_back({level, lend(from), face});
            continue;
        }
        Image image = pixels(face, level);
        if (hasBorder())
            image = repeatEdges(image, axesOf(target_));
        out_.levels.push_back({level, std::move(image), face});
    }
}

void Preparation::takeMade(int face) {
    const MipOptions options{texture_.mipFilter, texture_.mipGamma, texture_.npot};
    MipChain chain;
    int number = 0;
    if (const Surface& from = surface(face, 0); isTakenAsItIs(from)) {
        out_.levels.push_back({number++, lend(from), face});
        chain = mipLevelsAbove(texture_.mipmaps, std::get<Image>(from), options);
    } else if (hasBorder())
        chain = applyMipPolicyWithBorder(texture_.mipmaps, pixels(face, 0), axesOf(target_), options);
    else
        chain = applyMipPolicy(texture_.mipmaps, pixels(face, 0), options);
    for (Image& level : chain)
        out_.levels.push_back({number++, std::move(level), face});
}

void Preparation::takePixels() {
    out_.border = hasBorder() ? 1 : 0;
    for (int face = 0; face < facesOf(target_); ++face) {
        if (texture_.mipmaps == MipPolicy::FromFile)
            takeFromFile(face);
        else
            takeMade(face);
    }
}

Result<void> Preparation::compress() {
    if (texture_.compression != Compression::Driver && texture_.compression != Compression::Cached)
        return {};
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

/// From the cache, else anew and then kept there. Each face of a cube map is kept for itself.
Result<void> Preparation::compressHere() {
    const auto perFace = out_.levels.size() / static_cast<std::size_t>(facesOf(target_));
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

Result<TextureLevels> Preparation::run() {
    if (image_.faces > 1 && !isCube())
        note(fmt::format("the file is a cube map of {} faces; its first, +x, is drawn", image_.faces));
    if (fileOrder() && !isCube() && texture_.flip != FlipMode::None && image_.fileTopFirst)
        out_.lateFlip = texture_.flip == FlipMode::Coordinates ? LateFlip::Coordinates : LateFlip::Matrix;
    if (texture_.mipmaps == MipPolicy::FromFile)
        out_.lastLevel = levelCount() - 1;

    if (keepsBlocks()) {
        if (const Result<void> taken = takeBlocks(); !taken)
            return fail(taken.error());
    } else {
        takePixels();
        if (const Result<void> compressed = compress(); !compressed)
            return fail(compressed.error());
    }
    if (texture_.mipmaps == MipPolicy::Missing)
        leaveOneOut();
    return std::move(out_);
}

/// The part of a level of the file that the target takes.
PlannedLevel Preparation::extentsFor(int number) const {
    const Surface& surface = image_.surface(0, number);
    if (cutsFaces()) {
        const auto [width, height] = cubeFaceExtents(widthOf(surface), heightOf(surface));
        return {number, width, height, 1};
    }
    return {number, widthOf(surface), target_ == Target::Texture1D ? 1 : heightOf(surface),
            target_ == Target::Texture3D ? depthOf(surface) : 1};
}

LevelPlan Preparation::plan() {
    LevelPlan plan;
    if (texture_.mipmaps == MipPolicy::FromFile)
        plan.lastLevel = levelCount() - 1;
    for (int level = 0; level < levelCount(); ++level)
        plan.levels.push_back(extentsFor(level));
    if (keepsBlocks()) {
        plan.blocks = std::get<BlockImage>(base()).format;
        return plan;
    }
    const bool compresses =
        texture_.compression == Compression::Driver || texture_.compression == Compression::Cached;
    if (compresses && axesOf(target_) == 2 && !hasBorder())
        plan.blocks = blockFormat(texture_.compressedFormat);
    plan.border = hasBorder() ? 1 : 0;
    if (texture_.mipmaps == MipPolicy::FromFile)
        return plan;
    PlannedLevel level = plan.levels.front();
    if (hasBorder() && hasBorderExtents(level.width, level.height, level.depth, axesOf(target_))) {
        level.width -= 2;
        level.height -= axesOf(target_) > 1 ? 2 : 0;
        level.depth -= axesOf(target_) > 2 ? 2 : 0;
    } else if (texture_.npot == NpotPolicy::PowerOfTwo)
        level = {0, nearestPowerOfTwo(level.width), nearestPowerOfTwo(level.height),
                 nearestPowerOfTwo(level.depth)};
    plan.levels = {level};
    if (!generates())
        return plan;
    const int count = mipLevelCount(level.width, level.height, level.depth);
    while (static_cast<int>(plan.levels.size()) < count) {
        const auto half = [](int extent) { return std::max(1, extent / 2); };
        level = {level.number + 1, half(level.width), half(level.height), half(level.depth)};
        plan.levels.push_back(level);
    }
    if (const int missing = missingLevel(count); texture_.mipmaps == MipPolicy::Missing && missing >= 0)
        plan.levels.erase(plan.levels.begin() + missing);
    return plan;
}

Result<TextureLevels> run(const Texture& texture, const TextureImage& image, Target target,
                          const LevelWork& work, std::shared_ptr<const TextureImage> lender) {
    if (!hasPixels(image))
        return fail(ErrorCode::Malformed, "the image is empty");
    try {
        return Preparation(texture, image, target, work, std::move(lender)).run();
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge,
                    fmt::format("there is no memory for the levels of an image of {} texels",
                                extentsOf(image.surfaces.front())));
    }
}

} // namespace

LevelPlan planLevels(const Texture& texture, const TextureImage& image, Target target) {
    if (image.surfaces.empty() || byteCount(image.surfaces.front()) == 0)
        return {};
    return Preparation(texture, image, target, {}).plan();
}

Result<TextureLevels> prepareLevels(const Texture& texture, const TextureImage& image, Target target,
                                    const LevelWork& work) {
    return run(texture, image, target, work, nullptr);
}

Result<TextureLevels> prepareLevels(const Texture& texture, const std::shared_ptr<const TextureImage>& image,
                                    Target target, const LevelWork& work) {
    return run(texture, *image, target, work, image);
}

void decompress(TextureLevels& levels) {
    for (TextureLevel& level : levels.levels)
        level.surface = toImage(std::move(level.surface).take());
    levels.driverFormat.reset();
}

Texture imageSettings(const Texture& texture) {
    Texture settings = texture;
    static_cast<SamplerState&>(settings) = {};
    settings.priority = Texture{}.priority;
    return settings;
}

} // namespace texplorer
