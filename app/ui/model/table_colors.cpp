#include "app/ui/model/table_colors.h"

#include "app/ui/model/level_view.h"
#include "app/ui/state/workspace.h"
#include "texplorer/image/mean_color.h"
#include "texplorer/reference/probe.h"
#include "texplorer/scene/model_mesh.h"

#include <glm/common.hpp>

#include <algorithm>
#include <optional>

namespace texplorer::ui {
namespace {

/// The colour if there is neither a pixel nor an image: its components differ.
constexpr glm::vec4 exampleTexel{0.8F, 0.4F, 0.2F, 0.6F};

/// The format of the same kind with all components.
InternalFormat wholeFormat(InternalFormat format) {
    if (isDepth(format))
        return format;
    return isSrgb(format) ? InternalFormat::Srgb8Alpha8 : InternalFormat::Rgba;
}

const reference::EnvironmentInputs* inputsIn(const reference::Explanation& explanation,
                                             const Selection& selection) {
    for (std::size_t i = explanation.fragments.size(); i > 0; --i) {
        const reference::FragmentExplanation& fragment = explanation.fragments[i - 1];
        const auto unit =
            std::ranges::find(fragment.units, selection.unit, &reference::UnitExplanation::unit);
        if (fragment.pass == selection.pass && unit != fragment.units.end())
            return &unit->inputs;
    }
    return nullptr;
}

/// From the probed pixel; nothing: none is probed, it has no such fragment, or nothing is known yet.
std::optional<reference::EnvironmentInputs> probedInputs(const Session& session) {
    const auto& answer = session.tableAnswer;
    if (!answer || !answer->explanation || !*answer->explanation)
        return std::nullopt;
    const reference::EnvironmentInputs* inputs = inputsIn(**answer->explanation, session.look.selection);
    return inputs ? std::optional(*inputs) : std::nullopt;
}

} // namespace

void askAboutTable(Session& session, view::Size picture) {
    const std::optional<reference::PixelPlace>& pixel = session.look.explaining.pixel;
    const bool isSeen =
        session.window.figure == Figure::Environments && isShown(session.settings.workspace, Tab::Figures);
    if (!isSeen || !pixel || pixel->x >= picture.width || pixel->y >= picture.height ||
        !boundTexture(session)) {
        session.tableAnswer.reset();
        session.services.plainProbe->rest();
        return;
    }
    Scene scene = presentScene(session);
    Texture& texture = scene.textures[static_cast<std::size_t>(selectedUnit(session).texture)];
    texture.internalFormat = wholeFormat(texture.internalFormat);
    session.tableAnswer = session.services.plainProbe->answer(
        {{std::move(scene), session.document.images, session.look.playback.time, picture.width,
          picture.height, session.view.anisotropy, session.view.rho},
         pixel,
         std::nullopt});
}

BaseFormat baseFormatOf(const Texture& texture, const LevelsSummary* summary) {
    if (summary && summary->compressed)
        return baseFormat(*summary->compressed);
    return isDepth(texture.internalFormat) || texture.source == SourceKind::LightDepth
               ? baseFormat(texture.depthMode)
               : baseFormat(texture.internalFormat);
}

TableSubject tableSubject(const Session& session) {
    TableSubject subject;
    const Scene& scene = presentScene(session);
    const Unit& unit = selectedUnit(session);
    if (const Texture* texture = boundTexture(session)) {
        const auto summary = summaryOf(session, levelsOf(session, *texture, unit.target));
        if (summary && !summary->levels.empty())
            subject.texels = summary->levels.front().second;
        subject.format = baseFormatOf(*texture, summary.get());
        subject.hasChoice = !(summary && summary->compressed) && !isDepth(texture->internalFormat) &&
                            texture->source != SourceKind::LightDepth;
    }
    subject.colors.constant = glm::clamp(unit.envColor, 0.0F, 1.0F);
    if (const auto inputs = probedInputs(session)) {
        subject.colors.fragment = inputs->previous;
        subject.colors.texel = inputs->source;
        subject.probed = true;
        return subject;
    }
    const Model* model = selectedModel(session);
    subject.colors.fragment =
        glm::clamp(model ? materialOf(scene, *model).color : scene.material.color, 0.0F, 1.0F);
    subject.colors.texel = subject.texels ? meanColor(*subject.texels) : exampleTexel;
    return subject;
}

} // namespace texplorer::ui
