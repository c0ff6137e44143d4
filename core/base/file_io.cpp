#include "core/base/file_io.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <optional>
#include <sys/stat.h>
#include <unistd.h>

namespace texplorer {

namespace {

namespace fs = std::filesystem;

std::string systemText(int error) {
    return std::strerror(error); // NOLINT: glibc's is safe for known numbers
}

/// A file descriptor that is closed at the end, whatever the end is.
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

    /// Closes now and says whether that worked: a network file system may report a failed write only here.
    [[nodiscard]] bool close() { return ::close(std::exchange(number_, -1)) == 0; }

private:
    int number_;
};

const char* kindName(mode_t mode) {
    if (S_ISDIR(mode))
        return "a directory";
    if (S_ISFIFO(mode))
        return "a pipe";
    if (S_ISSOCK(mode))
        return "a socket";
    return "a device";
}

ErrorCode codeForOpening(int error) {
    return error == ENOENT || error == ENOTDIR ? ErrorCode::NotFound : ErrorCode::Unreadable;
}

tl::unexpected<Error> tooLarge(std::size_t size, std::size_t maxBytes, const std::string& where) {
    return fail(ErrorCode::TooLarge,
                "at most " + std::to_string(maxBytes) + " bytes are read, the file has at least " +
                    std::to_string(size),
                where);
}

// Fills the buffer as far as the file goes; gives the number of bytes, or nothing after an error.
std::optional<std::size_t> readFully(int file, std::byte* to, std::size_t count) {
    std::size_t done = 0;
    while (done < count) {
        const ssize_t got = ::read(file, to + done, count - done);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            return std::nullopt;
        if (got == 0)
            break;
        done += static_cast<std::size_t>(got);
    }
    return done;
}

int openForReading(const fs::path& path) {
    // O_NONBLOCK: opening a pipe without a writer must not wait for one.
    return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
}

/// The size that the file system states. A file that is none is refused.
Result<std::size_t> sizeOf(int file, const std::string& where) {
    struct stat info = {};
    if (::fstat(file, &info) != 0)
        return fail(ErrorCode::Unreadable, "can't be examined: " + systemText(errno), where);
    if (!S_ISREG(info.st_mode))
        return fail(ErrorCode::Unreadable, std::string("is ") + kindName(info.st_mode) + ", not a file",
                    where);
    return static_cast<std::size_t>(info.st_size);
}

// readFully in parts, between which somebody is asked whether to go on. `stopped` says that it was not.
std::optional<std::size_t> readObserved(int file, std::byte* to, std::size_t count,
                                        const ReadObserver& observer, bool& stopped) {
    constexpr std::size_t part = std::size_t{4} << 20;
    std::size_t done = 0;
    for (;;) {
        stopped = !observer(done, count);
        if (stopped || done == count)
            return done;
        const std::size_t wanted = std::min(part, count - done);
        const auto got = readFully(file, to + done, wanted);
        if (!got)
            return std::nullopt;
        done += *got;
        if (*got < wanted)
            return done;
    }
}

// `Buffer` is Bytes or std::string. The file's stated size is one read; whatever it has beyond that (it grew,
// or it is one of /proc, whose files say 0) follows in blocks.
template<class Buffer>
Result<Buffer> readInto(const fs::path& path, std::size_t maxBytes, const ReadObserver& observer = {}) {
    const std::string where = path.string();
    const Descriptor file(openForReading(path));
    if (!file.valid())
        return fail(codeForOpening(errno), "can't be opened: " + systemText(errno), where);
    const Result<std::size_t> stated = sizeOf(file.get(), where);
    if (!stated)
        return fail(stated.error());
    const std::size_t size = *stated;
    if (size > maxBytes)
        return tooLarge(size, maxBytes, where);

    Buffer buffer;
    bool stopped = false;
    std::size_t filled = 0;
    constexpr std::size_t block = 4096;
    std::byte beyond[block];
    try {
        buffer.resize(size);
        for (;;) {
            auto* to = reinterpret_cast<std::byte*>(buffer.data());
            const bool first = filled == 0;
            const auto got = observer && first
                                 ? readObserved(file.get(), to, buffer.size(), observer, stopped)
                                 : readFully(file.get(), to + filled, buffer.size() - filled);
            if (stopped)
                return fail(ErrorCode::Cancelled, "reading was cancelled", where);
            const auto more = got ? readFully(file.get(), beyond, block) : std::nullopt;
            if (!more)
                return fail(ErrorCode::Unreadable, "can't be read: " + systemText(errno), where);
            filled += *got;
            buffer.resize(filled);
            if (*more == 0)
                return buffer;
            if (filled + *more > maxBytes)
                return tooLarge(filled + *more, maxBytes, where);
            buffer.resize(filled + *more);
            std::memcpy(buffer.data() + filled, beyond, *more);
            filled += *more;
        }
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge, "there is no memory for its " + std::to_string(size) + " bytes",
                    where);
    }
}

