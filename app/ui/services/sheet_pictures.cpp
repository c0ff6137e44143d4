#include "app/ui/services/sheet_pictures.h"

#include "texplorer/base/background_thread.h"
#include "texplorer/base/parallel.h"
#include "texplorer/scene/params/key_edits.h"

#include <algorithm>
#include <utility>

namespace texplorer::ui {
namespace {

constexpr FailureWords sheetFailure{"not enough memory for the pictures", "the pictures can't be drawn"};

/// Whether pictures of one question can be shown for the other until its own are ready.
bool sameCells(const SheetPictures::Question& a, const SheetPictures::Question& b) {
    return a.rows == b.rows && a.columns == b.columns;
}

/// Not all of them: the window needs some.
unsigned sheetThreads(bool atOnce) {
    return atOnce ? processorThreads() : std::max(1U, processorThreads() / 2);
}

} // namespace

Result<Scene> sheetScene(const Scene& scene, const SweepAxis& rows, std::size_t row, const SweepAxis& columns,
                         std::size_t column) {
    Scene made = scene;
    for (const SweepAxis* axis : {&rows, &columns})
        dropKeys(made.timeline, axis->path); // they would override the value
    if (const Result<void> set = setParam(made, rows.path, rows.values.at(row)); !set)
        return fail(set.error());
    if (const Result<void> set = setParam(made, columns.path, columns.values.at(column)); !set)
        return fail(set.error());
    return made;
}

struct SheetPictures::State {
    State(When when, std::function<void()> wake, LevelWork how)
        : levels(std::move(how))
        , worker(
              {when, JobOrder::NewestWins, sheetFailure, std::move(wake), levels.stop},
              [this](const Drawing::Task& task) { return work(task); },
              [](const Job& job, const Error& error) {
                  const std::size_t count = job.question ? job.question->cells() : 0;
                  return Answer{job.number, Cells(count, Cell{nullptr, error.message, job.number})};
              }) {}

    struct Job {
        std::uint64_t number = 0;
        std::optional<Question> question; ///< nothing: free the renderer's memory
    };
    struct Answer {
        std::uint64_t number = 0;
        Cells cells;
    };
    using Drawing = Worker<Job, Answer>;

    // Used by the requesting thread.
    std::optional<Question> wanted;
    std::uint64_t lastNumber = 0;
    std::uint64_t firstOfThese = 0; ///< the number of the first question about these cells
    Cells shown;

    // Used by the drawing thread.
    const LevelWork levels;
    reference::ReferenceRenderer renderer;
    std::optional<Question> drawn; ///< the question of `made`
    Cells made;
    std::size_t next = 0; ///< the next cell to draw

    Drawing worker; // last member: it ends before the others

    std::optional<Answer> work(const Drawing::Task& task);
    Cell draw(const Question& question, std::size_t cell, const Drawing::Task& task);
};

SheetPictures::Cell SheetPictures::State::draw(const Question& question, std::size_t cell,
                                               const Drawing::Task& task) {
    const std::size_t columns = question.columns.values.size();
    Cell answer{.question = task.job().number};
    Result<Scene> scene =
        sheetScene(question.picture.scene, question.rows, cell / columns, question.columns, cell % columns);
    if (!scene) {
        answer.problem = describe(scene.error());
        return answer;
    }
    reference::DrawRequest request = question.picture;
    request.scene = *std::move(scene);
    LevelWork work = levels;
    work.stop = task.stop();
    Result<Frame> frame = renderer.draw(
        request, {.threads = sheetThreads(task.atOnce()), .levels = std::move(work), .stop = task.stop()});
    if (frame)
        answer.image = std::make_shared<const Image>(std::move(frame->image));
    else
        answer.problem = describe(frame.error());
    return answer;
}

std::optional<SheetPictures::State::Answer> SheetPictures::State::work(const Drawing::Task& task) {
    const auto& [number, question] = task.job();
    if (!question) {
        renderer.rest();
        drawn.reset();
        made.clear();
        return std::nullopt;
    }
    if (!task.atOnce())
        giveWay(); // the window has priority
    if (!drawn || !sameCells(*drawn, *question)) {
        made.assign(question->cells(), {});
        next = 0;
    }
    drawn = *question;
    for (std::size_t count = 0; count < made.size(); ++count) {
        Cell cell = draw(*question, next, task);
        if (task.stop().stop_requested())
            return std::nullopt;
        made[next] = std::move(cell);
        next = (next + 1) % made.size();
        if (task.superseded().stop_requested())
            break; // the newer question continues from here
        if (count + 1 < made.size() && !task.atOnce())
            task.give({number, made});
    }
    return Answer{number, made};
}

SheetPictures::SheetPictures(When when, std::function<void()> wake, LevelWork levels)
    : state_(std::make_unique<State>(when, std::move(wake), std::move(levels))) {}

SheetPictures::~SheetPictures() = default;

bool SheetPictures::ask(const Question& question) {
    State& state = *state_;
    bool news = false;
    if (state.wanted != question) {
        const bool same = state.wanted && sameCells(*state.wanted, question);
        state.wanted = question;
        ++state.lastNumber;
        if (!same) {
            state.firstOfThese = state.lastNumber;
            state.shown.assign(question.cells(), {});
            state.worker.drop([](const State::Job& job) { return job.question.has_value(); });
        }
        state.worker.ask({state.lastNumber, question});
    }
    for (State::Answer& answer : state.worker.take()) {
        if (answer.number >= state.firstOfThese && answer.cells.size() == state.shown.size()) {
            news = true;
            state.shown = std::move(answer.cells);
        }
    }
    return news;
}

SheetPictures::Cells SheetPictures::cells(const SweepAxis& rows, const SweepAxis& columns) const {
    const std::optional<Question>& wanted = state_->wanted;
    return wanted && wanted->rows == rows && wanted->columns == columns
               ? state_->shown
               : Cells(rows.values.size() * columns.values.size());
}

void SheetPictures::rest() {
    State& state = *state_;
    if (!state.wanted)
        return;
    state.wanted.reset();
    state.shown.clear();
    state.worker.clear();
    state.worker.ask({++state.lastNumber, std::nullopt});
}

void SheetPictures::wait() const {
    state_->worker.wait();
}

} // namespace texplorer::ui
