#include "texplorer/reference/draw_worker.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <utility>

namespace texplorer::reference {

namespace {

constexpr double noticed = 30; // milliseconds
constexpr int coarsest = 8;
constexpr double firstGuess = 2e-4; // milliseconds a pixel, before anything was drawn

constexpr FailureWords drawingFailure{N_("not enough memory for the picture"),
                                      N_("the picture can't be drawn")};

} // namespace

int coarseness(double expectedMilliseconds) {
    int factor = 1;
    while (factor < coarsest && expectedMilliseconds > noticed * factor * factor)
        factor *= 2;
    return factor;
}

namespace {

class OwnThread final : public DrawPlace {
public:
    OwnThread(When when, std::function<void()> wake, LevelWork how)
        : levels_(std::move(how))
        , worker_(
              {when, JobOrder::NewestWins, drawingFailure, std::move(wake), levels_.stop},
              [this](const Drawing::Task& task) { return work(task); },
              [](const Job& job, const Error& error) {
                  return Answer{job.number, {nullptr, {error.message}, 0, true}};
              }) {}

    void ask(std::uint64_t number, std::optional<DrawRequest> request) override {
        worker_.ask({number, std::move(request)});
    }
    void drop(const std::function<bool(const DrawRequest&)>& isUseless) override {
        worker_.drop([&](const Job& job) { return job.request && isUseless(*job.request); });
    }
    std::vector<Answer> take() override { return worker_.take(); }
    bool isWorking() const override { return worker_.isWorking(); }
    void wait() const override { worker_.wait(); }

private:
    struct Job {
        std::uint64_t number = 0;
        std::optional<DrawRequest> request; ///< nothing: give the renderer's memory back
    };
    using Drawing = Worker<Job, Answer>;

    std::optional<Answer> work(const Drawing::Task& task);
    std::optional<DrawnPicture> draw(const DrawRequest& request, int factor, const std::stop_token& stop);
    std::optional<DrawnPicture> tryToDraw(const DrawRequest& request, int factor,
                                          const std::stop_token& stop);

    // Used by the drawing thread.
    const LevelWork levels_;
    ReferenceRenderer renderer_;
    double millisecondsPerPixel_ = firstGuess;

    Drawing worker_; // last: it ends before the other members
};

/// Nothing where it was stopped.
std::optional<DrawnPicture> OwnThread::draw(const DrawRequest& request, int factor,
                                            const std::stop_token& stop) {
    Result<std::optional<DrawnPicture>> drawn =
        tried(drawingFailure, [&] { return tryToDraw(request, factor, stop); });
    return drawn ? std::move(*drawn) : DrawnPicture{nullptr, {drawn.error().message}, 0, factor == 1};
}

std::optional<DrawnPicture> OwnThread::tryToDraw(const DrawRequest& request, int factor,
                                                 const std::stop_token& stop) {
    const auto extent = [factor](int whole) { return factor == 1 ? whole : std::max(1, whole / factor); };
    DrawRequest coarse = request;
    coarse.width = extent(request.width);
    coarse.height = extent(request.height);
    LevelWork work = levels_;
    work.stop = stop;
    const auto begin = std::chrono::steady_clock::now();
    Result<texplorer::Frame> drawn = renderer_.draw(coarse, {.levels = std::move(work), .stop = stop});
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - begin;
    if (!drawn && drawn.error().code == ErrorCode::Cancelled)
        return std::nullopt;
    DrawnPicture frame;
    frame.milliseconds = elapsed.count();
    frame.whole = factor == 1;
    if (!drawn) {
        frame.problems = {describe(drawn.error())};
        return frame;
    }
    frame.image = std::make_shared<const Image>(std::move(drawn->image));
    frame.problems = std::move(drawn->problems);
    millisecondsPerPixel_ = elapsed.count() / (static_cast<double>(coarse.width) * coarse.height);
    return frame;
}

std::optional<DrawPlace::Answer> OwnThread::work(const Drawing::Task& task) {
    const auto& [number, request] = task.job();
    if (!request) {
        renderer_.rest();
        return std::nullopt;
    }
    const double pixels = static_cast<double>(request->width) * request->height;
    const int factor = task.atOnce() ? 1 : coarseness(pixels * millisecondsPerPixel_);
    std::optional<DrawnPicture> drawn = draw(*request, factor, task.stop());
    if (drawn && factor > 1) {
        task.give({number, std::move(*drawn)});
        drawn = draw(*request, 1, task.superseded());
    }
    return drawn ? std::optional(Answer{number, std::move(*drawn)}) : std::nullopt;
}

} // namespace

DrawWorker::DrawWorker(When when, std::function<void()> wake, LevelWork levels)
    : DrawWorker(std::make_unique<OwnThread>(when, std::move(wake), std::move(levels))) {}

DrawWorker::DrawWorker(std::unique_ptr<DrawPlace> place)
    : place_(std::move(place)) {}

DrawWorker::~DrawWorker() = default;

const DrawWorker::Frame& DrawWorker::frame(const DrawRequest& request) {
    if (wanted_ != request) {
        wanted_ = request;
        shown_.whole = false;
        place_->drop([&](const DrawRequest& earlier) { return !sameLevels(earlier, request); });
        place_->ask(++lastNumber_, request);
    }
    for (DrawPlace::Answer& answer : place_->take()) {
        shown_ = std::move(answer.picture);
        // Of an earlier request it is still nearer to what is wanted than what was there before.
        shown_.whole = shown_.whole && answer.number == lastNumber_;
    }
    return shown_;
}

void DrawWorker::rest() {
    if (!wanted_)
        return;
    wanted_.reset();
    shown_ = {};
    place_->drop([](const DrawRequest&) { return true; });
    place_->ask(++lastNumber_, std::nullopt);
    static_cast<void>(place_->take());
}

bool DrawWorker::isDrawing() const {
    return wanted_ && place_->isWorking();
}

void DrawWorker::wait() const {
    place_->wait();
}

} // namespace texplorer::reference
