#include "app/ui/model/unsaved_work.h"

#include "app/ui/model/document.h"
#include "app/ui/model/session.h"

namespace texplorer::ui {

void followEdits(Session& session) {
    if (!session.unsaved)
        return;
    Autosave& autosave = session.unsaved->autosave;
    if (isDirty(session))
        autosave.keep(session.file, session.images.directory(), session.scene);
    else
        autosave.forget();
    if (const std::optional<Error> problem = autosave.takeProblem())
        say(session, "Unsaved work can't be kept: " + describe(*problem) + ".");
}

} // namespace texplorer::ui
