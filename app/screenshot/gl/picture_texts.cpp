#include "app/screenshot/gl/picture_texts.h"

#include <string>

namespace texplorer::screenshot {

PictureFacts factsOf(const ShotRequest& request, const Shot& shot) {
    std::string renderer;
    for (const RendererKind each : request.window ? request.compared : std::vector<RendererKind>())
        renderer.append(renderer.empty() ? "" : ",").append(rowOf(each).name);
    if (renderer.empty())
        renderer = rowOf(request.renderer).name;
    return {request.scene, request.time, request.size, std::move(renderer), shot.driver, shot.context};
}

} // namespace texplorer::screenshot
