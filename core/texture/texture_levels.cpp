#include "texplorer/texture/texture_levels.h"

#include "texplorer/image/convert.h"
#include "texplorer/s3tc/surface_pixels.h"
#include "texplorer/texture/level_maker.h"

#include <fmt/core.h>

#include <algorithm>
#include <new>
#include <utility>

namespace texplorer {

namespace {

/// Whether the base is uploaded as pixels with colours: of others a driver makes no levels.
bool areColors(const TextureLevels& levels) {
    return !isDepth(levels.internalFormat) && !levels.levels.empty() &&
           std::holds_alternative<Image>(*levels.levels.front().surface);
}

Result<TextureLevels> run(const Texture& texture, const TexturePictures& pictures, Target target,
                          const LevelWork& work, bool lends) {
    const TextureImage& image = *pictures.base;
    if (!hasPixels(image))
        return fail(ErrorCode::Malformed, "the image is empty");
    try {
        Result<TextureLevels> made = LevelMaker(texture, pictures, target, work, lends).run();
        if (made && isMadeByDriver(texture.mipmaps) && areColors(*made)) {
            const bool changesOthers = std::ranges::any_of(
                texture.subimages, [](const Subimage& subimage) { return subimage.level > 0; });
            made->madeByDriver = !hasFewBits(made->internalFormat) && !changesOthers;
            if (hasFewBits(made->internalFormat))
                made->notes.push_back(
                    Sentence("drivers may store more bits than {0}: levels made with Texplorer's box filter",
                             ProperName{rowOf(made->internalFormat).name}));
        }
        const bool wanted = texture.mipmaps != MipPolicy::None;
        if (made && wanted && settingsFor(texture, image).mipmaps == MipPolicy::None)
            made->notes.emplace_back(N_("a shadow map has no mip levels: there is only a base level"));
        return made;
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge,
                    Sentence("not enough memory for the levels of an image of {0} texels",
                             ProperName{fmt::format("{} × {}", widthOf(image.surfaces.front()),
                                                    heightOf(image.surfaces.front()))}));
    }
}

} // namespace

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
    LevelMaker(upright, pictures, Target::Texture2D, work).eachStep(visit);
}

Image subimageOf(const Texture& texture, const TexturePictures& pictures, Target target, std::size_t index) {
    return LevelMaker(texture, pictures, target, {}).subimageOf(index);
}

void makeBytes(TextureLevels& levels) {
    if (isFloat(levels.internalFormat))
        levels.internalFormat = internalFormat(baseFormat(levels.internalFormat));
    for (TextureLevel& level : levels.levels) {
        if (const auto* blocks = std::get_if<BlockImage>(&*level.surface))
            levels.internalFormat = internalFormat(baseFormat(blocks->format));
        level.surface = asBytes(toImage(std::move(level.surface).take()));
    }
    if (levels.driverFormat)
        levels.internalFormat = internalFormat(baseFormat(*levels.driverFormat));
    levels.driverFormat.reset();
}

Texture withGeneratedLevels(const Texture& texture) {
    const bool byDriver = isMadeByDriver(texture.mipmaps);
    if (!byDriver && texture.mipmaps != MipPolicy::Glu)
        return texture;
    Texture settings = texture;
    settings.mipmaps = MipPolicy::Generated;
    settings.mipFilter = MipFilter::Box;
    settings.mipCoverage = 0;
    const bool isCompressed =
        texture.compression == Compression::Driver || texture.compression == Compression::Cached;
    const BaseFormat base = baseFormat(texture.internalFormat);
    const bool isColor = base == BaseFormat::Rgb || base == BaseFormat::Rgba;
    settings.mipGamma = byDriver && isSrgb(texture.internalFormat) && isColor && !isCompressed; // as Mesa
    if (!byDriver)
        settings.npot = NpotPolicy::PowerOfTwo;
    return settings;
}

Texture imageSettings(const Texture& texture) {
    Texture settings = texture;
    static_cast<SamplerState&>(settings) = {};
    settings.priority = Texture{}.priority;
    return settings;
}

} // namespace texplorer