tl::unexpected<Error> unwritable(const std::string& what, int error, const fs::path& path) {
    return fail(ErrorCode::Unwritable, what + ": " + systemText(error), path.string());
}

// Where a chain of symbolic links ends, be there a file or not.
Result<fs::path> followLinks(fs::path path) {
    const fs::path asked = path;
    std::error_code error;
    for (int steps = 0; steps < 40; ++steps) {
        if (!fs::is_symlink(fs::symlink_status(path, error)))
            return path;
        const fs::path next = fs::read_symlink(path, error);
        if (error)
            return unwritable("the link can't be read", error.value(), asked);
        path = next.is_absolute() ? next : path.parent_path() / next;
    }
    return unwritable("can't be written", ELOOP, asked);
}

/// A new file beside the target; it goes away unless it takes the target's place.
class Draft {
public:
    explicit Draft(const fs::path& target) {
        // The name says nothing of the target's, which may already be as long as the system allows.
        for (int attempt = 0; attempt < 100; ++attempt) {
            name_ = target.parent_path() /
                    (".texplorer-" + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".tmp");
            number_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            if (number_ >= 0 || errno != EEXIST)
                return;
        }
    }
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;
    ~Draft() {
        if (number_ >= 0 && !renamed_)
            ::unlink(name_.c_str());
    }
    [[nodiscard]] int descriptor() const { return number_; }
    [[nodiscard]] bool rename(const fs::path& target) {
        return renamed_ = std::rename(name_.c_str(), target.c_str()) == 0;
    }

private:
    fs::path name_;
    int number_ = -1;
    bool renamed_ = false;
};

bool writeFully(int file, ByteView bytes) {
    while (!bytes.empty()) {
        const ssize_t put = ::write(file, bytes.data(), bytes.size());
        if (put < 0 && errno == EINTR)
            continue;
        if (put < 0)
            return false;
        bytes = bytes.subspan(static_cast<std::size_t>(put));
    }
    return true;
}

} // namespace

Result<Bytes> readFile(const fs::path& path, std::size_t maxBytes, const ReadObserver& observer) {
    return readInto<Bytes>(path, maxBytes, observer);
}

Result<Bytes> readFileStart(const fs::path& path, std::size_t count) {
    const Descriptor file(openForReading(path));
    if (!file.valid())
        return fail(codeForOpening(errno), "can't be opened: " + systemText(errno), path.string());
    if (const Result<std::size_t> size = sizeOf(file.get(), path.string()); !size)
        return fail(size.error());
    Bytes start;
    start.resize(count);
    const auto got = readFully(file.get(), start.data(), count);
    if (!got)
        return fail(ErrorCode::Unreadable, "can't be read: " + systemText(errno), path.string());
    start.resize(*got);
    return start;
}

Result<std::string> readText(const fs::path& path, std::size_t maxBytes) {
    return readInto<std::string>(path, maxBytes);
}

Result<void> writeFileAtomically(const fs::path& path, ByteView bytes) {
    // Before its links are followed by name: /dev/stdout leads to "pipe:[4711]", which is nobody's file.
    struct stat info = {};
    const bool exists = ::stat(path.c_str(), &info) == 0;
    if (exists && !S_ISREG(info.st_mode))
        return fail(ErrorCode::Unwritable, std::string("is ") + kindName(info.st_mode) + ", not a file",
                    path.string());
    const Result<fs::path> target = followLinks(path);
    if (!target)
        return fail(target.error());
    // Replacing needs no permission on the file itself, but a read-only file is meant to stay as it is.
    if (exists && ::faccessat(AT_FDCWD, target->c_str(), W_OK, AT_EACCESS) != 0)
        return unwritable("can't be written", errno, path);

    Draft draft(*target);
    if (draft.descriptor() < 0)
        return unwritable("can't be written", errno, path);
    Descriptor file(draft.descriptor());
    if (exists) {
        // Only root may give files away; whoever can't must not pass on a set-user-ID bit.
        const bool sameOwner = ::fchown(file.get(), info.st_uid, info.st_gid) == 0;
        if (::fchmod(file.get(), info.st_mode & (sameOwner ? 07777 : 0777)) != 0)
            return unwritable("its permissions can't be kept", errno, path);
    }
    if (!writeFully(file.get(), bytes) || ::fsync(file.get()) != 0 || !file.close() || !draft.rename(*target))
        return unwritable("can't be written", errno, path);
    return {};
}

} // namespace texplorer
