#pragma once

// What a program and its worker processes tell each other, over a socket that is neither standard output nor
// standard error: drivers print on both. A message is its length (32 bits, the lowest first), a letter and
// bytes.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace texplorer::workers {

enum class Kind : char {
    Job = 'j',    ///< to the worker: what to do
    Begun = 'b',  ///< from it: the job has arrived, and what happens from here on is the job's doing
    Answer = 'a', ///< from it: what came of the job
};

struct Message {
    Kind kind{};
    std::string text;
};

/// What is longer was not written by a program in its senses.
inline constexpr std::size_t maxMessageBytes = std::size_t{64} << 20;

/// As it goes over the socket. `text` is at most maxMessageBytes long.
[[nodiscard]] std::string bytesOf(Kind kind, std::string_view text);

/// Waits until all of it is sent; false leaves errno.
[[nodiscard]] bool send(int socket, Kind kind, std::string_view text);

/// What has arrived, in pieces of any size.
class Inbox {
public:
    /// Reads once what is there; waits where the socket does. False: nobody is at the other end.
    bool read(int socket);

    /// The next message that is whole.
    [[nodiscard]] std::optional<Message> take();

    /// What comes next is no message.
    [[nodiscard]] bool isBroken() const;

private:
    [[nodiscard]] std::size_t length() const; ///< of what follows the first four bytes

    std::string bytes_;
};

} // namespace texplorer::workers
