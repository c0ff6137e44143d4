#include "app/screenshot/workers/process.h"

#include "app/screenshot/workers/work_loop.h"
#include "texplorer/files/file_io.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace texplorer::workers {
namespace {

constexpr std::size_t maxWords = 4096;

std::string reason() {
    return std::generic_category().message(errno);
}

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    pointers.reserve(texts.size() + 1);
    for (std::string& each : texts)
        pointers.push_back(each.data());
    pointers.push_back(nullptr);
    return pointers;
}

/// This process's, with some that replace those of the same name.
std::vector<std::string> environmentWith(const std::vector<std::string>& more) {
    std::vector<std::string> all = more;
    for (char** each = environ; *each != nullptr; ++each) {
        const std::string_view text = *each;
        const std::string_view name = text.substr(0, text.find('=') + 1);
        bool replaced = false;
        for (const std::string& other : more)
            replaced = replaced || (!name.empty() && other.starts_with(name));
        if (!replaced)
            all.emplace_back(text);
    }
    return all;
}

/// In the new process, before it is another program: nothing here may take a lock or memory (fork(2)).
[[noreturn]] void become(const char* program, char** arguments, char** environment, int socket, int output,
                         pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) // gone before it was asked for
        _exit(127);
    for (const int each : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP})
        ::signal(each, SIG_IGN); // NOLINT(cert-err33-c)
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    const rlimit noCore{0, 0};
    ::setrlimit(RLIMIT_CORE, &noCore);
    const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(output, STDOUT_FILENO);
    ::dup2(output, STDERR_FILENO);
    ::fcntl(socket, F_SETFD, 0);
    ::execve(program, arguments, environment);
    _exit(127);
}

} // namespace

Result<Process> Process::start(const StartCommand& command) {
    std::array<int, 2> sockets{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) != 0)
        return fail(ErrorCode::Unsupported, Sentence("no socket for a worker process: {0}", reason()));
    Descriptor ours(sockets[0]);
    const Descriptor theirs(sockets[1]);
    std::array<int, 2> pipes{};
    if (::pipe2(pipes.data(), O_CLOEXEC) != 0)
        return fail(ErrorCode::Unsupported, Sentence("no pipe for a worker process: {0}", reason()));
    Descriptor heard(pipes[0]);
    const Descriptor said(pipes[1]);
    ::fcntl(ours.get(), F_SETFL, O_NONBLOCK);
    ::fcntl(heard.get(), F_SETFL, O_NONBLOCK);

    std::vector<std::string> arguments = command.arguments;
    arguments.emplace_back(workerWord);
    arguments.push_back(std::to_string(theirs.get()));
    std::vector<std::string> environment = environmentWith(command.environment);
    const std::vector<char*> argumentPointers = pointersTo(arguments);
    const std::vector<char*> environmentPointers = pointersTo(environment);
    const pid_t parent = ::getpid();
    const pid_t process = ::fork();
    if (process < 0)
        return fail(ErrorCode::Unsupported, Sentence("no worker process: {0}", reason()));
    if (process == 0)
        become(command.program.c_str(), const_cast<char**>(argumentPointers.data()),
               const_cast<char**>(environmentPointers.data()), theirs.get(), said.get(), parent);
    return Process(process, std::move(ours), std::move(heard));
}

Process::Process(pid_t process, Descriptor socket, Descriptor output)
    : process_(process)
    , socket_(std::move(socket))
    , output_(std::move(output)) {}

Process::Process(Process&& other) noexcept
    : process_(std::exchange(other.process_, -1))
    , socket_(std::move(other.socket_))
    , output_(std::move(other.output_))
    , inbox_(std::move(other.inbox_))
    , unsent_(std::move(other.unsent_))
    , words_(std::move(other.words_))
    , status_(other.status_) {}

Process::~Process() {
    if (process_ > 0 && !status()) {
        kill();
        static_cast<void>(status());
    }
}

void Process::send(Kind kind, std::string_view text) {
    unsent_ += bytesOf(kind, text);
    sendMore();
}

void Process::sendMore() {
    while (!unsent_.empty()) {
        const ssize_t sent = ::send(socket_.get(), unsent_.data(), unsent_.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR)
            continue;
        if (sent < 0 && errno == EAGAIN)
            return;
        if (sent < 0) { // nobody is there: that is told when it is read
            unsent_.clear();
            return;
        }
        unsent_.erase(0, static_cast<std::size_t>(sent));
    }
}

void Process::listen() {
    std::array<char, 4096> piece;                 // NOLINT(cppcoreguidelines-pro-type-member-init): read into
    for (int pieces = 0; pieces < 64; ++pieces) { // somebody may print for ever
        const ssize_t count = ::read(output_.get(), piece.data(), piece.size());
        if (count < 0 && errno == EINTR)
            continue;
        if (count == 0)
            output_ = Descriptor();
        if (count <= 0)
            return;
        words_.append(piece.data(), static_cast<std::size_t>(count));
        if (words_.size() > maxWords)
            words_.erase(0, words_.size() - maxWords);
    }
}

std::size_t Process::residentBytes() const {
    const Result<std::string> text = readText("/proc/" + std::to_string(process_) + "/statm", 4096);
    if (!text)
        return 0;
    const std::size_t space = text->find(' '); // "total resident shared …", in pages
    if (space == std::string::npos)
        return 0;
    return std::strtoull(text->c_str() + space, nullptr, 10) *
           static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

std::optional<int> Process::status() {
    int status = 0;
    if (!status_ && ::waitpid(process_, &status, WNOHANG) == process_)
        status_ = status;
    return status_;
}

void Process::kill() {
    if (!status_) // else the number may be another process's by now
        ::kill(process_, SIGKILL);
}

} // namespace texplorer::workers
