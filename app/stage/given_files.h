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

/// A given file has other content now: the document's files with the content `before` get it, without an undo
/// step, as files that change in a folder do. Returns whether there is one; tells the user if its new content
/// can't be read.
[[nodiscard]] bool replaceGivenFile(ui::Session& session, const Bytes& before, const Bytes& now);

} // namespace texplorer::stage
