#include "app/ui/model/preset_edits.h"

#include "app/ui/model/preview.h"
#include "app/ui/model/session.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace texplorer::ui {
namespace {

PresetPlace selectedPlace(const Session& session) {
    return {static_cast<std::size_t>(session.look.selection.pass),
            static_cast<std::size_t>(session.look.selection.unit)};
}

/// A unit that is on after the preset: the selected one, or else the first.
int unitAfter(const Session& session, const Preset& preset) {
    const PresetPlace place = selectedPlace(session);
    Scene after = presentScene(session);
    if (applyPreset(preset, after, place)) {
        const std::array<Unit, maxUnits>& units = after.passes[place.pass].units;
        const auto on = std::ranges::find(units, true, &Unit::enabled);
        if (!units[place.unit].enabled && on != units.end())
            return static_cast<int>(on - units.begin());
    }
    return session.look.selection.unit;
}

} // namespace

void choosePreset(const Session& session, const Preset& preset, std::string_view path) {
    act(session,
        [unit = unitAfter(session, preset)](Session& changed) { changed.look.selection.unit = unit; });
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
