#include "texplorer/scene/storage/unsaved_folder.h"

#include "texplorer/files/file_io.h"
#include "texplorer/files/file_kind.h"
#include "texplorer/files/file_lock.h"
#include "texplorer/files/private_directory.h"
#include "texplorer/files/user_folder.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace texplorer {
namespace {

namespace fs = std::filesystem;

constexpr const char* draftExtension = ".scene";
constexpr const char* lockExtension = ".lock";
constexpr std::size_t maxOrphans = 32;

fs::path lockOf(fs::path draft) {
    return draft.replace_extension(lockExtension);
}

bool isThere(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(fs::symlink_status(path, ignored));
}

/// Whether an open file still is the one with this name: another process may have swept it away before it
/// was locked.
bool isStillThere(int file, const fs::path& path) {
    struct stat opened = {};
    struct stat named = {};
    return ::fstat(file, &opened) == 0 && ::lstat(path.c_str(), &named) == 0 &&
           opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

} // namespace

fs::path unsavedFolderOfUser() {
    const fs::path state = userFolder("XDG_STATE_HOME", ".local/state");
    return state.empty() ? state : state / "texplorer" / "unsaved";
}

UnsavedPlace& UnsavedPlace::operator=(UnsavedPlace&& other) noexcept {
    if (this != &other) {
        release();
        draft_ = std::move(other.draft_);
        lock_ = std::move(other.lock_);
    }
    return *this;
}

Result<UnsavedPlace> UnsavedPlace::lock(const fs::path& draft, Make make) {
    const fs::path path = lockOf(draft);
    const int exclusive = make == Make::New ? O_EXCL : 0;
    Descriptor file(::open(path.c_str(), O_RDWR | O_CREAT | exclusive | O_CLOEXEC | O_NOFOLLOW, 0600));
    const auto refuse = [&](int error) {
        const bool isTaken = error == EWOULDBLOCK || error == ENOENT;
        return fail(isTaken ? ErrorCode::NotFound : ErrorCode::Unwritable,
                    Sentence("can't be locked: {0}", systemText(error)), inFile(path.string()));
    };
    if (!file.valid())
        return refuse(errno);
    if (const int error = lockFile(file.get()); error != 0) {
        if (make == Make::New && error != EWOULDBLOCK) // no locks in this file system: it would stay
            ::unlink(path.c_str());
        return refuse(error);
    }
    if (!isStillThere(file.get(), path))
        return refuse(ENOENT);
    UnsavedPlace place;
    place.draft_ = draft;
    place.lock_ = std::move(file);
    return place;
}

Result<UnsavedPlace> UnsavedPlace::create(const fs::path& folder) {
    if (folder.empty())
        return fail(ErrorCode::NotFound, "neither XDG_STATE_HOME nor HOME gives a folder for unsaved work");
    if (const Result<PrivateDirectory> made = PrivateDirectory::make(folder); !made)
        return fail(made.error());
    // A process that had this number before may have left a draft.
    constexpr int attempts = 100;
    for (int attempt = 0;; ++attempt) {
        const fs::path draft = folder / fmt::format("{}-{}{}", ::getpid(), attempt, draftExtension);
        if (isThere(draft))
            continue;
        // Another process may sweep the lock away before it is held.
        Result<UnsavedPlace> place = lock(draft, Make::New);
        if (place || attempt >= attempts)
            return place;
    }
}

Result<void> UnsavedPlace::write(const UnsavedScene& draft) const {
    const std::string text = writeUnsaved(draft);
    return writeFileAtomically(draft_, viewBytes(text));
}

Result<UnsavedScene> UnsavedPlace::read() const {
    const Result<std::string> text = readText(draft_, maxUnsavedBytes);
    if (!text)
        return fail(text.error());
    Result<UnsavedScene> draft = parseUnsaved(*text);
    if (!draft)
        return fail(within(inFile(draft_.string()), draft.error()));
    return draft;
}

void UnsavedPlace::remove() const {
    if (isOpen())
        ::unlink(draft_.c_str());
}

void UnsavedPlace::release() {
    if (!isOpen())
        return;
    if (!isThere(draft_)) // before the lock is let go: then it may be another's
        ::unlink(lockOf(draft_).c_str());
    lock_ = {};
}

std::vector<Orphan> claimOrphans(const fs::path& folder) {
    struct Found {
        fs::path draft;
        fs::file_time_type written;
    };
    if (!PrivateDirectory::open(folder))
        return {}; // not there, or others may have put something into it
    std::vector<Found> found;
    std::vector<fs::path> locks;
    std::error_code failed;
    for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
        std::error_code gone;
        if (!fs::is_regular_file(at->symlink_status(gone)))
            continue;
        if (at->path().extension() == draftExtension)
            found.push_back({at->path(), at->last_write_time(gone)});
        else if (at->path().extension() == lockExtension)
            locks.push_back(at->path());
    }
    for (fs::path& lock : locks) { // a place that is taken and let go without a draft goes away
        const fs::path draft = lock.replace_extension(draftExtension);
        if (!isThere(draft))
            (void)UnsavedPlace::lock(draft, UnsavedPlace::Make::Any);
    }
    std::ranges::sort(found, std::greater{}, &Found::written);
    std::vector<Orphan> orphans;
    for (const Found& each : found) {
        if (orphans.size() == maxOrphans)
            break;
        Result<UnsavedPlace> place = UnsavedPlace::lock(each.draft, UnsavedPlace::Make::Any);
        const bool isTaken = !place && place.error().code == ErrorCode::NotFound;
        if (!isTaken && isThere(each.draft)) // its window may have removed it meanwhile
            orphans.push_back({std::move(place), each.written});
    }
    return orphans;
}

} // namespace texplorer
