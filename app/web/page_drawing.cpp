#include "app/web/page_drawing.h"

#include "app/web/browser.h"
#include "texplorer/base/clock.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/json.h"

#include <algorithm>
#include <utility>

namespace texplorer::web {
namespace {

using reference::DrawRequest;

constexpr double leastPatience = 0.2; // seconds
constexpr double mostPatience = 3;
constexpr double pause = 5; // seconds after a worker that could not be loaded

double pixelsOf(const DrawRequest& request) {
    return static_cast<double>(request.width) * request.height;
}

int extent(int whole, int factor) {
    return std::max(1, whole / factor);
}

} // namespace

void PageDrawing::ask(std::uint64_t number, std::optional<DrawRequest> request) {
    waiting_.reset();
    if (!request) {
        stop(); // its memory is freed only with it
        return;
    }
    waiting_ = Job{.number = number, .request = *std::move(request)};
    static_cast<void>(check());
    startNext();
}

std::optional<double> PageDrawing::check() {
    if (!running_ || !waiting_ || !(running_->dropped || running_->refining))
        return std::nullopt;
    const double elapsed = steadySeconds() - running_->begin;
    if (elapsed < patience_)
        return patience_ - elapsed;
    const double left = millisecondsPerPixel_ / 1000 * pixelsOf(running_->request) - elapsed;
    if (!running_->dropped && left > 0 && left < patience_)
        return left + leastPatience; // it should be done before another worker could begin
    stop();
    startNext();
    return answers_.empty() ? std::nullopt : std::optional(0.0);
}

void PageDrawing::drop(const std::function<bool(const DrawRequest&)>& isUseless) {
    if (waiting_ && isUseless(waiting_->request))
        waiting_.reset();
    if (running_ && isUseless(running_->request))
        running_->dropped = true;
}

void PageDrawing::stop() {
    if (worker_ != 0)
        browser::dropWorker(worker_);
    worker_ = 0;
    sent_.clear();
    running_.reset();
}

void PageDrawing::startNext() {
    if (running_ || !waiting_)
        return;
    running_ = std::exchange(waiting_, std::nullopt);
    if (worker_ == 0 && steadySeconds() >= nextTry_) {
        worker_ = browser::makeWorker();
        made_ = steadySeconds();
        hasAnswered_ = false;
    }
    if (worker_ == 0)
        return failed({});
    const DrawRequest& request = running_->request;
    running_->factor = reference::coarseness(millisecondsPerPixel_ * pixelsOf(request));
    sendFiles(request);
    send(*running_);
}

void PageDrawing::sendFiles(const DrawRequest& request) {
    std::map<std::string, std::shared_ptr<const Bytes>> files;
    for (const std::string& name : filesOf(request.scene)) {
        std::shared_ptr<const Bytes> file = request.images.fileInMemory(name);
        if (!file && request.images.holds(name)) { // of unsaved work that was just opened
            if (Result<Bytes> read = readFile(request.images.directory() / name))
                file = std::make_shared<const Bytes>(*std::move(read));
        }
        if (file)
            files.emplace(name, std::move(file));
    }
    for (const auto& [name, file] : sent_) {
        if (!files.contains(name))
            browser::sendFile(worker_, name.data(), lengthOf(name), nullptr, -1);
    }
    for (const auto& [name, file] : files) {
        const auto before = sent_.find(name);
        if (before == sent_.end() || before->second != file)
            browser::sendFile(worker_, name.data(), lengthOf(name), file->data(), lengthOf(*file));
    }
    sent_ = std::move(files);
}

void PageDrawing::send(Job& job) {
    const DrawRequest& request = job.request;
    const std::string scene = writeScene(request.scene);
    job.begin = steadySeconds();
    browser::drawInWorker(worker_, scene.data(), lengthOf(scene), request.time,
                          extent(request.width, job.factor), extent(request.height, job.factor),
                          static_cast<unsigned>(request.anisotropy), static_cast<unsigned>(request.rho));
}

void PageDrawing::answer(const Job& job, reference::DrawnPicture picture) {
    if (job.dropped)
        return;
    answers_.clear(); // only the newest is shown
    answers_.push_back({job.number, std::move(picture)});
}

void PageDrawing::drawn(Image image, double milliseconds, std::vector<Sentence> problems) {
    if (!running_)
        return;
    if (!std::exchange(hasAnswered_, true))
        patience_ = std::clamp(steadySeconds() - made_, leastPatience, mostPatience);
    Job& job = *running_;
    reference::DrawnPicture picture{nullptr, std::move(problems), milliseconds, job.factor == 1};
    if (!image.empty()) {
        millisecondsPerPixel_ = milliseconds / (static_cast<double>(image.width) * image.height);
        picture.image = std::make_shared<const Image>(std::move(image));
    }
    answer(job, std::move(picture));
    if (std::exchange(job.factor, 1) > 1 && !waiting_ && !job.dropped) {
        job.refining = true;
        return send(job);
    }
    running_.reset();
    startNext();
}

void PageDrawing::failed(const Sentence& reason) {
    if (reason.empty() && steadySeconds() >= nextTry_)
        nextTry_ = steadySeconds() + pause;
    const Sentence said =
        reason.empty() ? Sentence(N_("the browser can't load a worker of the page")) : reason;
    if (running_)
        answer(*running_, {nullptr, {Sentence("the picture can't be drawn: {0}", said)}, 0, true});
    stop();
    startNext();
}

} // namespace texplorer::web
