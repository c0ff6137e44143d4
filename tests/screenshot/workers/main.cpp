// Runs the tests. Started by a test as a worker process, it does what the job says.

#include "app/screenshot/workers/work_loop.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <sys/socket.h>
#include <unistd.h>
#include <vector>

namespace {

/// "VERB REST"; the test checks the answer.
std::string work(const std::string& job, int socket) {
    const std::string verb = job.substr(0, job.find(' '));
    const std::string rest = job.substr(std::min(job.size(), verb.size() + 1));
    static std::vector<char> kept;
    if (verb == "raise")
        std::raise(std::stoi(rest));
    else if (verb == "exit")
        _exit(std::stoi(rest));
    else if (verb == "hang")
        for (;;)
            ::pause();
    else if (verb == "print") { // as drivers do, at any time
        std::cout << rest << std::flush;
        std::cerr << rest << std::flush;
    } else if (verb == "killed-once" && !std::filesystem::exists(rest)) {
        std::ofstream(rest).put('x');
        std::raise(SIGKILL);
    } else if (verb == "garble") {
        const std::string garbage(64, '\xff');
        static_cast<void>(::send(socket, garbage.data(), garbage.size(), 0));
        for (;;)
            ::pause();
    } else if (verb == "grow")
        kept.assign(std::stoul(rest) << 20, 'x');
    else if (verb == "process")
        return std::to_string(::getpid());
    else if (verb == "environment") {
        const char* value = std::getenv(rest.c_str());
        return value != nullptr ? value : "(none)";
    } else if (verb == "inherited") { // whether another open file was inherited
        return ::fcntl(std::stoi(rest), F_GETFD) < 0 ? "closed" : "open";
    }
    return rest;
}

} // namespace

int main(int argc, char** argv) {
    using namespace texplorer::workers;
    if (const std::optional<int> socket = workerSocket(argc, argv)) {
        if (std::getenv("TEST_WORKER_FAILS") != nullptr) {
            std::cerr << "no screen available";
            return 1;
        }
        workLoop(*socket, [socket](const std::string& job) { return work(job, *socket); });
        return EXIT_SUCCESS;
    }
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
