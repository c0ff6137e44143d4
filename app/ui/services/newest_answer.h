#pragma once

#include "texplorer/base/worker.h"

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace texplorer::ui {

/// A worker for questions of which only the newest matters.
template<class Question, class Answer>
class NewestAnswer {
    using Answering = Worker<Question, std::optional<Answer>>;

public:
    using Task = typename Answering::Task;

    /// `failed` makes the answer for work that threw. An empty answer replaces an earlier one that was not
    /// taken.
    NewestAnswer(
        When when, std::function<void()> wake, std::function<std::optional<Answer>(const Task&)> work,
        std::function<std::optional<Answer>(const Question&)> failed =
            [](const Question&) { return std::optional<Answer>(); })
        : worker_(
              {.when = when, .order = JobOrder::NewestWins, .wake = std::move(wake)},
              [work = std::move(work)](const Task& task) -> std::optional<std::optional<Answer>> {
                  return work(task);
              },
              [failed = std::move(failed)](const Question& question, const Error&) {
                  return failed(question);
              }) {}

    /// Replaces a waiting question.
    void ask(Question question) { worker_.ask(std::move(question)); }
    /// The answer, once; nothing: there is none yet, or it is empty.
    [[nodiscard]] std::optional<Answer> take() {
        std::vector<std::optional<Answer>> made = worker_.take();
        return made.empty() ? std::nullopt : std::move(made.back());
    }
    /// Cancels the work and drops its answer.
    void rest() { worker_.clear(); }

private:
    Answering worker_;
};

} // namespace texplorer::ui
