#include "app/ui/model/unsaved_work.h"

#include "app/ui/model/scene_files.h"
#include "app/ui/model/session.h"

#include <fmt/core.h>

namespace texplorer::ui {

void followEdits(Session& session) {
    if (!session.services.unsaved)
        return;
    Autosave& autosave = session.services.unsaved->autosave;
    if (isDirty(session.document))
        autosave.keep(session.document.file, session.document.images.directory(), session.document.scene);
    else
        autosave.forget();
    if (const std::optional<Error> problem = autosave.takeProblem())
        say(session, fmt::format("Unsaved work can't be kept: {}.", describe(*problem)));
}

std::optional<double> dueAt(const Session& session) {
    return session.services.unsaved ? session.services.unsaved->autosave.due() : std::nullopt;
}

} // namespace texplorer::ui
