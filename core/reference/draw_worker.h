#pragma once

#include "core/base/worker.h"
#include "core/reference/draw.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace texplorer::reference {

/// Draws for a window that must not wait: on a thread of its own, first coarsely where the whole picture
/// takes long, then the whole. A new request ends the drawing of the last one; a coarse picture is ended only
/// where other levels are needed (sameLevels), so that there is something to see while a user drags or a
/// scene moves. All functions are to be called from one thread; the first request starts the other one.
class DrawWorker {
public:
    using When = texplorer::When; ///< AtOnce: the whole picture

    /// `wake` is called on the working thread whenever `frame` has something new to give; it must not
    /// throw. Textures that are compressed at run time are made as `levels` says; its `stop` ends a drawing
    /// AtOnce.
    explicit DrawWorker(When when, std::function<void()> wake = {}, LevelWork levels = {});
    DrawWorker(const DrawWorker&) = delete;
    DrawWorker& operator=(const DrawWorker&) = delete;
    /// Ends what is being drawn, and waits for that.
    ~DrawWorker();

    struct Frame {
        /// Bottom row first; nullptr: none yet. Smaller than was asked for where it is coarse. Of an earlier
        /// request until there is one of this.
        std::shared_ptr<const Image> image;
        std::vector<std::string> problems; ///< as of texplorer::Frame, or why it can't be drawn
        double milliseconds = 0;           ///< how long it took
        bool whole = false;                ///< it is what drawReference makes of this request
    };
    /// The newest picture of what is wanted now.
    [[nodiscard]] const Frame& frame(const DrawRequest& request);

    /// Nobody looks any more: ends what is being drawn, and forgets the picture and the textures.
    void rest();

    /// Whether a picture is still to come.
    [[nodiscard]] bool isDrawing() const;

    /// Sleeps until none is, and what is to be forgotten is.
    void wait() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// How many times smaller, on each axis, the first picture is: as fine as is expected to be there before the
/// user notices, 1 where the whole one is.
[[nodiscard]] int coarseness(double expectedMilliseconds);

} // namespace texplorer::reference
