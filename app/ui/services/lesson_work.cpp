#include "app/ui/services/lesson_work.h"

#include <utility>

namespace texplorer::ui {
namespace {

std::shared_ptr<const Image> drawnOrNull(const lesson::LessonScene& scene, std::stop_token stop) {
    Result<Image> drawn = lesson::drawSmall(scene, std::move(stop));
    return drawn ? std::make_shared<const Image>(*std::move(drawn)) : nullptr;
}

} // namespace

LessonWork::LessonWork(When when, std::function<void()> wake)
    : pictures_(
          {.when = when, .order = JobOrder::NewestWins, .wake = wake},
          [](const PictureWorker::Task& task) {
              auto pictures = std::make_shared<Pictures>();
              for (const Pictured& scene : task.job()) {
                  pictures->push_back(scene ? drawnOrNull(*scene, task.superseded()) : nullptr);
              }
              return std::optional<std::shared_ptr<const Pictures>>(std::move(pictures));
          },
          [](const std::vector<Pictured>& scenes, const Error& /*error*/) {
              return std::make_shared<const Pictures>(scenes.size());
          })
    , grades_(
          {.when = when, .order = JobOrder::NewestWins, .wake = wake},
          [](const GradeWorker::Task& task) {
              const Question& question = task.job();
              Result<lesson::Grade> grade =
                  lesson::gradeMatch(question.scene, question.target, question.images, task.superseded());
              return std::optional(grade ? std::optional(Graded{question.scene, *std::move(grade)})
                                         : std::nullopt);
          },
          [](const Question& /*question*/, const Error& /*error*/) { return std::optional<Graded>(); })
    , hints_(
          {.when = when, .order = JobOrder::NewestWins, .wake = wake},
          [](const HintWorker::Task& task) {
              const Question& question = task.job();
              auto hint =
                  lesson::hintFor(question.scene, question.target, question.images, task.superseded());
              return std::optional(hint ? std::optional(Hinted{question.scene, *std::move(hint)})
                                        : std::nullopt);
          },
          [](const Question& /*question*/, const Error& /*error*/) { return std::optional<Hinted>(); })
    , numbers_(
          {.when = when, .order = JobOrder::NewestWins, .wake = std::move(wake)},
          [](const NumberWorker::Task& task) {
              const Marked& marked = task.job();
              return std::optional(numbersOf(marked.start, marked.step, marked.picture, task.superseded())
                                       .value_or(lesson::StepNumbers{}));
          },
          [](const Marked& /*marked*/, const Error& /*error*/) { return lesson::StepNumbers{}; }) {}

void LessonWork::askPictures(std::vector<Pictured> scenes) {
    pictures_.clear();
    if (!scenes.empty())
        pictures_.ask(std::move(scenes));
}

void LessonWork::askGrade(Scene scene, Scene target, ImageSource images) {
    grades_.ask({std::move(scene), std::move(target), std::move(images)});
}

void LessonWork::askHint(Scene scene, Scene target, ImageSource images) {
    hints_.ask({std::move(scene), std::move(target), std::move(images)});
}

void LessonWork::askNumbers(lesson::LessonScene start, lesson::Step step, lesson::PictureSize picture) {
    numbers_.clear();
    numbers_.ask({std::move(start), std::move(step), picture});
}

std::shared_ptr<const LessonWork::Pictures> LessonWork::takePictures() {
    std::vector<std::shared_ptr<const Pictures>> made = pictures_.take();
    return made.empty() ? nullptr : std::move(made.back());
}

std::optional<LessonWork::Graded> LessonWork::takeGrade() {
    std::vector<std::optional<Graded>> made = grades_.take();
    return made.empty() ? std::nullopt : std::move(made.back());
}

std::optional<LessonWork::Hinted> LessonWork::takeHint() {
    std::vector<std::optional<Hinted>> made = hints_.take();
    return made.empty() ? std::nullopt : std::move(made.back());
}

std::optional<lesson::StepNumbers> LessonWork::takeNumbers() {
    std::vector<lesson::StepNumbers> made = numbers_.take();
    return made.empty() ? std::nullopt : std::optional(std::move(made.back()));
}

void LessonWork::rest() {
    pictures_.clear();
    grades_.clear();
    hints_.clear();
    numbers_.clear();
}

} // namespace texplorer::ui
