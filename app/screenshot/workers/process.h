#pragma once

// A worker process, as its program sees it.

#include "app/screenshot/workers/message.h"
#include "texplorer/base/result.h"
#include "texplorer/files/descriptor.h"

#include <span>
#include <string>
#include <sys/types.h>
#include <vector>

namespace texplorer::workers {

/// How a process is started: the program, its arguments (the first one is its name), to which workerWord and
/// the socket's number are added, and what its environment has beside this one's, as "NAME=VALUE".
struct StartCommand {
    std::string program = "/proc/self/exe";
    std::vector<std::string> arguments{};
    std::vector<std::string> environment{};
};

/// A process that works for this one. It gets a socket; its standard output and standard error are a pipe to
/// here; it ends when the thread that started it does, leaves no core file, and ignores what a terminal sends
/// (Ctrl+C): to end it is this program's to do. When the object goes, so does the process.
class Process {
public:
    /// Errors: no descriptor or no process to be had. A program that can't be started is one that ends before
    /// it has begun a job, with status 127.
    [[nodiscard]] static Result<Process> start(const StartCommand& command);

    Process(Process&& other) noexcept;
    Process& operator=(Process&&) = delete;
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
    ~Process();

    [[nodiscard]] int socket() const { return socket_.get(); }
    [[nodiscard]] int output() const { return output_.get(); }

    /// Sent as far as there is room; the rest by `sendMore`.
    void send(Kind kind, std::string_view text);
    void sendMore();
    [[nodiscard]] bool hasMoreToSend() const { return !unsent_.empty(); }

    /// As an Inbox does.
    bool read() { return inbox_.read(socket_.get()); }
    [[nodiscard]] std::optional<Message> take() { return inbox_.take(); }
    [[nodiscard]] bool talksNonsense() const { return inbox_.isBroken(); }

    /// Reads what it printed, as far as there is something.
    void listen();
    /// The end of what it printed.
    [[nodiscard]] const std::string& lastWords() const { return words_; }
    void forgetWords() { words_.clear(); }

    /// Of memory, in bytes, that it has now; 0 where that can't be told.
    [[nodiscard]] std::size_t residentBytes() const;

    /// Its wait status once it has ended. Never waits: a process that hangs within the kernel's part of a
    /// driver doesn't even end by SIGKILL.
    [[nodiscard]] std::optional<int> status();
    void kill();
    /// It ends by itself when it has read that.
    void dismiss() { socket_ = Descriptor(); }

private:
    Process(pid_t process, Descriptor socket, Descriptor output);

    pid_t process_;
    Descriptor socket_;
    Descriptor output_;
    Inbox inbox_;
    std::string unsent_;
    std::string words_;
    std::optional<int> status_;
};

} // namespace texplorer::workers
