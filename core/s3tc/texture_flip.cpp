#include "texplorer/s3tc/texture_flip.h"

#include "texplorer/image/mirror.h"

#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace texplorer {
namespace {

Result<void> turn(Image& image, FlipAxis axis) {
    if (image.pixels.size() != image.byteCount())
        return fail(ErrorCode::Malformed, Sentence("expected {0} bytes of pixels, found {1}",
                                                   image.byteCount(), image.pixels.size()));
    if (axis != FlipAxis::Horizontal)
        flipVertically(image);
    if (axis != FlipAxis::Vertical)
        mirror(image);
    return {};
}

Result<void> turn(BlockImage& blocks, FlipAxis axis) {
    switch (axis) {
    case FlipAxis::Vertical:
        return flipVertically(blocks);
    case FlipAxis::Horizontal:
        return flipHorizontally(blocks);
    case FlipAxis::Both:
        break;
    }
    return rotateHalfTurn(blocks);
}

Result<void> turn(Surface& surface, FlipAxis axis) {
    return std::visit([axis](auto& image) { return turn(image, axis); }, surface);
}

Result<BlockImage> compressAgain(const Surface& surface, const FlipOptions& options) try {
    return decodeFlipEncode(std::get<BlockImage>(surface), options.axis, options.quality, options.progress,
                            options.stop);
} catch (const std::bad_alloc&) {
    return fail(ErrorCode::TooLarge, "not enough memory to compress it again");
}

} // namespace

Result<void> flip(TextureImage& texture, const FlipOptions& options) try {
    std::vector<std::optional<Surface>> before(texture.surfaces.size()); // of what was compressed again
    for (std::size_t i = 0; i < before.size(); ++i) {
        Surface& surface = texture.surfaces[i];
        Result<void> turned = turn(surface, options.axis);
        if (!turned && turned.error().code == ErrorCode::Unsupported && options.lossy) {
            Result<BlockImage> again = compressAgain(surface, options);
            turned = again ? Result<void>() : fail(again.error());
            if (again)
                before[i] = std::exchange(surface, *std::move(again));
        }
        if (turned)
            continue;
        const std::size_t level = i % static_cast<std::size_t>(texture.levels);
        while (i-- > 0) { // what was turned around without loss is turned back
            if (before[i])
                texture.surfaces[i] = *std::move(before[i]);
            else
                static_cast<void>(turn(texture.surfaces[i], options.axis));
        }
        return fail(turned.error().code, Sentence("level {0}: {1}", level, turned.error().message));
    }
    return {};
} catch (const std::bad_alloc&) { // before anything was turned
    return fail(ErrorCode::TooLarge, "not enough memory to turn the texture around");
}

} // namespace texplorer
