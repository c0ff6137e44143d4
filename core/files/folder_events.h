#pragma once

#include <filesystem>
#include <memory>
#include <set>

namespace texplorer {

/// Waits for events in folders. Linux reports them (inotify); on other systems the caller must poll.
class FolderEvents {
public:
    FolderEvents();
    FolderEvents(const FolderEvents&) = delete;
    FolderEvents& operator=(const FolderEvents&) = delete;
    ~FolderEvents();

    /// Watches these folders from now on. Returns false if some of them cannot be watched.
    [[nodiscard]] bool watch(const std::set<std::filesystem::path>& folders);

    enum class Reason {
        Happened, ///< something happened in a folder
        Rang,     ///< `ring` was called
        Quiet,    ///< neither, until the timeout
        Failed,   ///< waiting is no longer possible
    };
    static constexpr int forever = -1;
    /// Called on a thread of its own; the other functions may be called meanwhile.
    [[nodiscard]] Reason wait(int milliseconds);
    /// Ends the current wait, or the next one.
    void ring() noexcept;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace texplorer
