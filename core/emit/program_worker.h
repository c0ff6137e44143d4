#pragma once

#include "texplorer/base/worker.h"
#include "texplorer/emit/program.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace texplorer::emit {

/// Makes the programs of a scene that is being edited, for a window that must not wait: at once where that is
/// quick, which is so while one drags a number of a usual scene; else on threads of its own, first the texels
/// that aren't there, then, with key frames or large meshes, the program. The newest scene wins. All
/// functions are to be called from one thread.
class ProgramWorker {
public:
    /// `wake` is called on the thread that works when texels or a program are there. `levels`: how textures
    /// are compressed at run time.
    explicit ProgramWorker(When when, std::function<void()> wake = {}, LevelWork levels = {});
    ProgramWorker(const ProgramWorker&) = delete;
    ProgramWorker& operator=(const ProgramWorker&) = delete;
    ~ProgramWorker(); ///< ends what is being made, and waits for that

    using Program = Result<std::vector<Line>>;

    /// As emit::program makes it; nothing: not yet, ask again when `wake` was called.
    [[nodiscard]] std::optional<Program> program(Flavour flavour, const Scene& scene,
                                                 const ImageSource& images, const ProgramOptions& options);

    /// Whether texels or the program of what was asked for last are still to come.
    [[nodiscard]] bool isMaking() const;

    /// Nobody looks any more: ends what is being made, and forgets it.
    void rest();

    /// Sleeps until everything is made.
    void wait() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace texplorer::emit
