#pragma once

#include "core/base/worker.h"
#include "core/lesson/lesson_scene.h"
#include "core/lesson/match.h"
#include "core/lesson/numbers.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace texplorer::ui {

/// Draws the small pictures of a lesson, compares them, looks for hints and for the numbers of its texts, for
/// a window that must not wait. All functions are to be called from one thread.
class LessonWork {
public:
    /// `wake` is called on the thread that works whenever there is something new.
    explicit LessonWork(When when, std::function<void()> wake = {});

    using Pictured = std::optional<lesson::LessonScene>;

    /// Of each scene; nullptr where there is none, or it couldn't be drawn.
    using Pictures = std::vector<std::shared_ptr<const Image>>;

    /// Of a step. What was asked before is forgotten.
    void askPictures(std::vector<Pictured> scenes);

    /// The scene is compared with the one to be reached. An earlier question that waits is forgotten.
    void askGrade(Scene scene, Scene target, ImageSource images);

    /// Which parameter brings the scene nearest.
    void askHint(Scene scene, Scene target, ImageSource images);

    /// The numbers of a step's texts, in a picture of this size.
    void askNumbers(lesson::LessonScene start, lesson::Step step, lesson::PictureSize picture);

    struct Graded {
        Scene scene;
        lesson::Grade grade;
    };
    struct Hinted {
        Scene scene;
        std::optional<SceneChange> hint;
    };
    [[nodiscard]] std::shared_ptr<const Pictures> takePictures();
    [[nodiscard]] std::optional<Graded> takeGrade();
    [[nodiscard]] std::optional<Hinted> takeHint();
    /// Without numbers where they can't be found.
    [[nodiscard]] std::optional<lesson::StepNumbers> takeNumbers();

    void rest();

private:
    using PictureWorker = Worker<std::vector<Pictured>, std::shared_ptr<const Pictures>>;
    struct Question {
        Scene scene;
        Scene target;
        ImageSource images;
    };
    using GradeWorker = Worker<Question, std::optional<Graded>>;
    using HintWorker = Worker<Question, std::optional<Hinted>>;
    struct Marked {
        lesson::LessonScene start;
        lesson::Step step;
        lesson::PictureSize picture;
    };
    using NumberWorker = Worker<Marked, lesson::StepNumbers>;

    PictureWorker pictures_;
    GradeWorker grades_;
    HintWorker hints_;
    NumberWorker numbers_;
};

} // namespace texplorer::ui
