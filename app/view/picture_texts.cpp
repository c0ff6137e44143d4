#include "app/view/picture_texts.h"

#include "texplorer/scene/params/json.h"
#include "texplorer/scene/storage/scene_file.h"
#include "texplorer/text/printable.h"

#include <fmt/format.h>

namespace texplorer::view {

std::vector<PictureText> textsOf(const PictureFacts& facts) {
    std::vector<PictureText> texts{
        PictureText{"Software", fmt::format("{} {}", facts.program, TEXPLORER_VERSION)},
        PictureText{"Texplorer renderer", facts.renderer}};
    if (!facts.driver.name.empty())
        texts.push_back(PictureText{
            "Texplorer driver", printable(fmt::format("{}, {}", facts.driver.name, facts.driver.version))});
    if (!facts.context.empty())
        texts.push_back(PictureText{"Texplorer context", facts.context});
    texts.push_back(PictureText{"Texplorer time", fmt::format("{}", facts.time)});
    texts.push_back(PictureText{"Texplorer size", fmt::format("{}x{}", facts.size.width, facts.size.height)});
    if (!facts.axes.empty())
        texts.push_back(PictureText{"Texplorer axes", fmt::format("{}", fmt::join(facts.axes, "\n"))});
    texts.push_back({sceneKeyword, writeScene(facts.scene)});
    return texts;
}

std::string axisText(const SweepAxis& axis, std::span<const std::string> values) {
    const bool hasComponents = axis.values.front().find(',') != std::string::npos;
    return fmt::format("{}={}", axis.path, fmt::join(values, hasComponents ? ";" : ","));
}

} // namespace texplorer::view
