#pragma once

#include "core/preset/preset.h"

namespace texplorer::ui {

struct Session;

/// Does what a preset says to the selected unit, a step of undo of that name, lets the scene play where it
/// moves then, and says what there is to see; or why there is no room for it.
void choosePreset(Session& session, const Preset& preset, std::string_view path = {});

/// The view shows it as long as this is called in every frame.
void previewPreset(Session& session, const Preset& preset);

} // namespace texplorer::ui
