#include "app/ui/services/sheet_pictures.h"

#include "texplorer/base/background_thread.h"
#include "texplorer/base/parallel.h"
#include "texplorer/scene/params/key_edits.h"

#include <algorithm>
#include <utility>

namespace texplorer::ui {
namespace {

constexpr FailureWords sheetFailure{N_("not enough memory for the pictures"),
                                    N_("the pictures can't be drawn")};

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

SheetPictures::SheetPictures(When when, std::function<void()> wake, LevelWork levels)
    : levels_(std::move(levels))
    , worker_(
          {when, JobOrder::NewestWins, sheetFailure, std::move(wake), levels_.stop},
          [this](const Drawing::Task& task) { return work(task); },
          [](const Job& job, const Error& error) {
              const std::size_t count = job.question ? job.question->cells() : 0;
              return Answer{job.number, Cells(count, Cell{nullptr, error.message, job.number})};
          }) {}

SheetPictures::Cell SheetPictures::draw(const Question& question, std::size_t cell,
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
    LevelWork work = levels_;
    work.stop = task.stop();
    Result<Frame> frame = renderer_.draw(
        request, {.threads = sheetThreads(task.atOnce()), .levels = std::move(work), .stop = task.stop()});
    if (frame)
        answer.image = std::make_shared<const Image>(std::move(frame->image));
    else
        answer.problem = describe(frame.error());
    return answer;
}

std::optional<SheetPictures::Answer> SheetPictures::work(const Drawing::Task& task) {
    const auto& [number, question] = task.job();
    if (!question) {
        renderer_.rest();
        drawn_.reset();
        made_.clear();
        return std::nullopt;
    }
    if (!task.atOnce())
        giveWay(); // the window has priority
    if (!drawn_ || !sameCells(*drawn_, *question)) {
        made_.assign(question->cells(), {});
        next_ = 0;
    }
    drawn_ = *question;
    for (std::size_t count = 0; count < made_.size(); ++count) {
        Cell cell = draw(*question, next_, task);
        if (task.stop().stop_requested())
            return std::nullopt;
        made_[next_] = std::move(cell);
        next_ = (next_ + 1) % made_.size();
        if (task.superseded().stop_requested())
            break; // the newer question continues from here
        if (count + 1 < made_.size() && !task.atOnce())
            task.give({number, made_});
    }
    return Answer{number, made_};
}

bool SheetPictures::ask(const Question& question) {
    bool news = false;
    if (wanted_ != question) {
        const bool same = wanted_ && sameCells(*wanted_, question);
        wanted_ = question;
        ++lastNumber_;
        if (!same) {
            firstOfThese_ = lastNumber_;
            shown_.assign(question.cells(), {});
            worker_.drop([](const Job& job) { return job.question.has_value(); });
        }
        worker_.ask({lastNumber_, question});
    }
    for (Answer& answer : worker_.take()) {
        if (answer.number >= firstOfThese_ && answer.cells.size() == shown_.size()) {
            news = true;
            shown_ = std::move(answer.cells);
        }
    }
    return news;
}

SheetPictures::Cells SheetPictures::cells(const SweepAxis& rows, const SweepAxis& columns) const {
    return wanted_ && wanted_->rows == rows && wanted_->columns == columns
               ? shown_
               : Cells(rows.values.size() * columns.values.size());
}

void SheetPictures::rest() {
    if (!wanted_)
        return;
    wanted_.reset();
    shown_.clear();
    worker_.clear();
    worker_.ask({++lastNumber_, std::nullopt});
}

} // namespace texplorer::ui
