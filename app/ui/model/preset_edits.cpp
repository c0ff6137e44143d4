#include "app/ui/model/preset_edits.h"

#include "app/ui/model/preview.h"
#include "app/ui/model/scene_files.h"
#include "core/scene/animation.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace texplorer::ui {
namespace {

PresetPlace selectedPlace(const Session& session) {
    return {static_cast<std::size_t>(session.window.selection.pass),
            static_cast<std::size_t>(session.window.selection.unit)};
}

} // namespace

void choosePreset(Session& session, const Preset& preset, std::string_view path) {
    Scene edited = session.document.scene;
    if (const Result<void> done = applyPreset(preset, edited, selectedPlace(session)); !done)
        return say(session, done.error());
    const bool moved = isAnimated(session.document.scene);
    session.document.scene = std::move(edited);
    sealEdit(session);
    recordEdit(session, preset.label, path);
    sealEdit(session);
    leaveHiddenModel(session);
    if (!moved && isAnimated(session.document.scene))
        session.window.playback.playing = true;
    tell(session, fmt::format("{}: {}", preset.label, preset.look));
}

void previewPreset(Session& session, const Preset& preset) {
    preview(session, fmt::format("preset:{}", preset.name), preset.label,
            [&](Scene& scene) { static_cast<void>(applyPreset(preset, scene, selectedPlace(session))); });
}

} // namespace texplorer::ui
