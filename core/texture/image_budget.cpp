#include "texplorer/texture/image_budget.h"

#include "texplorer/codec/registry.h"

#include <fmt/core.h>

namespace texplorer {

std::string sceneImageBytesText() {
    constexpr std::size_t gibibyte = std::size_t{1} << 30;
    static_assert(sceneImageBytes % gibibyte == 0);
    return fmt::format("{} GiB", sceneImageBytes / gibibyte);
}

Error beyondBudget(std::size_t needed, std::size_t left) {
    return {ErrorCode::TooLarge,
            Sentence("the image needs {0} bytes, but of the {1} for all images of a scene, {2} are left",
                     needed, sceneImageBytes, left),
            {}};
}

Result<TextureImage> decodeWithin(ByteView file, std::size_t left, Decoding decoding,
                                  const std::stop_token* stop) {
    Result<TextureImage> outline = decoding == Decoding::Outline ? outlineTexture(file, dissect(file))
                                                                 : decodeTexture(file, {.pixels = false});
    if (!outline)
        return outline;
    if (const std::size_t needed = byteCount(*outline); needed > left)
        return fail(beyondBudget(needed, left));
    return decoding == Decoding::Outline ? std::move(outline) : decodeTexture(file, {.stop = stop});
}

} // namespace texplorer
