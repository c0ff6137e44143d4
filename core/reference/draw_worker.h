#pragma once

#include "texplorer/base/worker.h"
#include "texplorer/reference/draw.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace texplorer::reference {

/// Draws for a window without blocking it, on a thread of its own; if the whole picture takes long, a coarse
/// one first. A new request stops the current drawing. A coarse picture is stopped only if other levels are
/// needed (sameLevels), so that pictures keep coming while a user drags or a scene moves. All functions must
/// be called from one thread; the first request starts the other.
class DrawWorker {
public:
    using When = texplorer::When; ///< AtOnce: whole pictures only

    /// `wake` is called on the working thread whenever `frame` has a new result; it must not throw. `levels`
    /// are the options for textures that are compressed at run time; its `stop` ends drawing AtOnce.
    explicit DrawWorker(When when, std::function<void()> wake = {}, LevelWork levels = {});
    DrawWorker(const DrawWorker&) = delete;
    DrawWorker& operator=(const DrawWorker&) = delete;
    /// Stops the current drawing and waits for it.
    ~DrawWorker();

    struct Frame {
        /// Bottom row first; nullptr: none yet. A coarse picture is smaller than requested. Until there is a
        /// picture of this request, that of an earlier one.
        std::shared_ptr<const Image> image;
        std::vector<Sentence> problems; ///< as in texplorer::Frame, or why it cannot be drawn
        double milliseconds = 0;        ///< the duration of drawing
        bool whole = false;             ///< it equals drawReference of this request
    };
    /// Requests a picture and returns the newest one.
    [[nodiscard]] const Frame& frame(const DrawRequest& request);

    /// Stops drawing, and frees the picture and the textures. For a hidden view.
    void rest();

    /// Whether a picture is pending.
    [[nodiscard]] bool isDrawing() const;

    /// Blocks until nothing is pending.
    void wait() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Returns the factor per axis by which the first picture is smaller: chosen so that it appears without
/// noticeable delay; 1 if the whole picture does.
[[nodiscard]] int coarseness(double expectedMilliseconds);

} // namespace texplorer::reference
