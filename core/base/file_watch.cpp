#include "core/base/file_watch.h"

#include "core/base/file_fingerprint.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <map>
#include <mutex>
#include <optional>
#include <poll.h>
#include <set>
#include <stop_token>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace texplorer {

namespace {

namespace fs = std::filesystem;

constexpr int quietMilliseconds = 60;  // how long nothing more may happen before a change is reported
constexpr int pollMilliseconds = 1000; // how often one looks where the system reports nothing
constexpr int forever = -1;

/// The folders in which something happens when the file changes: a link may lead elsewhere.
std::set<fs::path> foldersOf(const fs::path& file) {
    std::error_code failed;
    std::set<fs::path> folders{fs::absolute(file, failed).parent_path()};
    const fs::path target = fs::canonical(file, failed);
    if (!failed)
        folders.insert(target.parent_path());
    return folders;
}

class Descriptor {
public:
    explicit Descriptor(int number)
        : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number_ >= 0)
            ::close(number_);
    }
    [[nodiscard]] bool valid() const { return number_ >= 0; }
    [[nodiscard]] int get() const { return number_; }

    /// Takes whatever waits, so that the next poll sleeps.
    void drain() const {
        std::array<char, 4096> rubbish{};
        while (::read(number_, rubbish.data(), rubbish.size()) > 0) {
        }
    }

private:
    int number_;
};

} // namespace

struct FileWatch::State {
    explicit State(std::function<void()> onChange)
        : wake(std::move(onChange)) {}

    std::function<void()> wake;
    Descriptor inotify{::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)};
    Descriptor bell{::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)}; // ends a sleep: the list is another, or stop

    std::mutex mutex; // guards what follows
    std::map<fs::path, std::optional<FileFingerprint>> files;
    std::map<fs::path, int> folders; // to inotify's numbers
    std::set<fs::path> reported;
    bool polls = false; // something is watched of which the system tells nothing

    std::jthread thread; // last: it ends before the rest does

    void ring() const {
        if (bell.valid())
            (void)::eventfd_write(bell.get(), 1);
    }
    void run(const std::stop_token& stop);
    void watchFolders(); ///< with the mutex held
    bool compare();
};

void FileWatch::State::watchFolders() {
    constexpr std::uint32_t events =
        IN_CLOSE_WRITE | IN_MODIFY | IN_MOVED_TO | IN_CREATE | IN_ATTRIB | IN_ONLYDIR;
    std::set<fs::path> wanted;
    for (const auto& [file, known] : files)
        wanted.merge(foldersOf(file));
    std::erase_if(folders, [&](const auto& entry) {
        if (wanted.contains(entry.first))
            return false;
        if (entry.second >= 0)
            (void)::inotify_rm_watch(inotify.get(), entry.second);
        return true;
    });
    // Once more for those that are known, too: two spellings of one folder share a number, and the other one
    // may just have gone.
    for (const fs::path& folder : wanted)
        folders[folder] = inotify.valid() ? ::inotify_add_watch(inotify.get(), folder.c_str(), events) : -1;
    polls = std::ranges::any_of(folders, [](const auto& entry) { return entry.second < 0; });
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
    const std::stop_callback ringAtStop(stop, [this] { ring(); });
    bool unsettled = false;
    while (!stop.stop_requested()) {
        int timeout = forever;
        {
            const std::scoped_lock lock(mutex);
            timeout = unsettled ? quietMilliseconds : polls ? pollMilliseconds : forever;
        }
        std::array<pollfd, 2> sources{pollfd{bell.get(), POLLIN, 0}, pollfd{inotify.get(), POLLIN, 0}};
        const int ready = ::poll(sources.data(), sources.size(), timeout);
        if (ready < 0 && errno != EINTR)
            return;
        bell.drain();
        if ((sources[1].revents & POLLIN) != 0) {
            inotify.drain(); // which file it was, the fingerprints say
            unsettled = true;
            continue;
        }
        if (ready == 0) {
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
        state_->ring(); // how long it sleeps may be another
        return;
    }
    try {
        state_->thread =
            std::jthread([state = state_.get()](const std::stop_token& stop) { state->run(stop); });
    } catch (const std::system_error&) {
        // No thread to be had: nothing is noticed, everything else works.
    }
}

std::vector<fs::path> FileWatch::changed() {
    const std::scoped_lock lock(state_->mutex);
    std::vector<fs::path> files(state_->reported.begin(), state_->reported.end());
    state_->reported.clear();
    return files;
}

} // namespace texplorer
