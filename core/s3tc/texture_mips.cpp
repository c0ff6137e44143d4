#include "texplorer/s3tc/texture_mips.h"

#include "texplorer/image/mipmaps.h"
#include "texplorer/s3tc/encode.h"
#include "texplorer/s3tc/surface_pixels.h"

#include <iterator>
#include <new>
#include <string>

namespace texplorer {
namespace {

/// The base and the levels above it.
Result<std::vector<Surface>> chainOf(const Surface& base, const MipOptions& options, EncodeQuality quality) {
    const bool compressed = std::holds_alternative<BlockImage>(base);
    if (compressed && depthOf(base) > 1)
        return fail(ErrorCode::Unsupported,
                    Sentence("volumes are not compressed: expected a depth of 1, found {0}", depthOf(base)));
    MipChain chain = buildMipChain(toImage(base), options);
    std::vector<Surface> levels;
    if (!compressed) {
        std::ranges::move(chain, std::back_inserter(levels));
        return levels;
    }
    const bool keepsBase = chain.front().width == widthOf(base) && chain.front().height == heightOf(base);
    if (keepsBase) {
        levels.push_back(base);
        chain.erase(chain.begin());
    }
    Result<std::vector<BlockImage>> blocks = encodeLevels(chain, std::get<BlockImage>(base).format, quality);
    if (!blocks)
        return fail(blocks.error());
    std::ranges::move(*blocks, std::back_inserter(levels));
    return levels;
}

} // namespace

Result<void> buildMips(TextureImage& texture, const MipOptions& options, EncodeQuality quality) try {
    const auto held = static_cast<std::size_t>(texture.faces) * static_cast<std::size_t>(texture.levels);
    if (held == 0 || texture.surfaces.size() != held)
        return fail(ErrorCode::Malformed, Sentence("expected {0} faces of {1} levels, found {2} surfaces",
                                                   texture.faces, texture.levels, texture.surfaces.size()));
    std::vector<Surface> surfaces;
    for (int face = 0; face < texture.faces; ++face) {
        const Surface& base = texture.surface(face, 0);
        if (bytesHeld(base) == 0 || bytesHeld(base) != byteCount(base))
            return fail(ErrorCode::Malformed, Sentence("face {0}: expected {1} bytes of pixels, found {2}",
                                                       face, byteCount(base), bytesHeld(base)));
        Result<std::vector<Surface>> levels = chainOf(base, options, quality);
        if (!levels)
            return fail(levels.error());
        std::ranges::move(*levels, std::back_inserter(surfaces));
    }
    texture.levels = static_cast<int>(surfaces.size()) / texture.faces;
    texture.surfaces = std::move(surfaces);
    return {};
} catch (const std::bad_alloc&) {
    return fail(ErrorCode::TooLarge, "not enough memory for the mip levels");
}

} // namespace texplorer
