#pragma once

#include <spawn.h>
#include <string>
#include <string_view>
#include <sys/wait.h>
#include <vector>

extern char** environ;

namespace texplorer::bench {

using Words = std::vector<std::string>;

/// Descriptors that become a program's standard input and output; -1: it has this one's.
struct ChildFiles {
    int input = -1;
    int output = -1;
};

/// Starts a program. `variable`, "NAME=VALUE", replaces one of the environment's. 0: it can't be started.
inline pid_t startChild(Words words, std::string variable = {}, ChildFiles files = {}) {
    const std::string_view name = std::string_view(variable).substr(0, variable.find('=') + 1);
    std::vector<char*> environment;
    if (!name.empty())
        environment.push_back(variable.data());
    for (char** each = environ; *each != nullptr; ++each) {
        if (name.empty() || !std::string_view(*each).starts_with(name))
            environment.push_back(*each);
    }
    environment.push_back(nullptr);
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    if (files.input >= 0)
        posix_spawn_file_actions_adddup2(&actions, files.input, 0);
    if (files.output >= 0)
        posix_spawn_file_actions_adddup2(&actions, files.output, 1);
    pid_t child = 0;
    const int failed =
        posix_spawn(&child, arguments[0], &actions, nullptr, arguments.data(), environment.data());
    posix_spawn_file_actions_destroy(&actions);
    return failed == 0 ? child : 0;
}

/// Waits for its end; false where it was not started, or failed.
inline bool hasSucceeded(pid_t child) {
    int status = 0;
    return child != 0 && waitpid(child, &status, 0) == child && status == 0;
}

} // namespace texplorer::bench
