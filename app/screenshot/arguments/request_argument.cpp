#include "app/screenshot/arguments/request_argument.h"

#include "app/command_line/choice_argument.h"
#include "app/screenshot/arguments/outputs_apart.h"

#include <algorithm>
#include <iterator>

namespace texplorer::screenshot {

Result<void> putMethods(const PictureArgument& picture, ShotRequest& request) {
    const auto anisotropy = parseChoice<reference::AnisotropyMethod>(picture.anisotropy, "--anisotropy");
    if (!anisotropy)
        return fail(anisotropy.error());
    const auto rho = parseChoice<reference::RhoMethod>(picture.rho, "--rho");
    if (!rho)
        return fail(rho.error());
    request.anisotropy = *anisotropy;
    request.rho = *rho;
    return {};
}

Result<ShotRequest> requestOf(const PictureArgument& picture, const RendererArgument& renderer) {
    ShotRequest request;
    const Result<view::Size> size = parsePictureSize(picture.size);
    if (!size)
        return fail(size.error());
    const Result<double> time = parseTime(picture.time);
    if (!time)
        return fail(time.error());
    const Result<RendererKind> kind = parseChoice<RendererKind>(renderer.renderer, "--renderer");
    if (!kind)
        return fail(kind.error());
    if (const Result<void> put = putContext(renderer, request); !put)
        return fail(put.error());
    request.renderer = *kind;
    if (const Result<void> put = putMethods(picture, request); !put)
        return fail(put.error());
    request.size = *size;
    request.time = *time;
    request.levels.cache = BlockCache::ofUser();
    noteMethodsUse(picture, request.renderer == RendererKind::Reference);
    noteRendererUse(renderer, {&request.renderer, 1});
    return request;
}

Result<void> checkPicturesApart(std::span<const std::string> names, const SceneArgument& scene,
                                const OpenedScene& opened, const RendererArgument& renderer) {
    std::vector<std::string> read = filesOf(scene, opened);
    std::ranges::move(filesIn(renderer.shaders), std::back_inserter(read));
    return checkOutputsApart(outputsOf("--out", names), read);
}

} // namespace texplorer::screenshot
