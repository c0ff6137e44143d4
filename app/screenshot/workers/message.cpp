#include "app/screenshot/workers/message.h"

#include <array>
#include <cassert>
#include <cerrno>
#include <sys/socket.h>

namespace texplorer::workers {
namespace {

constexpr std::size_t lengthBytes = 4;

bool isKind(char letter) {
    return letter == static_cast<char>(Kind::Job) || letter == static_cast<char>(Kind::Begun) ||
           letter == static_cast<char>(Kind::Answer);
}

} // namespace

std::string bytesOf(Kind kind, std::string_view text) {
    assert(text.size() <= maxMessageBytes);
    std::string bytes;
    bytes.reserve(lengthBytes + 1 + text.size());
    for (unsigned i = 0; i < lengthBytes; ++i)
        bytes += static_cast<char>(((text.size() + 1) >> (8 * i)) & 0xFFU);
    bytes += static_cast<char>(kind);
    bytes += text;
    return bytes;
}

bool send(int socket, Kind kind, std::string_view text) {
    const std::string bytes = bytesOf(kind, text);
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t sent = ::send(socket, bytes.data() + done, bytes.size() - done, MSG_NOSIGNAL);
        if (sent < 0 && errno != EINTR)
            return false;
        done += sent > 0 ? static_cast<std::size_t>(sent) : 0;
    }
    return true;
}

std::size_t Inbox::length() const {
    std::size_t length = 0;
    for (std::size_t i = 0; i < lengthBytes; ++i)
        length |= std::size_t{static_cast<unsigned char>(bytes_[i])} << (8 * i);
    return length;
}

bool Inbox::read(int socket) {
    std::array<char, 65536> piece; // NOLINT(cppcoreguidelines-pro-type-member-init): read into
    const ssize_t count = ::recv(socket, piece.data(), piece.size(), 0);
    if (count > 0)
        bytes_.append(piece.data(), static_cast<std::size_t>(count));
    return count > 0 || (count < 0 && (errno == EINTR || errno == EAGAIN));
}

bool Inbox::isBroken() const {
    if (bytes_.size() >= lengthBytes && (length() == 0 || length() > maxMessageBytes + 1))
        return true;
    return bytes_.size() > lengthBytes && !isKind(bytes_[lengthBytes]);
}

std::optional<Message> Inbox::take() {
    if (bytes_.size() <= lengthBytes || isBroken() || bytes_.size() < lengthBytes + length())
        return std::nullopt;
    Message message{static_cast<Kind>(bytes_[lengthBytes]), bytes_.substr(lengthBytes + 1, length() - 1)};
    bytes_.erase(0, lengthBytes + length());
    return message;
}

} // namespace texplorer::workers
