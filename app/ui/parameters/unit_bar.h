#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

#include <string>

namespace texplorer::ui {

/// The units of the selected pass side by side, each with its texture and its switch: choosing one, and
/// switching it on and off. Below it, what a change of the texture reaches.
void unitBar(Session& session, const Pictures& pictures);

/// Switches a unit of the selected pass on or off. One that is switched on for the first time, or has no
/// texture, gets a texture of its own with another pattern.
void switchUnit(Session& session, int unit, bool on);

/// "unit 0, unit 2 of pass 1": units that are on and show the texture of a unit of the selected pass.
[[nodiscard]] std::string sharersText(const Session& session, int unit);

} // namespace texplorer::ui
