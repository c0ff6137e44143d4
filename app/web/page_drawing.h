#pragma once

#include "texplorer/reference/draw_worker.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace texplorer::web {

/// Pictures of the reference that a Web Worker of the page draws, which has an instance of the program for
/// itself. A request is sent as the scene's text, with files that the worker does not have yet.
class PageDrawing final : public reference::DrawPlace {
public:
    PageDrawing() = default;
    PageDrawing(const PageDrawing&) = delete;
    PageDrawing& operator=(const PageDrawing&) = delete;
    ~PageDrawing() override { stop(); }

    // Unlike a thread, it stops only two pictures, once they take long: a dropped one, and a whole one after
    // a coarse one.
    void ask(std::uint64_t number, std::optional<reference::DrawRequest> request) override;
    void drop(const std::function<bool(const reference::DrawRequest&)>& isUseless) override;
    [[nodiscard]] std::vector<Answer> take() override { return std::exchange(answers_, {}); }
    [[nodiscard]] bool isWorking() const override { return running_ || waiting_; }
    void wait() const override {} // a page can't block

    /// The worker's number in the page; 0: there is none.
    [[nodiscard]] unsigned worker() const { return worker_; }
    /// Stops what is not wanted and takes long. Returns after how many seconds to call it again; nothing:
    /// after the next request.
    std::optional<double> check();
    /// The worker has drawn.
    void drawn(Image image, double milliseconds, std::vector<Sentence> problems);
    /// The worker has ended. `reason`: empty if it has not begun.
    void failed(const Sentence& reason);

private:
    struct Job {
        std::uint64_t number = 0;
        reference::DrawRequest request;
        int factor = 1;        ///< by which the picture is smaller
        bool refining = false; ///< a coarse one came before
        bool dropped = false;
        double begin = 0; ///< seconds (steadySeconds)
    };

    void startNext();
    void send(Job& job);
    void sendFiles(const reference::DrawRequest& request);
    void answer(const Job& job, reference::DrawnPicture picture);
    /// Ends the worker, which is the only way to stop it.
    void stop();

    unsigned worker_ = 0;
    double nextTry_ = 0;       ///< seconds (steadySeconds), before which no worker is made
    double made_ = 0;          ///< seconds (steadySeconds), when the worker was made
    double patience_ = 2;      ///< seconds until work is stopped: not less than what a new worker needs
    bool hasAnswered_ = false; ///< the worker
    std::map<std::string, std::shared_ptr<const Bytes>> sent_; ///< the files that the worker has
    std::optional<Job> running_;
    std::optional<Job> waiting_;
    std::vector<Answer> answers_;
    double millisecondsPerPixel_ = 2e-4; ///< a guess, before anything was drawn
};

} // namespace texplorer::web
