#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

namespace texplorer {

/// Notices that files have changed: were written to, replaced by another file (as editors save), or have come
/// back. A file that vanishes has not changed until it is there again. Sleeps in a thread of its own until
/// the system reports something (inotify on Linux); where that can't be had it looks once a second.
///
/// A series of writes is reported once, when it has been quiet for a moment. Somebody who writes slowly is
/// reported more than once: the content may be half of a file.
class FileWatch {
public:
    /// `wake` is called on the watching thread whenever `changed` has something to say.
    explicit FileWatch(std::function<void()> wake = {});
    FileWatch(const FileWatch&) = delete;
    FileWatch& operator=(const FileWatch&) = delete;
    ~FileWatch();

    /// Watches exactly these files from now on. A file that was watched already stays as it was: what has
    /// happened to it is not forgotten. Cheap where nothing changed.
    void watch(std::vector<std::filesystem::path> files);

    /// The files that have changed since the last call, spelled as they were given.
    [[nodiscard]] std::vector<std::filesystem::path> changed();

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace texplorer
