#include "texplorer/files/draft.h"

#include "texplorer/files/directory_listing.h"
#include "texplorer/files/file_io.h"
#include "texplorer/files/file_lock.h"
#include "texplorer/files/file_owner.h"
#include "texplorer/files/nameless_file.h"

#include <fmt/core.h>

#include <cerrno>
#include <fcntl.h>
#include <string_view>

namespace texplorer {

namespace {

constexpr std::string_view prefix = ".texplorer-";
constexpr std::string_view suffix = ".tmp";
constexpr int attempts = 10000;

/// ".texplorer-4711-0.tmp". It says nothing of the target's name, which may already be as long as the system
/// allows.
std::string temporaryName(int attempt) {
    return fmt::format("{}{}-{}{}", prefix, ::getpid(), attempt, suffix);
}

bool isTemporaryName(std::string_view name) {
    if (!name.starts_with(prefix) || !name.ends_with(suffix) || name.size() < prefix.size() + suffix.size())
        return false;
    name = name.substr(prefix.size(), name.size() - prefix.size() - suffix.size());
    const std::size_t dash = name.find('-');
    constexpr std::string_view digits = "0123456789";
    return dash != std::string_view::npos && dash > 0 && dash + 1 < name.size() &&
           name.find_first_not_of(digits) == dash &&
           name.find_first_not_of(digits, dash + 1) == std::string_view::npos;
}

/// Whether the name still is this very file.
bool isStill(int directory, const char* name, const struct stat& info) {
    struct stat now = {};
    return ::fstatat(directory, name, &now, AT_SYMLINK_NOFOLLOW) == 0 && now.st_ino == info.st_ino &&
           now.st_dev == info.st_dev;
}

void sweep(int directory, const char* name) {
    // For writing: network file systems lock nothing else.
    const Descriptor left(
        ::openat(directory, name, O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    struct stat info = {};
    if (left.valid() && ::fstat(left.get(), &info) == 0 && S_ISREG(info.st_mode) &&
        info.st_uid == thisUser() && lockFile(left.get()) == 0 && isStill(directory, name, info))
        ::unlinkat(directory, name, 0);
}

} // namespace

Draft::Draft(int directory, mode_t mode)
    : directory_(directory)
    , mode_(mode)
    , file_(openNameless(directory, mode)) {
    if (file_.valid())
        static_cast<void>(lockFile(file_.get())); // before it has a name
    else
        static_cast<void>(openNamed());
}

Draft::~Draft() {
    if (file_.valid() && !temporary_.empty())
        ::unlinkat(directory_, temporary_.c_str(), 0);
}

bool Draft::openNamed() {
    for (int attempt = 0; attempt < attempts; ++attempt) {
        temporary_ = temporaryName(attempt);
        file_ = Descriptor(::openat(directory_, temporary_.c_str(),
                                    O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode_));
        if (!file_.valid() && errno == EEXIST)
            continue;
        if (!file_.valid())
            return false;
        // Who sweeps may have come between the opening and the lock.
        struct stat info = {};
        if (lockFile(file_.get()) != 0 || (::fstat(file_.get(), &info) == 0 && info.st_nlink > 0))
            return true;
    }
    return false;
}

bool Draft::fill() {
    return (replaced_ == nullptr || takeOwnerAndMode(file_.get(), *replaced_)) &&
           writeFully(file_.get(), bytes_) && ::fsync(file_.get()) == 0;
}

bool Draft::write(ByteView bytes, const struct stat* replaced) {
    bytes_ = bytes;
    replaced_ = replaced;
    return valid() && fill();
}

bool Draft::takeTemporaryName() {
    for (int attempt = 0; attempt < attempts; ++attempt) {
        std::string name = temporaryName(attempt);
        if (nameFile(file_.get(), directory_, name)) {
            temporary_ = std::move(name);
            return true;
        }
        if (errno != EEXIST)
            break;
    }
    return openNamed() && fill(); // the content is written again
}

bool Draft::place(int directory, const std::string& name) {
    // To where nothing is it goes at once, and never has another name.
    if (temporary_.empty() && nameFile(file_.get(), directory, name))
        return true;
    if (temporary_.empty() && !takeTemporaryName())
        return false;
    if (::renameat(directory_, temporary_.c_str(), directory, name.c_str()) != 0)
        return false;
    temporary_.clear();
    return true;
}

void sweepDrafts(int directory) {
    forEachName(directory, [directory](const char* name) {
        if (isTemporaryName(name))
            sweep(directory, name);
    });
}

} // namespace texplorer
