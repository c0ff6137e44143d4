#include "app/ui/model/preset_edits.h"

#include "app/ui/model/preview.h"
#include "app/ui/model/session.h"

#include <fmt/core.h>

namespace texplorer::ui {
namespace {

PresetPlace selectedPlace(const Session& session) {
    return {static_cast<std::size_t>(session.look.selection.pass),
            static_cast<std::size_t>(session.look.selection.unit)};
}

} // namespace

void choosePreset(const Session& session, const Preset& preset, std::string_view path) {
    submit(session, {.name = preset.label,
                     .edits = {edit::ApplyPreset{std::string(preset.name), selectedPlace(session)}},
                     .path = std::string(path),
                     .says = Sentence("{0}: {1}", preset.label, preset.look)});
}

void previewPreset(const Session& session, const Preset& preset) {
    preview(session, fmt::format("preset:{}", preset.name), preset.label,
            [&](Scene& scene) { static_cast<void>(applyPreset(preset, scene, selectedPlace(session))); });
}

} // namespace texplorer::ui
