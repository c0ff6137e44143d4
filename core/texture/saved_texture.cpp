#include "texplorer/texture/saved_texture.h"

#include "texplorer/image/border.h"
#include "texplorer/image/convert.h"
#include "texplorer/image/depth_pixels.h"
#include "texplorer/s3tc/flip.h"
#include "texplorer/s3tc/surface_pixels.h"
#include "texplorer/texture/late_flip.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace texplorer {
namespace {

/// The smallest format that holds what the texture stores of all pictures.
PixelFormat formatFor(const MipChain& pictures, BaseFormat base) {
    const auto isAny = [&](PixelFormat one, PixelFormat other) {
        return std::ranges::any_of(
            pictures, [&](const Image& image) { return image.format == one || image.format == other; });
    };
    const bool isColor = isAny(PixelFormat::Rgb8, PixelFormat::Rgba8);
    const bool isGrey = isAny(PixelFormat::Luminance8, PixelFormat::LuminanceAlpha8);
    const bool hasAlpha = isAny(PixelFormat::Rgba8, PixelFormat::LuminanceAlpha8) ||
                          isAny(PixelFormat::Alpha8, PixelFormat::Alpha8);
    switch (base) {
    case BaseFormat::Alpha:
        return PixelFormat::Alpha8;
    case BaseFormat::Luminance:
    case BaseFormat::Intensity:
        return PixelFormat::Luminance8;
    case BaseFormat::LuminanceAlpha:
        return hasAlpha ? PixelFormat::LuminanceAlpha8 : PixelFormat::Luminance8;
    case BaseFormat::Rgb:
        return isColor ? PixelFormat::Rgb8 : PixelFormat::Luminance8;
    case BaseFormat::Rgba:
        break;
    }
    if (!isColor && !isGrey)
        return PixelFormat::Alpha8;
    if (isColor)
        return hasAlpha ? PixelFormat::Rgba8 : PixelFormat::Rgb8;
    return hasAlpha ? PixelFormat::LuminanceAlpha8 : PixelFormat::Luminance8;
}

/// The components of an image that another format has.
Image inFormat(Image image, PixelFormat format) {
    if (image.format == format)
        return image;
    constexpr std::array<std::array<int, 4>, 5> components{
        {{3}, {0}, {0, 3}, {0, 1, 2}, {0, 1, 2, 3}}}; // of the rows of PixelFormat
    const auto& taken = components[static_cast<std::size_t>(format)];
    Image made = Image::uninitialised(format, image.width, image.height, image.depth);
    const auto from = static_cast<std::size_t>(bytesPerPixel(image.format));
    const auto to = static_cast<std::size_t>(bytesPerPixel(format));
    for (std::size_t i = 0; i < image.pixels.size() / from; ++i) {
        const auto rgba = rgbaOf(image.format, image.pixels.data() + i * from);
        for (std::size_t c = 0; c < to; ++c)
            made.pixels[i * to + c] = std::byte{rgba[static_cast<std::size_t>(taken[c])]};
    }
    return made;
}

std::optional<BlockFormat> formatOfBlocks(const TextureLevels& levels) {
    const auto* blocks = std::get_if<BlockImage>(&*levels.levels.front().surface);
    return blocks ? std::optional(blocks->format) : levels.driverFormat;
}

/// The format of the file's blocks; nothing: it has pixels.
std::optional<BlockFormat> wantedBlocks(const TextureLevels& levels, const TextureSaving& how) {
    if (!how.hasAllLevels() || how.blocks == SavedBlocks::None)
        return std::nullopt;
    return how.blocks == SavedBlocks::Chosen ? how.format : formatOfBlocks(levels);
}

/// Whether the levels are blocks of this format already, in rows that the file can have.
bool areBlocks(const TextureLevels& levels, BlockFormat format, bool topFirst) {
    return std::ranges::all_of(levels.levels, [&](const TextureLevel& level) {
        const auto* blocks = std::get_if<BlockImage>(&*level.surface);
        return blocks && blocks->format == format && (topFirst || flipsWithoutLoss(blocks->height));
    });
}

/// The levels as pixels, top row first, with the components that the texture has. `before`: as they were
/// before they were compressed here.
MipChain pixelsOf(TextureLevels& levels, const TextureSaving& how, bool topFirst, bool before) {
    MipChain pixels;
    for (std::size_t i = 0; i < levels.levels.size(); ++i) {
        Image image =
            asBytes(before && !levels.source.empty() ? std::move(levels.source[i])
                                                     : toImage(std::move(levels.levels[i].surface).take()));
        if (levels.border > 0)
            image = withoutBorder(image, axesOf(how.target));
        if (!topFirst)
            flipVertically(image);
        pixels.push_back(std::move(image));
    }
    const bool isCompressed = formatOfBlocks(levels).has_value(); // which has no internal format
    const PixelFormat format =
        formatFor(pixels, isCompressed ? BaseFormat::Rgba : baseFormat(levels.internalFormat));
    for (Image& image : pixels)
        image = inFormat(std::move(image), format);
    return pixels;
}

void addRemarks(const TextureLevels& levels, const TextureSaving& how, SavedTexture& saved) {
    if (levels.border > 0)
        saved.losses.push_back({"border", N_("the border")});
    if (levels.call)
        saved.remarks.emplace_back(N_("It is what OpenGL reads from the memory of the upload."));
    const bool compresses = levels.driverFormat && how.blocks == SavedBlocks::AsTexture;
    if (compresses || (levels.madeByDriver && how.hasAllLevels()))
        saved.remarks.emplace_back(N_("The driver's own levels may differ a little."));
}

/// Adds all levels, as blocks or pixels.
Result<void> addSurfaces(TextureLevels& levels, const Texture& texture, const TextureSaving& how,
                         const LevelWork& work, SavedTexture& saved) {
    std::vector<Surface>& surfaces = saved.image.surfaces;
    const std::optional<BlockFormat> blocks = wantedBlocks(levels, how);
    const bool topFirst = isTopFirst(levels, how.target);
    saved.image.topFirst = true;
    if (blocks && areBlocks(levels, *blocks, topFirst)) {
        saved.image.topFirst = topFirst;
        for (TextureLevel& level : levels.levels)
            surfaces.push_back(std::move(level.surface).take());
        return {};
    }
    MipChain pixels = pixelsOf(levels, how, topFirst, blocks.has_value());
    if (!blocks) {
        std::ranges::move(pixels, std::back_inserter(surfaces));
        return {};
    }
    if (how.blocks == SavedBlocks::Chosen)
        std::ranges::move(lossesIn(pixels, *blocks), std::back_inserter(saved.losses));
    else if (!levels.driverFormat)
        saved.remarks.emplace_back(
            N_("Its blocks are compressed again, because they can't be flipped without loss."));
    const EncodeQuality quality = how.encodes(texture) ? how.quality : texture.compressionQuality;
    auto made = encodeLevels(pixels, *blocks, quality, work.progress, work.stop);
    if (!made)
        return fail(made.error());
    std::ranges::move(*made, std::back_inserter(surfaces));
    return {};
}

bool hasAlpha(const Surface& surface) {
    const auto* image = std::get_if<Image>(&surface);
    return image ? image->format != PixelFormat::Luminance8 && image->format != PixelFormat::Rgb8
                 : baseFormat(std::get<BlockImage>(surface).format) == BaseFormat::Rgba;
}

} // namespace

