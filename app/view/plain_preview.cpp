#include "app/view/plain_preview.h"

#include "texplorer/reference/sampling/level_picture.h"
#include "texplorer/s3tc/surface_pixels.h"

#include <new>

namespace texplorer::view {
namespace {

/// nullptr: not ready. What is drawn can change with every frame, so that a worker would never finish it.
std::shared_ptr<const PreparedLevels> preparedFor(const LevelsRequest& request, LevelsSource& source) {
    if (!isDrawn(request.settings.source))
        return source.prepare(request);
    return std::make_shared<const PreparedLevels>(
        prepareLevels(request.settings, request.pictures, request.target));
}

/// The base level; nullptr if it cannot be made.
std::shared_ptr<const Image> pictureOf(const LevelsRequest& request, const PreparedLevels& levels) {
    if (!levels)
        return nullptr;
    const SharedSurface& base = levels->levels.front().surface;
    const BaseFormat format = baseFormat(request.settings.internalFormat);
    return std::make_shared<const Image>(reference::sourceColors(toImage(*base), format));
}

} // namespace

std::shared_ptr<const Image> PlainPreview::show(const Texture& texture, const ImageSource& images,
                                                LevelsSource& levels) {
    const std::optional<LevelsRequest> request = picture_.request(texture, images);
    if (!request)
        return nullptr;
    try {
        if (previewed_ != request) {
            if (const std::shared_ptr<const PreparedLevels> made = preparedFor(*request, levels)) {
                if (*made || made->error().code != ErrorCode::Cancelled)
                    image_ = pictureOf(*request, *made);
                previewed_ = request;
                if (!isDrawn(request->settings.source))
                    levels.uploaded(*request, made, {});
            }
        }
        return image_;
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}

} // namespace texplorer::view
