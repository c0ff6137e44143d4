#pragma once

#include "app/ui/language/lesson_catalogue.h"
#include "app/ui/services/lesson_work.h"
#include "app/ui/state/lesson_records.h"
#include "app/ui/state/view_settings.h"
#include "texplorer/lesson/lesson_keys.h"
#include "texplorer/lesson/lesson_scene.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace texplorer::ui {

/// The scene and the choices after a key was pressed, until the step is made.
struct PressedKey {
    Scene scene;
    lesson::ChosenChoices chosen; ///< of that scene; several choices may fit it
};

/// The pictures that a lesson's step shows, and those that it replaced.
struct LessonPictures {
    ShownPictures before{};
    ShownPictures chosen{};
};

/// What has happened in a lesson's step since it began.
struct LessonStepRun {
    std::optional<Scene> target{};                ///< the target scene; none: the step has no such task
    std::optional<std::size_t> answer{};          ///< the chosen answer
    std::optional<lesson::StepNumbers> numbers{}; ///< in its texts; none: they are being computed
    lesson::PictureSize numbersFor{};             ///< the picture of the requested numbers
    /// Where the tab scrolls to in the next frame that shows it.
    enum class Scroll { None, Top, Verdict };
    Scroll wantedScroll = Scroll::None;
    std::shared_ptr<const LessonWork::Pictures> pictures{}; ///< of the answers, or of the target
    std::optional<lesson::Grade> grade{};                   ///< of the last compared scene
    std::optional<Scene> asked{};                           ///< the scene that was last sent for comparison
    bool wantsHint = false;                                 ///< a hint was requested
    std::optional<Scene> hintAsked{};                       ///< the scene of the last search for a hint
    std::optional<LessonWork::Hinted> hint{};               ///< its result
};

/// An open lesson. The results of its steps are kept longer: see lesson_progress.h.
struct LessonRun : LessonStepRun {
    LessonRun(lesson::LessonFolder from, lesson::Lesson what, std::size_t first, lesson::LessonScene scene)
        : folder(std::move(from))
        , key(progressKey(folder))
        , lesson(std::move(what))
        , step(first)
        , start(std::move(scene)) {}

    lesson::LessonFolder folder;
    std::string key;                        ///< see progressKey
    std::optional<LessonPictures> lookedAt; ///< of its step
    lesson::Lesson lesson;
    std::size_t step = 0;
    lesson::LessonScene start;                  ///< the step's initial scene
    bool awaitsImages = false;                  ///< images of `start` are still being read
    Language language = Language::English;      ///< of the catalogue
    std::shared_ptr<const Catalogue> catalogue; ///< of the lesson's own texts; nullptr: English
    std::vector<std::filesystem::path> files;   ///< its files; none: a built-in lesson
    bool hasChanged = false;                    ///< a file has changed and was not read again yet
    std::string problem;                        ///< the reported error of reading it; empty: none
    lesson::ChosenChoices chosen;               ///< the current choice of each of its keys
    std::vector<bool> usable;                   ///< which of its keys have an effect in this step
    std::optional<Scene> keyed;                 ///< the scene of `chosen`
    std::optional<PressedKey> pressed;          ///< the last one that has selected another choice
    std::optional<std::size_t> heldKey;         ///< the last pressed one of its keys
    bool holdsKey = false;                      ///< a key with a continuous effect is held

    /// A text of the lesson in the window's language.
    [[nodiscard]] std::string text(const std::string& english) const;
    /// A text of the step with its numbers.
    [[nodiscard]] std::string stepText(const std::string& english) const;
    /// Why the right answer is right; empty until it was chosen.
    [[nodiscard]] std::string reason() const;
};

/// The wrong part of a compared picture in percent; 0: the target is reached.
[[nodiscard]] long percentWrong(const lesson::Grade& grade);

} // namespace texplorer::ui
