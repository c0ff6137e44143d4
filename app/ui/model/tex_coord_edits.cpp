#include "app/ui/model/tex_coord_edits.h"

#include "app/ui/model/session.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/sent_vertices.h"

#include <fmt/core.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace texplorer::ui {
namespace {

Step coordsStep(const Session& session, Sentence name, TexCoords coords) {
    const Selection& selection = session.look.selection;
    auto changed = std::make_shared<Scene>(presentScene(session));
    selectedModel(*changed, selection).texCoords[static_cast<std::size_t>(selection.unit)] =
        std::move(coords);
    std::string path = coordsPath(session);
    return {.name = std::move(name), .edits = {edit::Replace{std::move(changed), {path}}}, .path = path};
}

} // namespace

glm::vec4 withinCoordRange(glm::vec4 coord) {
    for (int i = 0; i < 4; ++i)
        coord[i] = std::isnan(coord[i]) ? 0.0F : coord[i]; // for vertices without a position
    return glm::clamp(coord, coordRange.min, coordRange.max);
}

std::string coordsPath(const Session& session) {
    return fmt::format("models[{}].texCoords{}", session.look.selection.model, session.look.selection.unit);
}

void submitTexCoords(const Session& session, Sentence name, TexCoords coords) {
    std::ranges::transform(coords, coords.begin(), withinCoordRange);
    submit(session, coordsStep(session, std::move(name), std::move(coords)));
}

void dragTexCoords(const Session& session, Sentence name, TexCoords coords) {
    Step step = coordsStep(session, std::move(name), std::move(coords));
    step.continues = true;
    submit(session, std::move(step));
}

void submitLeftOut(const Session& session, std::size_t vertex, bool leftOut) {
    const Selection& selection = session.look.selection;
    submit(
        session,
        leftOut ? Sentence("Leave out glTexCoord of vertex {0}", vertex)
                : Sentence("Send glTexCoord of vertex {0}", vertex),
        [&](Scene& scene) { setLeftOut(selectedModel(scene, selection), selection.unit, vertex, leftOut); },
        fmt::format("{}.{}", elementOf<&Scene::models>(static_cast<std::size_t>(selection.model)),
                    findKey(memberId<&Model::noTexCoord>, static_cast<std::size_t>(selection.unit))));
}

void resetTexCoords(const Session& session) {
    const Selection& selection = session.look.selection;
    const auto unit = static_cast<std::size_t>(selection.unit);
    submit(
        session, "Reset coordinates",
        [&](Scene& scene) {
            Model& model = selectedModel(scene, selection);
            model.texCoords[unit].clear();
            model.noTexCoord[unit].clear();
        },
        coordsPath(session));
}

void scaleCoords(TexCoords& coords, float factor) {
    for (glm::vec4& each : coords) {
        each.x *= factor;
        each.y *= factor;
    }
}

void flipS(TexCoords& coords) {
    for (glm::vec4& each : coords)
        each.x = 1 - each.x;
}

void flipT(TexCoords& coords) {
    for (glm::vec4& each : coords)
        each.y = 1 - each.y;
}

void rotateQuarter(TexCoords& coords) {
    for (glm::vec4& each : coords)
        each = {1 - each.y, each.x, each.z, each.w};
}

} // namespace texplorer::ui
