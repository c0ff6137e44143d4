#include "texplorer/files/file_io.h"

#include "texplorer/files/file_kind.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <optional>
#include <sys/stat.h>
#include <unistd.h>

namespace texplorer {

namespace {

namespace fs = std::filesystem;

ErrorCode codeForOpening(int error) {
    return error == ENOENT || error == ENOTDIR ? ErrorCode::NotFound : ErrorCode::Unreadable;
}

tl::unexpected<Error> tooLarge(std::uint64_t size, std::size_t maxBytes, const std::string& where) {
    return fail(ErrorCode::TooLarge,
                Sentence("at most {0} bytes are read, the file has at least {1}", maxBytes, size),
                inFile(where));
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
Result<std::uint64_t> sizeOf(int file, const std::string& where) {
    struct stat info = {};
    if (::fstat(file, &info) != 0)
        return fail(ErrorCode::Unreadable, Sentence("can't be examined: {0}", systemText(errno)),
                    inFile(where));
    if (!S_ISREG(info.st_mode))
        return fail(ErrorCode::Unreadable, Sentence("is {0}, not a file", kindName(info.st_mode)),
                    inFile(where));
    return static_cast<std::uint64_t>(info.st_size);
}

// Like readFully, in parts; between them the observer decides whether to continue. `stopped`: it did not.
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

// `Buffer` is Bytes or std::string. The stated size is one read; anything beyond it (the file has grown, or
// is in /proc, where sizes are 0) is read in blocks.
template<class Buffer>
Result<Buffer> readInto(const Descriptor& file, const std::string& where, std::size_t maxBytes,
                        const ReadObserver& observer = {}) {
    if (!file.valid())
        return fail(codeForOpening(errno), Sentence("can't be opened: {0}", systemText(errno)),
                    inFile(where));
    const Result<std::uint64_t> stated = sizeOf(file.get(), where);
    if (!stated)
        return fail(stated.error());
    if (*stated > maxBytes)
        return tooLarge(*stated, maxBytes, where);
    const auto size = static_cast<std::size_t>(*stated);

    Buffer buffer;
    const auto noMemory = [&] {
        return fail(ErrorCode::TooLarge, Sentence("not enough memory for its {0} bytes", size),
                    inFile(where));
    };
    if (size > buffer.max_size()) // where an address has 32 bits
        return noMemory();
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
                return fail(ErrorCode::Cancelled, "reading was cancelled", inFile(where));
            const auto more = got ? readFully(file.get(), beyond, block) : std::nullopt;
            if (!more)
                return fail(ErrorCode::Unreadable, Sentence("can't be read: {0}", systemText(errno)),
                            inFile(where));
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
        return noMemory();
    }
}

} // namespace

Result<Bytes> readFile(const fs::path& path, std::size_t maxBytes, const ReadObserver& observer) {
    return readInto<Bytes>(Descriptor(openForReading(path)), path.string(), maxBytes, observer);
}

Result<Bytes> readOpened(const Descriptor& file, const std::string& where, std::size_t maxBytes) {
    return readInto<Bytes>(file, where, maxBytes);
}

Result<Bytes> readFileStart(const fs::path& path, std::size_t count) {
    const Descriptor file(openForReading(path));
    if (!file.valid())
        return fail(codeForOpening(errno), Sentence("can't be opened: {0}", systemText(errno)),
                    inFile(path.string()));
    if (const Result<std::uint64_t> size = sizeOf(file.get(), path.string()); !size)
        return fail(size.error());
    Bytes start;
    start.resize(count);
    const auto got = readFully(file.get(), start.data(), count);
    if (!got)
        return fail(ErrorCode::Unreadable, Sentence("can't be read: {0}", systemText(errno)),
                    inFile(path.string()));
    start.resize(*got);
    return start;
}

Result<std::string> readText(const fs::path& path, std::size_t maxBytes) {
    return readInto<std::string>(Descriptor(openForReading(path)), path.string(), maxBytes);
}

} // namespace texplorer
