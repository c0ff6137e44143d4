// Levels in blocks: which are kept as the file has them, and which are compressed.

#include "texplorer/base/sentence_format.h"
#include "texplorer/image/depth_pixels.h"
#include "texplorer/image/power_of_two.h"
#include "texplorer/s3tc/decode.h"
#include "texplorer/s3tc/flip.h"
#include "texplorer/texture/level_maker.h"
#include "texplorer/texture/target_image.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

namespace texplorer {

namespace {

std::string extentsOf(const Surface& surface) {
    return fmt::format("{} × {}", widthOf(surface), heightOf(surface));
}

/// The slice that stands for a volume where a picture is wanted: that of imageForTarget.
BlockImage middleSlice(const BlockImage& from) {
    BlockImage slice = BlockImage::uninitialised(from.format, from.width, from.height);
    const auto first = static_cast<std::ptrdiff_t>(slice.blocks.size()) * (from.depth / 2);
    std::copy_n(from.blocks.begin() + first, slice.blocks.size(), slice.blocks.begin());
    return slice;
}

} // namespace

bool LevelMaker::keepsBlocks() {
    if (!std::holds_alternative<BlockImage>(base()) || texture_.compression != Compression::FromFile)
        return false;
    if (isDepth(texture_.internalFormat)) {
        note("OpenGL has no compressed depth textures: decompressed");
        return false;
    }
    if (axesOf(target_) != 2) {
        note(Sentence("OpenGL has compressed pictures only: decompressed for {0}",
                      ProperName{rowOf(target_).name}));
        return false;
    }
    if (cutsFaces(*base_.image)) {
        note("cutting the faces of a cube map needs pixels: decompressed");
        return false;
    }
    if (hasBorder()) {
        note("OpenGL has compressed textures without a border only: decompressed");
        return false;
    }
    if (generates()) {
        note(Sentence("the mip levels are made from pixels, so the compressed image was decompressed; the "
                      "mipmaps \"{0}\" keep the file's blocks",
                      rowOf(MipPolicy::FromFile).label));
        return false;
    }
    if (texture_.npot == NpotPolicy::PowerOfTwo && texture_.mipmaps != MipPolicy::FromFile &&
        !arePowersOfTwo(widthOf(base()), heightOf(base()), depthOf(base()))) {
        note(Sentence("scaling {0} to powers of two needs pixels: decompressed",
                      ProperName{extentsOf(base())}));
        return false;
    }
    if (halvings_ > 0) {
        note("scaling the image down needs pixels: decompressed");
        return false;
    }
    if (texture_.transparency != Transparency::File) {
        note("a transparency other than the file's needs pixels: decompressed");
        return false;
    }
    if (prepares()) {
        note("the preparation of the image needs pixels: decompressed");
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
        note(Sentence(
            "level {0} has {1} texels: its blocks can't be flipped without loss, which needs a height of {2}; "
            "the texture was decompressed and its pixels flipped",
            picture.number, ProperName{extentsOf(surface)}, losslessExtents));
        return false;
    }
    return true;
}

/// A texture has one format for all of its levels.
bool LevelMaker::haveSameBlocks() {
    const BlockFormat format = std::get<BlockImage>(base()).format;
    for (const LevelPicture& picture : levelPictures()) {
        const auto* blocks = std::get_if<BlockImage>(&picture.image->surface(0, picture.fileLevel));
        if (blocks && blocks->format == format && !cutsFaces(*picture.image))
            continue;
        note(Sentence("the base level is compressed as {0} and level {1} is not: all are decompressed",
                      ProperName{rowOf(format).name}, picture.number));
        return false;
    }
    return true;
}

Result<void> LevelMaker::takeBlocks() {
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
Image LevelMaker::decoded(const TextureImage& image, int face, int level, bool turned) const {
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

Result<void> LevelMaker::compress() {
    if (texture_.compression != Compression::Driver && texture_.compression != Compression::Cached)
        return {};
    if (isDepth(texture_.internalFormat)) {
        note("OpenGL has no compressed depth textures: not compressed");
        return {};
    }
    if (axesOf(target_) != 2) {
        note(Sentence("OpenGL has compressed pictures only: not compressed for {0}",
                      ProperName{rowOf(target_).name}));
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

/// Reads the blocks from the cache, or makes them and stores them there. Each face of a cube map is an entry,
/// and so is each level if it need not have half the size of the one before.
Result<void> LevelMaker::compressHere() {
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

Result<void> LevelMaker::compressHere(std::span<TextureLevel> levels) {
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
            note(Sentence("the compressed levels can't be cached: {0}", describe(kept.error())));
        blocks = *std::move(made);
    }
    for (std::size_t i = 0; i < levels.size(); ++i)
        levels[i].surface = std::move((*blocks)[i]);
    std::ranges::move(source, std::back_inserter(out_.source));
    return {};
}

} // namespace texplorer
