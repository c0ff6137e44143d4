#pragma once

#include "app/stage/event.h"

namespace texplorer::ui {
struct Session; // see app/ui/model/session.h
}

namespace texplorer::stage {

/// Opens files whose content the host knows: the last scene, and images for it or for the current one. An
/// image that the scene names and does not have becomes that image; others become textures, as dropped files
/// do. Asks first if a scene would replace unsaved changes, unless the user has requested a scene.
void openGivenFiles(ui::Session& session, const FilesGiven& given);

} // namespace texplorer::stage
