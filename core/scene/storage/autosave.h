#pragma once

#include "texplorer/base/clock.h"
#include "texplorer/scene/storage/unsaved_folder.h"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

namespace texplorer {

/// Stores unsaved work on disk, on a thread of its own. Calls do not block, except `flush`; without a thread,
/// `keep` and `forget` write what is due. An edit is written at most `delay` after `keep` received it,
/// together with the edits in between. Failed writes are tried again. The thread sleeps while there is
/// nothing to write. Thread-safe.
class Autosave {
public:
    /// Including the time of the disk, an edit is stored within two seconds.
    static constexpr std::chrono::milliseconds usualDelay{1000};

    /// Drafts are stored in `folder`, which is created with the first draft. `wake` is called on the writing
    /// thread when takeProblem has a new problem. `clock` measures the delay.
    explicit Autosave(std::filesystem::path folder, std::function<void()> wake = {},
                      std::chrono::milliseconds delay = usualDelay, Clock clock = steadySeconds);
    Autosave(const Autosave&) = delete;
    Autosave& operator=(const Autosave&) = delete;
    /// Stops writing. Drafts that were written stay for the next start.
    ~Autosave();

    /// Sets the work to store. Cheap if it equals that of the last call.
    void keep(const std::filesystem::path& file, const std::filesystem::path& folder, const Scene& scene,
              const std::string& fileHash = {});
    /// Continues an existing draft, whose content is `told`.
    void adopt(UnsavedPlace place, UnsavedScene told);
    /// Removes the draft at once: there is no unsaved work any more.
    void forget();
    /// Writes pending work now. Fails if it cannot be written.
    Result<void> flush();

    /// Returns when `keep` or `forget` must be called again, because no thread writes. Empty: not needed.
    [[nodiscard]] std::optional<double> due() const;

    /// Returns why the work cannot be stored. Returned once, until a draft has been written again.
    [[nodiscard]] std::optional<Error> takeProblem();

    [[nodiscard]] const std::filesystem::path& folder() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace texplorer
