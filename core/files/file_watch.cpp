#include "texplorer/files/file_watch.h"

#include "texplorer/files/file_fingerprint.h"
#include "texplorer/files/folder_events.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <stop_token>
#include <system_error>
#include <thread>

namespace texplorer {

namespace {

namespace fs = std::filesystem;

constexpr int quietMilliseconds = 60;  // how long nothing more may happen before a change is reported
constexpr int pollMilliseconds = 1000; // how often one looks where the system reports nothing

/// The folders in which something happens when the file changes: a link may lead elsewhere.
std::set<fs::path> foldersOf(const fs::path& file) {
    std::error_code failed;
    std::set<fs::path> folders{fs::absolute(file, failed).parent_path()};
    const fs::path target = fs::canonical(file, failed);
    if (!failed)
        folders.insert(target.parent_path());
    return folders;
}

} // namespace

struct FileWatch::State {
    explicit State(std::function<void()> onChange)
        : wake(std::move(onChange)) {}

    std::function<void()> wake;
    FolderEvents events;

    std::mutex mutex; // guards what follows
    std::map<fs::path, std::optional<FileFingerprint>> files;
    std::set<fs::path> reported;
    bool polls = false; // something is watched of which the system tells nothing

    std::jthread thread; // last: it ends before the rest does

    void run(const std::stop_token& stop);
    void watchFolders(); ///< with the mutex held
    bool compare();
};

void FileWatch::State::watchFolders() {
    std::set<fs::path> folders;
    for (const auto& [file, known] : files)
        folders.merge(foldersOf(file));
    polls = !events.watch(folders);
}

bool FileWatch::State::compare() {
    const std::scoped_lock lock(mutex);
    bool any = false;
    for (auto& [file, known] : files) {
        const std::optional<FileFingerprint> now = fingerprintOf(file);
        if (!now || (known && *now == *known))
            continue;
        known = now;
        reported.insert(file);
        any = true;
    }
    return any;
}

void FileWatch::State::run(const std::stop_token& stop) {
    const std::stop_callback ringAtStop(stop, [this] { events.ring(); });
    bool unsettled = false;
    while (!stop.stop_requested()) {
        int timeout = FolderEvents::forever;
        {
            const std::scoped_lock lock(mutex);
            timeout = unsettled ? quietMilliseconds : polls ? pollMilliseconds : FolderEvents::forever;
        }
        switch (events.wait(timeout)) {
        case FolderEvents::Reason::Failed:
            return;
        case FolderEvents::Reason::Rang:
            break;
        case FolderEvents::Reason::Happened:
            unsettled = true;
            break;
        case FolderEvents::Reason::Quiet:
            unsettled = false;
            if (compare() && wake)
                wake();
        }
    }
}

FileWatch::FileWatch(std::function<void()> wake)
    : state_(std::make_unique<State>(std::move(wake))) {}

FileWatch::~FileWatch() = default;

void FileWatch::watch(std::vector<fs::path> files) {
    const std::scoped_lock lock(state_->mutex);
    std::ranges::sort(files);
    const auto last = std::unique(files.begin(), files.end());
    files.erase(last, files.end());
    if (std::ranges::equal(files, state_->files, {}, {}, [](const auto& entry) { return entry.first; }))
        return;
    std::map<fs::path, std::optional<FileFingerprint>> next;
    for (fs::path& file : files) {
        const auto known = state_->files.find(file);
        const auto fingerprint = known == state_->files.end() ? fingerprintOf(file) : known->second;
        next.emplace(std::move(file), fingerprint);
    }
    state_->files = std::move(next);
    std::erase_if(state_->reported, [&](const fs::path& file) { return !state_->files.contains(file); });
    state_->watchFolders();
    if (state_->thread.joinable()) {
        state_->events.ring(); // how long it sleeps may be another
        return;
    }
    try {
        state_->thread =
            std::jthread([state = state_.get()](const std::stop_token& stop) { state->run(stop); });
    } catch (const std::system_error&) {
        // No thread available: changes are not noticed, everything else works.
    }
}

std::vector<fs::path> FileWatch::changed() {
    const std::scoped_lock lock(state_->mutex);
    std::vector<fs::path> files(state_->reported.begin(), state_->reported.end());
    state_->reported.clear();
    return files;
}

} // namespace texplorer
