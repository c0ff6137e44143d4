#include "texplorer/files/read_stream.h"

#include "texplorer/files/file_kind.h"

#include <algorithm>
#include <cerrno>
#include <new>
#include <poll.h>
#include <unistd.h>

namespace texplorer {
namespace {

constexpr std::size_t startBytes = std::size_t{1} << 20;

/// Like read(2), but also blocks if the file was opened as non-blocking; -1 leaves errno.
ssize_t readSome(int file, std::byte* to, std::size_t count) {
    for (;;) {
        const ssize_t got = ::read(file, to, count);
        if (got >= 0 || (errno != EINTR && errno != EAGAIN))
            return got;
        if (errno == EAGAIN) {
            pollfd readable{file, POLLIN, 0};
            static_cast<void>(::poll(&readable, 1, -1));
        }
    }
}

} // namespace

Result<Bytes> readStream(int file, const std::string& where, std::size_t maxBytes,
                         const IsWorthReading& isWorthReading) {
    Bytes bytes;
    std::size_t filled = 0;
    std::size_t asked = startBytes; // with the first so many bytes
    try {
        for (;;) {
            if (filled == bytes.size()) // one byte more than is accepted tells that there are more
                bytes.resize(std::min(std::max(startBytes, 2 * filled), maxBytes + 1));
            const ssize_t got = readSome(file, bytes.data() + filled, bytes.size() - filled);
            if (got < 0)
                return fail(ErrorCode::Unreadable, Sentence("can't be read: {0}", systemText(errno)),
                            inFile(where));
            filled += static_cast<std::size_t>(got);
            if (filled > maxBytes)
                return fail(ErrorCode::TooLarge,
                            Sentence("at most {0} bytes are read, but there are more", maxBytes),
                            inFile(where));
            const bool isAsked = filled >= asked;
            if (isAsked)
                asked = 2 * filled;
            if (got == 0 || (isAsked && isWorthReading && !isWorthReading({bytes.data(), filled}))) {
                bytes.resize(filled);
                return bytes;
            }
        }
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge, Sentence("not enough memory for more than {0} bytes", filled),
                    inFile(where));
    }
}

} // namespace texplorer
