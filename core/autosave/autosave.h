#pragma once

#include "core/autosave/unsaved_folder.h"
#include "core/base/clock.h"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

namespace texplorer {

/// Keeps unsaved work on the disk, on a thread of its own: no call waits for it but `flush`, or where there
/// is no thread to be had `keep` and `forget` of what is due. An edit is written at most `delay` after it was
/// told, and the edits in between with it; what can't be written is tried again. Nobody is woken where
/// nothing waits. All functions may be called by any thread.
class Autosave {
public:
    /// With the time that the disk takes, an edit is safe two seconds after it was made.
    static constexpr std::chrono::milliseconds usualDelay{1000};

    /// The draft lies in `folder`, which is made with the first draft. `wake` is called on the thread that
    /// writes when there is a problem to take. `clock` is what the delay is measured on.
    explicit Autosave(std::filesystem::path folder, std::function<void()> wake = {},
                      std::chrono::milliseconds delay = usualDelay, Clock clock = steadySeconds);
    Autosave(const Autosave&) = delete;
    Autosave& operator=(const Autosave&) = delete;
    /// Writes nothing more; what was written stays, for the next start.
    ~Autosave();

    /// This is the work that would be lost. Costs a comparison where it is what was told last.
    void keep(const std::filesystem::path& file, const std::filesystem::path& folder, const Scene& scene,
              const std::string& fileHash = {});
    /// A draft that is `told` already goes on as this one's own.
    void adopt(UnsavedPlace place, UnsavedScene told);
    /// Nothing would be lost any more: the draft goes, at once.
    void forget();
    /// Writes what waits, now. False: it can't be written.
    bool flush();

    /// When `keep` or `forget` has to be called again, because no thread writes what is due. Nothing: it need
    /// not.
    [[nodiscard]] std::optional<double> due() const;

    /// Why the work can't be kept: once, until a draft has been written again.
    [[nodiscard]] std::optional<Error> takeProblem();

    [[nodiscard]] const std::filesystem::path& folder() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace texplorer
