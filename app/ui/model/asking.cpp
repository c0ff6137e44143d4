#include "app/ui/model/asking.h"

#include "app/ui/model/lesson_run.h"
#include "app/ui/model/scene_files.h"
#include "app/ui/model/scene_saving.h"
#include "core/scene/storage/scene_file.h"

#include <algorithm>
#include <utility>

namespace texplorer::ui {
namespace {

void askAboutChanges(Session& session, Pending next) {
    session.window.pending = next;
    if (isDirty(session.document))
        session.window.dialog = Dialog::Discard;
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
    const Pending pending = session.window.pending;
    session.window.pending = Pending::None;
    switch (pending) {
    case Pending::None:
        break;
    case Pending::NewScene:
        newScene(session);
        break;
    case Pending::Example:
        report(session, openExample(session, session.window.pendingExample));
        break;
    case Pending::Lesson:
        report(session, openLessonNamed(session, session.window.pendingLesson));
        break;
    case Pending::OpenScene:
        session.window.dialog = Dialog::OpenScene;
        break;
    case Pending::OpenFiles: {
        const std::vector<std::filesystem::path> files = std::move(session.window.pendingFiles);
        session.window.pendingFiles.clear();
        report(session, openFiles(session, files), files.front());
        break;
    }
    case Pending::OpenPicture: {
        const AskedPicture asked = std::exchange(session.window.askedPicture, {});
        report(session, openScene(session, asked.file), asked.file);
        break;
    }
    case Pending::ShowScene:
        if (const std::shared_ptr<Load> ready = std::exchange(session.window.readyScene, nullptr)) {
            ready->before = session.document.scene; // the user has answered
            showLoadedScene(session, std::move(*ready));
        }
        break;
    case Pending::Quit:
        session.window.quitConfirmed = true;
        break;
    }
}

void askLesson(Session& session, std::string nameOrFolder) {
    session.window.pendingLesson = std::move(nameOrFolder);
    askAboutChanges(session, Pending::Lesson);
}

void askOpenScene(Session& session) {
    askAboutChanges(session, Pending::OpenScene);
}

void askOpenImage(Session& session, std::string param) {
    session.window.dialog = Dialog::OpenImage;
    session.window.imageParam = std::move(param);
}

void askNewScene(Session& session) {
    askAboutChanges(session, Pending::NewScene);
}

void askExample(Session& session, std::string_view file) {
    session.window.pendingExample = file;
    askAboutChanges(session, Pending::Example);
}

void askSaveAnswers(Session& session) {
    session.window.dialog = Dialog::SaveAnswers;
}

void askSaveAs(Session& session) {
    session.window.dialog = Dialog::SaveScene;
}

void save(Session& session) {
    if (session.document.file.empty())
        return askSaveAs(session);
    const Result<void> saved = saveTo(session, session.document.file);
    report(session, saved);
    if (!saved)
        session.window.pending = Pending::None;
}

Result<void> saveTo(Session& session, const std::filesystem::path& file,
                    const std::optional<FileFingerprint>& replaces) {
    const Result<Saving> saved = saveScene(session, file, replaces);
    if (!saved)
        return fail(saved.error());
    if (*saved == Saving::FileHasChanged) {
        session.window.dialog = Dialog::FileHasChanged;
        return {};
    }
    session.window.notice = {};
    finishPending(session);
    return {};
}

void requestQuit(Session& session) {
    askAboutChanges(session, Pending::Quit);
}

void askPictureScene(Session& session) {
    askAboutChanges(session, Pending::OpenPicture);
}

void requestOpen(Session& session, std::vector<std::filesystem::path> files) {
    if (files.size() == 1) {
        if (isLesson(files.front()))
            return askLesson(session, files.front().string());
        if (const Result<bool> scene = holdsScene(files.front()); !scene)
            return say(session, scene.error());
        if (isPictureWithScene(files.front())) {
            session.window.askedPicture = {files.front(), false};
            session.window.dialog = Dialog::Picture;
            return;
        }
    }
    const bool replaces = std::ranges::any_of(
        files, [](const std::filesystem::path& file) { return holdsScene(file).value_or(false); });
    if (files.empty())
        return;
    if (!replaces)
        return report(session, openFiles(session, files), files.front());
    session.window.pendingFiles = std::move(files);
    askAboutChanges(session, Pending::OpenFiles);
}

} // namespace texplorer::ui
