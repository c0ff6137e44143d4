#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

namespace texplorer {

/// Reports changes of files: written, replaced by another file (as editors save), or created again. A deleted
/// file counts as changed only when it exists again. The watching thread sleeps until the system reports an
/// event (inotify on Linux); where there is no inotify, it checks once a second.
///
/// Several writes in a row are reported once, after a short pause. A slow writer is reported more than once,
/// so the content may be incomplete.
class FileWatch {
public:
    /// `wake` is called on the watching thread whenever `changed` has something new.
    explicit FileWatch(std::function<void()> wake = {});
    FileWatch(const FileWatch&) = delete;
    FileWatch& operator=(const FileWatch&) = delete;
    ~FileWatch();

    /// Watches exactly these files from now on. Files that were watched before keep their pending changes.
    /// Cheap if the list is unchanged.
    void watch(std::vector<std::filesystem::path> files);

    /// Returns the files that have changed since the last call, spelled as given to `watch`.
    [[nodiscard]] std::vector<std::filesystem::path> changed();

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace texplorer
