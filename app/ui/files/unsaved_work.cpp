#include "app/ui/files/unsaved_work.h"

#include "app/ui/model/notice.h"
#include "app/ui/model/session.h"

#include <algorithm>

namespace texplorer::ui {

void followEdits(Session& session) {
    if (Captures* captures = session.services.captures) {
        if (std::optional<Captures::News> news = captures->takeNews())
            session.look.notice = {.text = std::move(news->text), .file = {}, .isGood = news->isWritten};
    }
    if (std::optional<FileNews> news = session.services.writing->takeNews())
        session.look.notice = {.text = std::move(news->text), .file = {}, .isGood = news->isGood};
    if (SettingsFile* settings = session.services.settings) {
        settings->keep(session.settings);
        if (std::optional<Sentence> problem = settings->takeProblem())
            say(session, std::move(*problem));
    }
    if (!session.services.unsaved)
        return;
    Autosave& autosave = session.services.unsaved->autosave;
    if (isDirty(session.document))
        autosave.keep(session.document.file, session.document.images.directory(), session.document.scene,
                      session.document.fileHash);
    else
        autosave.forget();
    if (const std::optional<Error> problem = autosave.takeProblem())
        say(session, Sentence("Unsaved work can't be stored: {0}.", describe(*problem)));
}

std::optional<double> dueAt(const Session& session) {
    const auto work = session.services.unsaved ? session.services.unsaved->autosave.due() : std::nullopt;
    const auto settings = session.services.settings ? session.services.settings->due() : std::nullopt;
    return work && settings ? std::min(*work, *settings) : work ? work : settings;
}

} // namespace texplorer::ui