Result<void> checkSaving(const LevelPlan& plan, const TextureSaving& how) {
    if (plan.levels.empty())
        return fail(ErrorCode::Unsupported, !plan.refusal.empty() ? plan.refusal
                                            : plan.upload         ? plan.upload->refusal
                                                          : Sentence(N_("the texture has no levels")));
    if (!how.hasAllLevels()) {
        if (std::ranges::find(plan.levels, how.level, &PlannedLevel::number) != plan.levels.end())
            return {};
        return fail(ErrorCode::OutOfRange, Sentence("there is no level {0}", how.level));
    }
    for (int number = 0; const PlannedLevel& level : plan.levels) {
        const PlannedLevel fit = levelAbove(plan.levels.front(), number++);
        if (level.number != fit.number)
            return fail(ErrorCode::Unsupported,
                        Sentence("a DDS file has all levels, but level {0} is missing", fit.number));
        if (level != fit)
            return fail(ErrorCode::Unsupported,
                        Sentence("level {0} of a DDS file needs {1} × {2} texels, found {3} × {4}",
                                 level.number, fit.width, fit.height, level.width, level.height));
    }
    if (const int slices = plan.levels.front().depth; slices > 1 && how.blocks == SavedBlocks::Chosen)
        return fail(ErrorCode::Unsupported,
                    Sentence("expected a picture for blocks, found a volume of {0} slices", slices));
    return {};
}

Result<SavedTexture> savedTexture(const Texture& texture, const TexturePictures& pictures,
                                  const TextureSaving& how, const LevelWork& work) {
    if (const Result<void> possible = checkSaving(planLevels(texture, pictures, how.target), how); !possible)
        return fail(possible.error());
    Result<TextureLevels> levels = prepareLevels(texture, pictures, how.target, work);
    if (!levels)
        return fail(levels.error());
    SavedTexture saved;
    addRemarks(*levels, how, saved);
    TextureImage& image = saved.image;
    image.format = how.file;
    image.faces = facesOf(how.target);
    image.levels = static_cast<int>(levels->levels.size()) / image.faces;
    image.srgb = !formatOfBlocks(*levels) && isSrgb(levels->internalFormat);
    if (isDepth(levels->internalFormat) || isFloat(levels->internalFormat))
        image.componentBits = mostBits(levels->internalFormat);
    if (const Result<void> added = addSurfaces(*levels, texture, how, work, saved); !added)
        return fail(added.error());
    image.alpha = hasAlpha(image.surfaces.front()) ? AlphaMeaning::Straight : AlphaMeaning::None;
    std::ranges::move(lossesIn(image, how.file), std::back_inserter(saved.losses));
    if (!how.hasAllLevels()) {
        const auto found = std::ranges::find(levels->levels, how.level, &TextureLevel::number);
        image.surfaces = {
            std::move(image.surfaces[static_cast<std::size_t>(found - levels->levels.begin())])};
        image.levels = image.faces = 1;
    }
    return saved;
}

} // namespace texplorer
