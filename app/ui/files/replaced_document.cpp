#include "app/ui/files/replaced_document.h"

#include "app/ui/files/loads.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

namespace texplorer::ui {

void replaceDocument(Session& session, Document document) {
    if (session.look.fileView.ticket != 0)
        session.services.files->cancel(session.look.fileView.ticket);
    session.look = {};
    static_cast<ShownPart&>(session.view) = {};
    static_cast<RecordedTime&>(session.recording) = {};
    if (session.lesson && !document.isLessons)
        closeLesson(session);
    endLessonPictures(session);
    exchangeDocument(session, std::move(document));
}

void exchangeDocument(Session& session, Document document) {
    cancelLoads(session);
    std::erase_if(session.out.requests, [](const Request& each) { // they are for the other document
        return !std::holds_alternative<Action>(each);
    });
    session.document = std::move(document);
    ++session.documents;
    showPresent(session);
    leaveHiddenModel(session);
    bringSelectionBack(session);
}

void endLessonPictures(Session& session) {
    if (!session.lesson)
        return;
    const std::optional<LessonPictures> shown = std::exchange(session.lesson->lookedAt, std::nullopt);
    if (shown && static_cast<ShownPictures&>(session.view) == shown->chosen)
        static_cast<ShownPictures&>(session.view) = shown->before;
}

void closeLesson(Session& session, KeepsTab tab) {
    endLessonPictures(session);
    session.lesson.reset();
    session.services.lessons->rest();
    if (tab == KeepsTab::No)
        closeTab(session.settings.workspace, Tab::Lesson);
}

} // namespace texplorer::ui
