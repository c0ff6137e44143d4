#include "app/explorer/restart.h"

#include "app/command_line/standard_streams.h"
#include "texplorer/scene/renderer.h"

#include <fmt/core.h>

#include <charconv>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace texplorer::explorer {
namespace {

namespace fs = std::filesystem;

/// Tells the new process why it was started: the seconds that the driver had.
constexpr std::string_view variable = "TEXPLORER_HUNG";
constexpr const char* itself = "/proc/self/exe";

/// The lock of the unsaved work must be free for the new process, the driver's device must be closed.
void closeFilesOnExec() {
    std::error_code failed;
    for (fs::directory_iterator at("/proc/self/fd", failed), end; !failed && at != end;
         at.increment(failed)) {
        const std::string name = at->path().filename().string();
        int number = 0;
        std::from_chars(name.data(), name.data() + name.size(), number);
        if (number > STDERR_FILENO)
            static_cast<void>(::fcntl(number, F_SETFD, FD_CLOEXEC));
    }
}

/// By its path, which keeps the name of the process; of a program that was replaced meanwhile only the open
/// file is left.
const char* pathOfProgram() {
    static std::string path;
    std::error_code failed;
    path = fs::read_symlink(itself, failed).string();
    return !failed && fs::exists(path, failed) ? path.c_str() : itself;
}

std::vector<char*> pointersTo(std::vector<std::string>& words) {
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return pointers;
}

} // namespace

Restart::Restart(Signals& signals, std::string program, std::vector<std::string> options)
    : signals_(signals)
    , program_(std::move(program))
    , options_(std::move(options)) {}

void Restart::note(Reopened reopened) {
    const std::scoped_lock lock(mutex_);
    reopened_ = std::move(reopened);
}

std::vector<std::string> Restart::words() const {
    std::vector<std::string> words{program_};
    words.insert(words.end(), options_.begin(), options_.end());
    words.emplace_back("--renderer");
    words.emplace_back(rowOf(RendererKind::Reference).name);
    words.insert(words.end(), reopened_.arguments.begin(), reopened_.arguments.end());
    return words;
}

void Restart::run(double seconds) {
    const std::scoped_lock lock(mutex_);
    if (!reopened_.helps) {
        complain("texplorer",
                 fmt::format(
                     "the driver did not finish a picture of the window within {:g} s, although it does not "
                     "draw the scene; unsaved work is stored and offered at the next start",
                     seconds));
        std::_Exit(EXIT_FAILURE);
    }
    complain(
        "texplorer",
        fmt::format("the driver did not finish a picture within {:g} s; the window starts again, and the "
                    "reference renderer draws",
                    seconds));
    std::vector<std::string> arguments = words();
    std::vector<std::string> variables{fmt::format("{}={:g}", variable, seconds)};
    for (char** each = environ; *each; ++each)
        variables.emplace_back(*each);
    const char* path = pathOfProgram();
    closeFilesOnExec();
    if (!toldOfBrokenPipes())
        std::signal(SIGPIPE, SIG_DFL);
    signals_.restore();
    ::execve(path, pointersTo(arguments).data(), pointersTo(variables).data());
    complain("texplorer", fmt::format("the window can't be started again: {}", systemText(errno)));
    std::_Exit(EXIT_FAILURE);
}

std::optional<double> Restart::takeReason() {
    const std::string name(variable);
    const char* value = std::getenv(name.c_str()); // NOLINT(concurrency-mt-unsafe): no other thread runs yet
    if (!value)
        return std::nullopt;
    double seconds = 0;
    const auto read = std::from_chars(value, value + std::strlen(value), seconds);
    static_cast<void>(::unsetenv(name.c_str())); // NOLINT(concurrency-mt-unsafe): the same
    return read.ec == std::errc() ? std::optional(seconds) : std::nullopt;
}

} // namespace texplorer::explorer
