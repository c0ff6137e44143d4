#pragma once

#include "texplorer/preset/preset.h"

namespace texplorer::ui {

struct Session;

/// Applies a preset to the selected unit as an undo step of its name, starts the clock if the scene then
/// moves, and shows the preset's sentence; or reports why there is no room for it.
void choosePreset(const Session& session, const Preset& preset, std::string_view path = {});

/// The view shows the preset while this is called in every frame.
void previewPreset(const Session& session, const Preset& preset);

} // namespace texplorer::ui
