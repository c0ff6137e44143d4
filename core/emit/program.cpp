// Programs of any flavour, and what of them moves by key frames.

#include "texplorer/emit/program.h"

#include "texplorer/emit/emission.h"
#include "texplorer/emit/model_data.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/key_edits.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/pass_pictures.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

namespace texplorer::emit {
namespace {

Result<std::vector<Line>> written(Flavour flavour, const Scene& standing, const ImageSource& images,
                                  const ProgramOptions& options, TextureCodes& codes, KeyFrames& keys) {
    return flavour == Flavour::Glsl ? glslProgram(standing, images, options, codes, keys)
                                    : fixedProgram(standing, images, options, codes, keys);
}

/// With the models of too few vertices for a triangle, a line or a point invisible; nothing: there are none.
std::optional<Scene> withoutEmptyModels(const Scene& scene) {
    std::optional<Scene> drawn;
    for (std::size_t i = 0; i < scene.models.size(); ++i) {
        const Model& model = scene.models[i];
        const std::string path = fmt::format("{}.{}", elementOf<&Scene::models>(i), keyOf<&Model::visible>());
        const bool isShown = model.visible || std::ranges::find(scene.timeline.keys, path, &KeyFrame::path) !=
                                                  scene.timeline.keys.end();
        if (!isShown || model.shape != Shape::Mesh || !drawnIndices(meshOf(model)).empty())
            continue;
        if (!drawn)
            drawn = scene;
        drawn->models[i].visible = false;
        dropKeys(drawn->timeline, path);
    }
    return drawn;
}

/// With the passes off that draw in pictures which no unit shows; nothing: there are none. What key frames
/// show later isn't known here.
std::optional<Scene> withoutUnseenPasses(const Scene& scene) {
    const std::vector<PictureKey> shown = shownPictures(scene);
    const auto isUnseen = [&](const Pass& pass) {
        return pass.enabled && pass.picture != 0 &&
               std::ranges::find(shown, pass.picture, &PictureKey::number) == shown.end();
    };
    if (!scene.timeline.keys.empty() || std::ranges::none_of(scene.passes, isUnseen))
        return std::nullopt;
    Scene drawn = scene;
    for (Pass& pass : drawn.passes)
        pass.enabled = pass.enabled && !isUnseen(pass);
    return drawn;
}

} // namespace

Result<std::vector<Line>> program(Flavour flavour, const Scene& scene, const ImageSource& images,
                                  const ProgramOptions& options, TextureCodes& codes) {
    if (const std::optional<Scene> drawn = withoutEmptyModels(scene))
        return program(flavour, *drawn, images, options, codes);
    if (const std::optional<Scene> drawn = withoutUnseenPasses(scene))
        return program(flavour, *drawn, images, options, codes);
    if (scene.timeline.keys.empty()) {
        KeyFrames none;
        return written(flavour, scene, images, options, codes, none);
    }
    KeyFrames keys(flavour, scene);
    Result<std::vector<Line>> lines;
    if (keys.refused().path.empty())
        lines = written(flavour, keys.standing(), images, options, codes, keys);
    if (const RefusedParam refused = keys.refused(); lines && !refused.path.empty())
        return fail(
            ErrorCode::Unsupported,
            Sentence("a program ({0}) can't animate this by key frames, because {1}; texshot animate can",
                     rowOf(flavour).label, refused.why),
            refused.path);
    return lines;
}

} // namespace texplorer::emit
