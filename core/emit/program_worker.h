#pragma once

#include "core/base/worker.h"
#include "core/emit/program.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace texplorer::emit {

/// Makes the programs of a scene that is being edited, for a window that must not wait: at once where the
/// texels that it needs are there already or few, which is so while one drags a number; else a thread of its
/// own makes those of the newest scene first. All functions are to be called from one thread.
class ProgramWorker {
public:
    /// `wake` is called on the thread that works when texels are there. `levels`: how textures are compressed
    /// at run time.
    explicit ProgramWorker(When when, std::function<void()> wake = {}, LevelWork levels = {});
    ProgramWorker(const ProgramWorker&) = delete;
    ProgramWorker& operator=(const ProgramWorker&) = delete;
    ~ProgramWorker(); ///< ends what is being made, and waits for that

    using Program = Result<std::vector<Line>>;

    /// As emit::program makes it; nothing: not yet, ask again when `wake` was called.
    [[nodiscard]] std::optional<Program> program(Flavour flavour, const Scene& scene,
                                                 const ImageSource& images, const ProgramOptions& options);

    /// Whether texels of what was asked for last are still to come.
    [[nodiscard]] bool isMaking() const;

    /// Nobody looks any more: ends what is being made, and forgets all texels.
    void rest();

    /// Sleeps until everything is made.
    void wait() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace texplorer::emit
