#pragma once

#include <filesystem>
#include <memory>
#include <set>

namespace texplorer {

/// Sleeps until something happens in folders. Linux reports it (inotify); where nothing does, one has to
/// look.
class FolderEvents {
public:
    FolderEvents();
    FolderEvents(const FolderEvents&) = delete;
    FolderEvents& operator=(const FolderEvents&) = delete;
    ~FolderEvents();

    /// From now on these. False: of some of them nothing will be reported.
    [[nodiscard]] bool watch(const std::set<std::filesystem::path>& folders);

    enum class Reason {
        Happened, ///< something did in a folder
        Rang,     ///< somebody called `ring`
        Quiet,    ///< neither, all the time
        Failed,   ///< there is no sleeping any more
    };
    static constexpr int forever = -1;
    /// On a thread of its own, while others call the other functions.
    [[nodiscard]] Reason wait(int milliseconds);
    /// Ends a sleep, or the next one.
    void ring() noexcept;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace texplorer
