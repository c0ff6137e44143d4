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

/// Runs an action.
struct Finish {
    Session& session;

    void operator()(std::monostate /*nothing*/) const {}
    void operator()(pending::NewScene /*action*/) const { newScene(session); }
    void operator()(const pending::Example& action) const {
        report(session, openExample(session, action.file));
    }
    void operator()(const pending::Lesson& action) const {
        report(session, openLessonNamed(session, action.nameOrFolder));
    }
    void operator()(pending::ChooseScene /*action*/) const { session.asking.dialog = Dialog::OpenScene; }
    void operator()(const pending::OpenFiles& action) const {
        report(session, openFiles(session, action.files), action.files.front());
    }
    void operator()(const pending::OpenScene& action) const {
        report(session, openScene(session, action.file), action.file);
    }
    void operator()(const pending::ShowScene& action) const {
        action.load->before = session.document.scene; // the user has answered
        showLoadedScene(session, std::move(*action.load));
    }
    void operator()(pending::Quit /*action*/) const { session.asking.quitConfirmed = true; }
};

bool isLesson(const std::filesystem::path& folder) {
    std::error_code ignored;
    return std::filesystem::is_directory(folder, ignored) &&
           lesson::LessonFolder::onDisk(folder).has(lesson::lessonFileName);
}

} // namespace

void finishPending(Session& session) {
    std::visit(Finish{session}, std::exchange(session.asking.pending, {}));
}

void askLesson(Session& session, std::string nameOrFolder) {
    askAboutChanges(session, pending::Lesson{std::move(nameOrFolder)});
}

void askOpenScene(Session& session) {
    askAboutChanges(session, pending::ChooseScene{});
}

void askOpenImage(Session& session, std::string param) {
    session.asking.dialog = Dialog::OpenImage;
    session.asking.imageParam = std::move(param);
}

void askNewScene(Session& session) {
    askAboutChanges(session, pending::NewScene{});
}

void askExample(Session& session, std::string_view file) {
    askAboutChanges(session, pending::Example{std::string(file)});
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
    askAboutChanges(session, pending::OpenScene{std::exchange(session.asking.picture, {}).file});
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
    const bool replaces = std::ranges::any_of(
        files, [](const std::filesystem::path& file) { return holdsScene(file).value_or(false); });
    if (files.empty())
        return;
    if (!replaces)
        return report(session, openFiles(session, files), files.front());
    askAboutChanges(session, pending::OpenFiles{std::move(files)});
}

} // namespace texplorer::ui
