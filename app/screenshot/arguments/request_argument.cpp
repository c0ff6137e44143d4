#include "app/screenshot/arguments/request_argument.h"

namespace texplorer::screenshot {

Result<ShotRequest> requestOf(const PictureArgument& picture, const RendererArgument& renderer) {
    ShotRequest request;
    const Result<view::Size> size = parsePictureSize(picture.size);
    if (!size)
        return fail(size.error());
    const Result<double> time = parseTime(picture.time);
    if (!time)
        return fail(time.error());
    if (const Result<void> put = putRenderer(renderer, request); !put)
        return fail(put.error());
    const Result<reference::AnisotropyMethod> anisotropy = parseAnisotropy(picture.anisotropy);
    if (!anisotropy)
        return fail(anisotropy.error());
    request.size = *size;
    request.time = *time;
    request.anisotropy = *anisotropy;
    request.levels.cache = BlockCache::ofUser();
    const bool reference = request.renderer == RendererKind::Reference;
    if (const Result<void> used = checkAnisotropyUse(picture, reference); !used)
        return fail(used.error());
    if (const Result<void> used = checkRendererUse(renderer, request); !used)
        return fail(used.error());
    return request;
}

} // namespace texplorer::screenshot
