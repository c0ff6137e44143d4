#pragma once

#include "core/reference/contributions.h"
#include "core/reference/draw_worker.h"
#include "core/reference/explain/explanation.h"

#include <functional>
#include <memory>
#include <optional>

namespace texplorer::reference {

/// What a window wants to know of a picture.
struct ProbeRequest {
    DrawRequest picture;
    std::optional<PixelPlace> pixel{};    ///< explain it
    std::optional<TexelQuestion> texel{}; ///< find where it has a share

    bool operator==(const ProbeRequest&) const = default;
};

/// Explains pixels for a window that must not wait, on a thread of its own: the first question of a scene
/// makes its textures' levels. A new request ends the work on the last one where it needs other levels
/// (sameLevels), or asks for another texel, or no longer for one: to find its pixels can take long. All
/// functions are to be called from one thread; the first request starts the other one.
class ProbeWorker {
public:
    using When = texplorer::When;

    /// `wake` is called on the working thread whenever there is a new answer; it must not throw. `stop` of
    /// `levels` ends the work AtOnce.
    explicit ProbeWorker(When when, std::function<void()> wake = {}, LevelWork levels = {});
    ProbeWorker(const ProbeWorker&) = delete;
    ProbeWorker& operator=(const ProbeWorker&) = delete;
    ~ProbeWorker(); ///< ends what is being worked on, and waits for that

    struct Answer {
        ProbeRequest request; ///< what it answers
        std::optional<Result<Explanation>> explanation{};
        std::optional<Result<Contributions>> contributions{};
    };
    /// The newest answer: to this request, or to an earlier one until there is one; nullptr: none yet.
    [[nodiscard]] std::shared_ptr<const Answer> answer(const ProbeRequest& request);

    /// Nobody asks any more: ends what is being worked on, and forgets the answer and the textures.
    void rest();

    /// Sleeps until what was asked last is answered, or forgotten.
    void wait() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace texplorer::reference
