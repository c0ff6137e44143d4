#include "tests/random/batches.h"

#include "tests/support/under_asan.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <deque>
#include <exception>
#include <memory>
#include <poll.h>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace texplorer::random {

/// The numbers of one child.
struct ChildNumbers {
    int first;
    int end;
    bool again = false; ///< the number at which an earlier child ended, run alone
};

namespace {

std::string oneLine(std::string_view text) {
    std::string line(text);
    std::ranges::replace_if(
        line, [](char each) { return each == '\n' || each == '\t'; }, ' ');
    return line;
}

} // namespace

void Journal::step(std::string_view name) {
    alarm(limitSeconds_);
    write("step", name, "");
}

void Journal::write(std::string_view word, std::string_view kind, std::string_view text) {
    const std::string line = std::string(word) + '\t' + oneLine(kind) + '\t' + oneLine(text) + '\n';
    for (std::size_t done = 0; done < line.size();) {
        const ssize_t written = ::write(pipe_, line.data() + done, line.size() - done);
        if (written < 0 && errno != EINTR)
            _exit(EXIT_FAILURE); // the parent has closed the pipe
        done += written > 0 ? static_cast<std::size_t>(written) : 0;
    }
}

/// A child process and the results that the parent has received from it.
class Child {
public:
    Child(const Batches& batches, ChildNumbers numbers, const std::function<Work(int)>& open)
        : numbers_(numbers)
        , at_(numbers.first)
        , limit_(batches.limitSeconds) {
        std::array<int, 2> ends{};
        if (::pipe(ends.data()) != 0)
            throw std::runtime_error(std::string("no pipe: ") + std::strerror(errno));
        pid_ = fork();
        if (pid_ < 0)
            throw std::runtime_error(std::string("no child process: ") + std::strerror(errno));
        if (pid_ == 0) {
            close(ends[0]);
            work(batches, ends[1], open);
        }
        close(ends[1]);
        pipe_ = ends[0];
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() {
        close(pipe_);
        if (!reaped_) { // only if the parent gives up
            kill(pid_, SIGKILL);
            waitpid(pid_, nullptr, 0);
        }
    }

    [[nodiscard]] int pipe() const { return pipe_; }
    [[nodiscard]] const ChildNumbers& numbers() const { return numbers_; }
    [[nodiscard]] int at() const { return at_; }
    [[nodiscard]] const std::string& step() const { return step_; }

    /// Reads the available data; false if there will be no more.
    bool listen(std::vector<Note>& notes, int& done) {
        std::array<char, 4096> bytes{};
        const ssize_t count = read(pipe_, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR)
            return true;
        if (count <= 0)
            return false;
        heard_.append(bytes.data(), static_cast<std::size_t>(count));
        for (std::size_t end = heard_.find('\n'); end != std::string::npos; end = heard_.find('\n')) {
            take(heard_.substr(0, end), notes, done);
            heard_.erase(0, end + 1);
        }
        return true;
    }

    /// The reason of its end; empty: it ended normally.
    std::string end() {
        int status = 0;
        while (waitpid(pid_, &status, 0) < 0 && errno == EINTR)
            continue;
        reaped_ = true;
        if (WIFSIGNALED(status))
            return WTERMSIG(status) == SIGALRM ? "no end within " + std::to_string(limit_) + " s"
                                               : strsignal(WTERMSIG(status));
        if (WEXITSTATUS(status) != 0)
            return "exit status " + std::to_string(WEXITSTATUS(status));
        return at_ < numbers_.end ? "exit before its end" : "";
    }

private:
    [[noreturn]] void work(const Batches& batches, int pipe, const std::function<Work(int)>& open) {
        Journal journal(pipe, batches.limitSeconds);
        const rlimit noCore{0, 0};
        setrlimit(RLIMIT_CORE, &noCore);
        if (batches.memoryLimit > 0 && !test::underAsan) { // its address space takes terabytes
            const rlimit memory{batches.memoryLimit, batches.memoryLimit};
            setrlimit(RLIMIT_AS, &memory);
        }
        try {
            alarm(limit_);
            const Work each = open(numbers_.first);
            for (int number = numbers_.first; number < numbers_.end; ++number) {
                alarm(limit_);
                try {
                    each(number, journal);
                } catch (const std::exception& error) {
                    journal.note("broken", std::string("an exception: ") + error.what());
                }
                journal.write("done", "", "");
            }
        } catch (const std::exception& error) {
            journal.step(std::string("opening: ") + error.what());
            _exit(EXIT_FAILURE);
        }
        _exit(EXIT_SUCCESS); // objects of the parent must not be destroyed by the child
    }

    void take(const std::string& line, std::vector<Note>& notes, int& done) {
        const std::size_t kind = line.find('\t') + 1;
        const std::size_t text = line.find('\t', kind) + 1;
        const std::string word = line.substr(0, kind - 1);
        if (word == "done") {
            ++at_;
            ++done;
            step_.clear();
        } else if (word == "step") {
            step_ = line.substr(kind, text - kind - 1);
        } else {
            notes.push_back({at_, line.substr(kind, text - kind - 1), line.substr(text)});
        }
    }

    ChildNumbers numbers_;
    int at_;
    unsigned limit_;
    pid_t pid_ = -1;
    int pipe_ = -1;
    bool reaped_ = false;
    std::string heard_;
    std::string step_;
};

Ended runBatches(const Batches& batches, const std::function<Work(int)>& open) {
    Ended ended;
    std::deque<ChildNumbers> waiting;
    const int end = batches.first + batches.count;
    for (int first = batches.first; first < end; first = waiting.back().end)
        waiting.push_back({first, std::min((first / batches.size + 1) * batches.size, end)});
    std::vector<std::unique_ptr<Child>> children;

    const auto bury = [&](Child& child) {
        const std::string cause = child.end();
        if (cause.empty())
            return;
        const auto& [first, last, again] = child.numbers();
        if (again) {
            std::ranges::find(ended.deaths, child.at(), &Death::number)->alone = true;
            return;
        }
        ended.deaths.push_back({child.at(), child.step(), cause, child.at() == first, first});
        if (child.at() != first)
            waiting.push_front({child.at(), child.at() + 1, true});
        if (child.at() + 1 < last)
            waiting.push_front({child.at() + 1, last});
    };

    while (!waiting.empty() || !children.empty()) {
        while (!waiting.empty() && children.size() < std::max(1U, batches.jobs)) {
            const ChildNumbers numbers = waiting.front();
            waiting.pop_front();
            children.push_back(std::make_unique<Child>(batches, numbers, open));
        }
        std::vector<pollfd> pipes;
        for (const auto& child : children)
            pipes.push_back({child->pipe(), POLLIN, 0});
        if (poll(pipes.data(), pipes.size(), -1) < 0 && errno != EINTR)
            throw std::runtime_error(std::string("no word from the children: ") + std::strerror(errno));
        for (std::size_t i = children.size(); i-- > 0;) {
            if (pipes[i].revents == 0 || children[i]->listen(ended.notes, ended.done))
                continue;
            bury(*children[i]);
            children.erase(children.begin() + static_cast<std::ptrdiff_t>(i));
        }
        if (batches.progress)
            batches.progress(ended.done + static_cast<int>(ended.deaths.size()));
    }
    std::ranges::stable_sort(ended.notes, {}, &Note::number);
    std::ranges::sort(ended.deaths, {}, &Death::number);
    return ended;
}

} // namespace texplorer::random
