#pragma once

#include "core/base/worker.h"
#include "core/reference/false_colors.h"
#include "core/reference/level_map.h"

#include <functional>
#include <memory>

namespace texplorer::reference {

struct LevelMapRequest {
    DrawRequest picture;
    LevelQuestion unit;
    Shown shown = Shown::Picture; ///< the false colours that are wanted; Picture: none

    bool operator==(const LevelMapRequest&) const = default;
};

/// Maps levels for a window that must not wait, on a thread of its own. A new request ends the work on the
/// last one only where it needs other levels (sameLevels): while a scene moves there is always something to
/// see. All functions are to be called from one thread; the first request starts the other one.
class LevelMapWorker {
public:
    using When = texplorer::When;

    /// `wake` is called on the working thread whenever there is a new answer; it must not throw. `stop` of
    /// `levels` ends the work AtOnce.
    explicit LevelMapWorker(When when, std::function<void()> wake = {}, LevelWork levels = {});
    LevelMapWorker(const LevelMapWorker&) = delete;
    LevelMapWorker& operator=(const LevelMapWorker&) = delete;
    ~LevelMapWorker(); ///< ends what is being worked on, and waits for that

    struct Answer {
        LevelMapRequest request; ///< what it answers
        Result<LevelMap> map;
        std::shared_ptr<const Image> colors{}; ///< falseColors, where they are wanted and there is a map
    };
    /// The newest answer: to this request, or to an earlier one until there is one; nullptr: none yet.
    [[nodiscard]] std::shared_ptr<const Answer> answer(const LevelMapRequest& request);

    /// Nobody asks any more: ends what is being worked on, and forgets the answer and the textures.
    void rest();

    /// Sleeps until what was asked last is answered, or forgotten.
    void wait() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace texplorer::reference
