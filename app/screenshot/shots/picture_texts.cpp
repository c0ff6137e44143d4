#include "app/screenshot/shots/picture_texts.h"

#include "core/base/printable.h"
#include "core/link/scene_file.h"
#include "core/scene/params/json.h"

#include <fmt/format.h>

namespace texplorer::screenshot {

PictureFacts factsOf(const ShotRequest& request, const Shot& shot) {
    std::string renderer;
    for (const RendererKind each : request.window ? request.compared : std::vector<RendererKind>())
        renderer.append(renderer.empty() ? "" : ",").append(rowOf(each).name);
    if (renderer.empty())
        renderer = rowOf(request.renderer).name;
    return {request.scene, request.time, request.size, std::move(renderer), shot.driver, shot.context};
}

std::vector<PictureText> textsOf(const PictureFacts& facts) {
    std::vector<PictureText> texts{{"Software", "texshot " TEXPLORER_VERSION},
                                   {"Texplorer renderer", facts.renderer}};
    if (!facts.driver.name.empty())
        texts.push_back(
            {"Texplorer driver", printable(fmt::format("{}, {}", facts.driver.name, facts.driver.version))});
    if (!facts.context.empty())
        texts.push_back({"Texplorer context", facts.context});
    texts.push_back({"Texplorer time", fmt::format("{}", facts.time)});
    texts.push_back({"Texplorer size", fmt::format("{}x{}", facts.size.width, facts.size.height)});
    if (!facts.axes.empty())
        texts.push_back({"Texplorer axes", fmt::format("{}", fmt::join(facts.axes, "\n"))});
    texts.push_back({sceneKeyword, writeScene(facts.scene)});
    return texts;
}

} // namespace texplorer::screenshot
