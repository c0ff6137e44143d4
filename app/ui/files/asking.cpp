#include "app/ui/files/asking.h"

#include "app/ui/files/lessons.h"
#include "app/ui/files/scene_files.h"
#include "app/ui/files/scene_saving.h"
#include "app/ui/model/notice.h"
#include "texplorer/scene/storage/scene_file.h"

#include <algorithm>
#include <utility>

namespace texplorer::ui {
namespace {

void askAboutChanges(Session& session, Pending next) {
    session.asking.pending = std::move(next);
    if (isDirty(session.document))
        session.asking.dialog = Dialog::Discard;
    else
        finishPending(session);
}

bool isLesson(const std::filesystem::path& folder) {
    std::error_code ignored;
    return std::filesystem::is_directory(folder, ignored) &&
           lesson::LessonFolder::onDisk(folder).has(lesson::lessonFileName);
}

} // namespace

void finishPending(Session& session) {
    const Pending next = std::exchange(session.asking.pending, {});
    if (const auto* action = std::get_if<Action>(&next))
        (*action)(session);
    else if (std::holds_alternative<pending::Quit>(next))
        session.asking.quitConfirmed = true;
}

void askLesson(Session& session, std::string nameOrFolder, std::optional<std::size_t> step) {
    askAboutChanges(session, [name = std::move(nameOrFolder), step](Session& s) {
        report(s, openLessonNamed(s, name, step));
    });
}

void askOpenScene(Session& session) {
    askAboutChanges(session, [](Session& s) { s.asking.dialog = Dialog::OpenScene; });
}

void askOpenImage(Session& session, std::string param) {
    session.asking.dialog = Dialog::OpenImage;
    session.asking.imageParam = std::move(param);
}

void askNewScene(Session& session) {
    askAboutChanges(session, newScene);
}

void askExample(Session& session, std::string_view file) {
    askAboutChanges(session, [name = std::string(file)](Session& s) { report(s, openExample(s, name)); });
}

void askSaveAnswers(Session& session) {
    session.asking.dialog = Dialog::SaveAnswers;
}

void askSaveAs(Session& session) {
    session.asking.dialog = Dialog::SaveScene;
}

void save(Session& session) {
    if (session.document.file.empty())
        return askSaveAs(session);
    const Result<void> saved = saveTo(session, session.document.file);
    report(session, saved);
    if (!saved)
        session.asking.pending = {};
}

Result<void> saveTo(Session& session, const std::filesystem::path& file,
                    const std::optional<FileFingerprint>& replaces) {
    const Result<Saving> saved = saveScene(session, file, replaces);
    if (!saved)
        return fail(saved.error());
    if (*saved == Saving::FileHasChanged) {
        session.asking.dialog = Dialog::FileHasChanged;
        return {};
    }
    session.look.notice = {};
    finishPending(session);
    return {};
}

void requestQuit(Session& session) {
    askAboutChanges(session, pending::Quit{});
}

void askPictureScene(Session& session) {
    askAboutChanges(session, [file = std::exchange(session.asking.picture, {}).file](Session& s) {
        report(s, openScene(s, file), file);
    });
}

void requestOpen(Session& session, std::vector<std::filesystem::path> files) {
    if (files.size() == 1) {
        if (isLesson(files.front()))
            return askLesson(session, files.front().string());
        if (const Result<bool> scene = holdsScene(files.front()); !scene)
            return say(session, scene.error());
        if (isPictureWithScene(files.front())) {
            session.asking.picture = {files.front(), false};
            session.asking.dialog = Dialog::Picture;
            return;
        }
    }
    if (files.empty())
        return;
    const bool replaces = std::ranges::any_of(
        files, [](const std::filesystem::path& file) { return holdsScene(file).value_or(false); });
    Action open = [all = std::move(files)](Session& s) { report(s, openFiles(s, all), all.front()); };
    if (!replaces)
        return open(session);
    askAboutChanges(session, std::move(open));
}

} // namespace texplorer::ui
