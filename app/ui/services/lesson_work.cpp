#include "app/ui/services/lesson_work.h"

#include <utility>

namespace texplorer::ui {
namespace {

std::shared_ptr<const Image> drawnOrNull(const lesson::LessonScene& scene, std::stop_token stop) {
    Result<Image> drawn = lesson::drawSmall(scene, std::move(stop));
    return drawn ? std::make_shared<const Image>(*std::move(drawn)) : nullptr;
}

} // namespace

LessonWork::LessonWork(When when, const std::function<void()>& wake)
    : pictures(
          when, wake,
          [](const auto& task) {
              auto drawn = std::make_shared<Pictures>();
              for (const Pictured& scene : task.job())
                  drawn->push_back(scene ? drawnOrNull(*scene, task.superseded()) : nullptr);
              return drawn;
          },
          [](const std::vector<Pictured>& scenes) { return std::make_shared<const Pictures>(scenes.size()); })
    , grades(when, wake,
             [](const auto& task) -> std::optional<Graded> {
                 const auto& [scene, target, images] = task.job();
                 Result<lesson::Grade> grade = lesson::gradeMatch(scene, target, images, task.superseded());
                 return grade ? std::optional(Graded{scene, *std::move(grade)}) : std::nullopt;
             })
    , hints(when, wake,
            [](const auto& task) -> std::optional<Hinted> {
                const auto& [scene, target, images] = task.job();
                auto hint = lesson::hintFor(scene, target, images, task.superseded());
                return hint ? std::optional(Hinted{scene, *std::move(hint)}) : std::nullopt;
            })
    , numbers(
          when, wake,
          [](const auto& task) {
              const auto& [start, step, picture] = task.job();
              return numbersOf(start, step, picture, task.superseded()).value_or(lesson::StepNumbers{});
          },
          [](const Marked& /*marked*/) { return lesson::StepNumbers{}; }) {}

void LessonWork::rest() {
    pictures.rest();
    grades.rest();
    hints.rest();
    numbers.rest();
}

} // namespace texplorer::ui
