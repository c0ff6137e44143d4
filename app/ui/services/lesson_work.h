#pragma once

#include "app/ui/services/newest_answer.h"
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
struct LessonWork {
    /// `wake` is called on the working thread when there is a result.
    explicit LessonWork(When when, const std::function<void()>& wake = {});

    using Pictured = std::optional<lesson::LessonScene>;
    /// One picture per scene; nullptr if there is no scene, or if it could not be drawn.
    using Pictures = std::vector<std::shared_ptr<const Image>>;

    struct Comparison {
        Scene scene;
        Scene target;
        ImageSource images;
    };
    struct Graded {
        Scene scene;
        lesson::Grade grade;
    };
    struct Hinted {
        Scene scene;
        std::optional<SceneChange> hint; ///< the parameter that brings the scene closest to the target
    };
    struct Marked {
        lesson::LessonScene start;
        lesson::Step step;
        lesson::PictureSize picture;
    };

    void rest();

    NewestAnswer<std::vector<Pictured>, std::shared_ptr<const Pictures>> pictures; ///< of a step
    NewestAnswer<Comparison, Graded> grades;
    NewestAnswer<Comparison, Hinted> hints;
    /// Of a step's texts, in a picture of this size; without numbers if they cannot be computed.
    NewestAnswer<Marked, lesson::StepNumbers> numbers;
};

} // namespace texplorer::ui
