#pragma once

#include "texplorer/base/worker.h"
#include "texplorer/lesson/lesson_scene.h"
#include "texplorer/lesson/match.h"
#include "texplorer/lesson/numbers.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace texplorer::ui {

/// Draws the small pictures of a lesson, compares them, looks for hints and for the numbers of its texts,
/// without blocking the window. Call all functions on one thread.
class LessonWork {
public:
    /// `wake` is called on the working thread when there is a result.
    explicit LessonWork(When when, std::function<void()> wake = {});

    using Pictured = std::optional<lesson::LessonScene>;

    /// One picture per scene; nullptr if there is no scene, or if it could not be drawn.
    using Pictures = std::vector<std::shared_ptr<const Image>>;

    /// Requests the pictures of a step. Cancels an earlier request.
    void askPictures(std::vector<Pictured> scenes);

    /// Requests a comparison of the scene with the target. Replaces a waiting request.
    void askGrade(Scene scene, Scene target, ImageSource images);

    /// Requests the parameter that brings the scene closest to the target.
    void askHint(Scene scene, Scene target, ImageSource images);

    /// Requests the numbers of a step's texts, in a picture of this size.
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
    /// Without numbers if they cannot be computed.
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
