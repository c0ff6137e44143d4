#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

#include <string>

namespace texplorer::ui {

/// The texture that is bound to the selected unit.
void textureSection(Session& session, const Pictures& pictures);

/// That the selected unit shares its texture, with a way to give it its own; nothing where it doesn't. `id`
/// tells two such notes apart.
void sharingNote(Session& session, const char* id);

/// "unit 0, unit 2 of pass 1": units that are on and show the texture of a unit of the selected pass.
[[nodiscard]] std::string sharersText(const Session& session, int unit);

} // namespace texplorer::ui
