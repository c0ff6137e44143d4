#pragma once

#include "texplorer/base/worker.h"
#include "texplorer/reference/false_colors.h"
#include "texplorer/reference/level_map.h"

#include <functional>
#include <memory>

namespace texplorer::reference {

struct LevelMapRequest {
    DrawRequest picture;
    LevelQuestion unit;
    Shown shown = Shown::Picture; ///< the false colours to make; Picture: none

    bool operator==(const LevelMapRequest&) const = default;
};

/// Computes level maps for a window without blocking it, on a thread of its own. A new request stops the work
/// on the last one only if it needs other levels (sameLevels), so that results keep coming while a scene
/// moves. All functions must be called from one thread; the first request starts the other.
class LevelMapWorker {
public:
    using When = texplorer::When;

    /// `wake` is called on the working thread whenever there is a new answer; it must not throw. `stop` of
    /// `levels` ends the work AtOnce.
    explicit LevelMapWorker(When when, std::function<void()> wake = {}, LevelWork levels = {});
    LevelMapWorker(const LevelMapWorker&) = delete;
    LevelMapWorker& operator=(const LevelMapWorker&) = delete;
    ~LevelMapWorker(); ///< stops the current work and waits for it

    struct Answer {
        LevelMapRequest request; ///< the request of this answer
        Result<LevelMap> map;
        std::shared_ptr<const Image> colors{}; ///< falseColors, if requested and there is a map
    };
    /// Requests an answer and returns the newest one, which may be that of an earlier request; nullptr: none
    /// yet.
    [[nodiscard]] std::shared_ptr<const Answer> answer(const LevelMapRequest& request);

    /// Stops the work, and frees the answer and the textures. For a hidden view.
    void rest();

    /// Blocks until the last request is answered or cancelled.
    void wait() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace texplorer::reference
