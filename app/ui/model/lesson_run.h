#pragma once

#include "app/ui/language/lesson_catalogue.h"
#include "app/ui/model/lesson_progress.h"
#include "app/ui/model/lesson_work.h"
#include "core/lesson/lesson_keys.h"
#include "core/lesson/lesson_scene.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace texplorer::ui {

struct Session;

/// A lesson that is open. What was done in which step outlives it: see lesson_progress.h.
struct LessonRun {
    LessonRun(lesson::LessonFolder from, lesson::Lesson what, std::size_t first, lesson::LessonScene scene)
        : folder(std::move(from))
        , key(progressKey(folder))
        , lesson(std::move(what))
        , step(first)
        , start(std::move(scene)) {}

    lesson::LessonFolder folder;
    std::string key; ///< see progressKey
    lesson::Lesson lesson;
    std::size_t step = 0;
    lesson::LessonScene start;                  ///< what the step begins with
    std::optional<Scene> target;                ///< to be reached; none: the step has no such task
    std::optional<std::size_t> answer;          ///< the one that was chosen
    std::optional<lesson::StepNumbers> numbers; ///< of its texts; none: they are being found
    lesson::PictureSize numbersFor;             ///< the picture for which they were asked for
    /// What the tab comes to be scrolled to with the next frame that shows it.
    enum class Scroll { None, Top, Verdict };
    Scroll wantedScroll = Scroll::None;
    bool awaitsImages = false;                            ///< those of `start` are still being read
    std::shared_ptr<const LessonWork::Pictures> pictures; ///< of the answers, or the one to be reached
    std::optional<lesson::Grade> grade;                   ///< of the scene that was last compared
    std::optional<Scene> asked;                           ///< the one that is, or was last
    bool wantsHint = false;                               ///< somebody has asked for it
    std::optional<Scene> hintAsked;             ///< the scene for which it is, or was last, looked for
    std::optional<LessonWork::Hinted> hint;     ///< what came of it
    Language language = Language::English;      ///< of the catalogue
    std::shared_ptr<const Catalogue> catalogue; ///< of the lesson's own texts; nullptr: English
    std::vector<std::filesystem::path> files;   ///< that it is written in; none: it is the program's own
    bool hasChanged = false;                    ///< one of them has, and was not read again yet
    std::string problem;                        ///< why not, as the user was told; empty: nothing is wrong
    lesson::ChosenChoices chosen;               ///< which choice of each of its keys the scene has
    std::vector<bool> usable;                   ///< which of its keys do something in this step
    std::optional<Scene> keyed;                 ///< the scene that `chosen` is about
    std::optional<std::size_t> heldKey;         ///< the last one of them that is down
    bool holdsKey = false;                      ///< one of them is held that goes on meanwhile

    /// A text of the lesson in the window's language.
    [[nodiscard]] std::string text(const std::string& english) const;
    /// One of the step's, with its numbers.
    [[nodiscard]] std::string stepText(const std::string& english) const;
    /// Why the right answer is right, once it was chosen.
    [[nodiscard]] std::string reason() const;
};

/// How much of a picture that was compared is wrong still, in percent; 0: it is reached.
[[nodiscard]] long percentWrong(const lesson::Grade& grade);

/// Opens it at the step where one was, in place of the scene, which is lost: see askLesson. Errors: those of
/// readLesson and startOf; nothing has changed then. Images of a folder come later, as those of any scene.
[[nodiscard]] Result<void> openLesson(Session& session, const lesson::LessonFolder& folder,
                                      std::optional<std::size_t> step = {});

/// One of the program's own, or a folder's. Errors: those of LessonFolder::builtIn and openLesson.
[[nodiscard]] Result<void> openLessonNamed(Session& session, const std::string& nameOrFolder,
                                           std::optional<std::size_t> step = {});

/// Whether the tab stays, with the list of all lessons.
enum class KeepsTab : bool { No, Yes };
void closeLesson(Session& session, KeepsTab tab = KeepsTab::No);

/// Another step, or the same one from its start.
void goToLessonStep(Session& session, std::size_t step);

/// What the student thinks. The right answer shows its picture's scene, and soon why.
void answerQuestion(Session& session, std::size_t answer);

/// What shows it: the picture in the view, and the driver.
struct LessonPlace {
    lesson::PictureSize picture;
    int units = maxUnits; ///< how many texture units the driver has
};

/// To be called once a frame: takes what is ready, asks for the grade of a scene that has changed, for a hint
/// where one is wanted, and for the numbers of another picture. A driver that turns out to have fewer texture
/// units begins the step anew.
void followLesson(Session& session, const LessonPlace& place);

/// The files of a lesson's folder have changed: it is read again, and the step that is shown stays where it
/// was; where one can't be read or says something wrong, everything stays, and the user is told.
void reloadLesson(Session& session);

} // namespace texplorer::ui
