#pragma once

#include "texplorer/reference/contributions.h"
#include "texplorer/reference/draw_worker.h"
#include "texplorer/reference/explain/explanation.h"

#include <functional>
#include <memory>
#include <optional>

namespace texplorer::reference {

/// What a window asks about a picture.
struct ProbeRequest {
    DrawRequest picture;
    std::optional<PixelPlace> pixel{};    ///< to explain
    std::optional<TexelQuestion> texel{}; ///< to find its contributions

    bool operator==(const ProbeRequest&) const = default;
};

/// Explains pixels for a window without blocking it, on a thread of its own: the first question about a scene
/// makes its textures' levels. A new request stops the work on the last one if it needs other levels
/// (sameLevels), another texel, or no texel any more, as finding contributions can take long. All functions
/// must be called from one thread; the first request starts the other.
class ProbeWorker {
public:
    using When = texplorer::When;

    /// `wake` is called on the working thread whenever there is a new answer; it must not throw. `stop` of
    /// `levels` ends the work AtOnce.
    explicit ProbeWorker(When when, std::function<void()> wake = {}, LevelWork levels = {});
    ProbeWorker(const ProbeWorker&) = delete;
    ProbeWorker& operator=(const ProbeWorker&) = delete;
    ~ProbeWorker(); ///< stops the current work and waits for it

    struct Answer {
        ProbeRequest request; ///< the request of this answer
        std::optional<Result<Explanation>> explanation{};
        std::optional<Result<Contributions>> contributions{};
    };
    /// Requests an answer and returns the newest one, which may be that of an earlier request; nullptr: none
    /// yet.
    [[nodiscard]] std::shared_ptr<const Answer> answer(const ProbeRequest& request);

    /// Stops the work, and frees the answer and the textures. For a hidden view.
    void rest();

    /// Blocks until the last request is answered or cancelled.
    void wait() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace texplorer::reference
