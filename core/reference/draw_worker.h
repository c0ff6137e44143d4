#pragma once

#include "texplorer/base/worker.h"
#include "texplorer/reference/draw.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace texplorer::reference {

/// What a window shows of a request.
struct DrawnPicture {
    /// Bottom row first; nullptr: none yet. A coarse picture is smaller than requested. Until there is a
    /// picture of this request, that of an earlier one.
    std::shared_ptr<const Image> image;
    std::vector<Sentence> problems; ///< as in texplorer::Frame, or why it cannot be drawn
    double milliseconds = 0;        ///< the duration of drawing
    bool whole = false;             ///< it equals drawReference of this request
};

/// Where a DrawWorker's pictures are drawn, one after the other. If the whole picture takes long, a coarse
/// one comes first.
class DrawPlace {
public:
    virtual ~DrawPlace() = default;

    /// Replaces the waiting request and stops the whole picture of an earlier one. Nothing: frees the
    /// renderer's memory.
    virtual void ask(std::uint64_t number, std::optional<DrawRequest> request) = 0;
    /// Stops and drops the requests for which `isUseless` is true.
    virtual void drop(const std::function<bool(const DrawRequest&)>& isUseless) = 0;

    struct Answer {
        std::uint64_t number = 0; ///< of the request
        DrawnPicture picture;
    };
    /// Returns the new answers, in order.
    [[nodiscard]] virtual std::vector<Answer> take() = 0;
    [[nodiscard]] virtual bool isWorking() const = 0;
    /// Blocks until nothing is pending.
    virtual void wait() const = 0;
};

/// Draws for a window without blocking it, on a thread of its own or in another place. A new request stops
/// the current drawing. A coarse picture is stopped only if other levels are needed (sameLevels), so that
/// pictures keep coming while a user drags or a scene moves. All functions must be called from one thread;
/// the first request starts the other.
class DrawWorker {
public:
    using When = texplorer::When; ///< AtOnce: whole pictures only
    using Frame = DrawnPicture;

    /// `wake` is called on the working thread whenever `frame` has a new result; it must not throw. `levels`
    /// are the options for textures that are compressed at run time; its `stop` ends drawing AtOnce.
    explicit DrawWorker(When when, std::function<void()> wake = {}, LevelWork levels = {});
    explicit DrawWorker(std::unique_ptr<DrawPlace> place);
    DrawWorker(const DrawWorker&) = delete;
    DrawWorker& operator=(const DrawWorker&) = delete;
    /// Stops the current drawing and waits for it.
    ~DrawWorker();

    /// Requests a picture and returns the newest one.
    [[nodiscard]] const Frame& frame(const DrawRequest& request);

    /// Stops drawing, and frees the picture and the textures. For a hidden view.
    void rest();

    /// Whether a picture is pending.
    [[nodiscard]] bool isDrawing() const;

    /// Blocks until nothing is pending.
    void wait() const;

private:
    std::unique_ptr<DrawPlace> place_;
    std::optional<DrawRequest> wanted_;
    std::uint64_t lastNumber_ = 0; ///< of the request for `wanted_`
    Frame shown_;                  ///< the newest picture
};

/// Returns the factor per axis by which the first picture is smaller: chosen so that it appears without
/// noticeable delay; 1 if the whole picture does.
[[nodiscard]] int coarseness(double expectedMilliseconds);

} // namespace texplorer::reference
