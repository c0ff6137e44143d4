#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

#include <string>
#include <vector>

namespace texplorer::ui {

/// Draws the units of the selected pass in a row, each with its texture and its switch, to select, enable and
/// disable them. Below it, what an edit of the texture affects.
void unitBar(const Session& session, const Pictures& pictures);

/// Enables or disables a unit of the selected pass. A unit that is enabled for the first time, or has no
/// texture, gets its own texture with another pattern.
void switchUnit(const Session& session, int unit, bool on);

/// The edits that add a texture with this pattern and bind it to a unit of the selected pass.
[[nodiscard]] std::vector<Edit> addedTexture(const Session& session, int unit, Pattern pattern);

/// "unit 0, unit 2 of pass 1": units that are on and show the texture of a unit of the selected pass.
[[nodiscard]] std::string sharersText(const Session& session, int unit);

} // namespace texplorer::ui
