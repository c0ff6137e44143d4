#pragma once

#include "tests/support/temp_dir.h"

#include <chrono>
#include <filesystem>
#include <optional>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <vector>

extern char** environ;

namespace texplorer::bench {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

/// Programs with a cache folder of their own, and a folder for what they write.
class Caller {
public:
    explicit Caller(bool cold)
        : cold_(cold) {
        fs::create_directories(pictures());
    }

    [[nodiscard]] fs::path pictures() const { return folder_ / "pictures"; }

    /// Seconds; none where it fails.
    std::optional<double> run(const Words& words) {
        const fs::path cache = folder_ / "cache";
        if (cold_)
            fs::remove_all(cache);
        fs::create_directories(cache);
        const std::string cacheVariable = "XDG_CACHE_HOME=" + cache.string();
        std::vector<char*> environment{const_cast<char*>(cacheVariable.c_str())};
        for (char** each = environ; *each != nullptr; ++each) {
            if (!std::string_view(*each).starts_with("XDG_CACHE_HOME="))
                environment.push_back(*each);
        }
        environment.push_back(nullptr);
        Words copy = words;
        std::vector<char*> arguments;
        for (std::string& word : copy)
            arguments.push_back(word.data());
        arguments.push_back(nullptr);
        const auto begin = std::chrono::steady_clock::now();
        pid_t child = 0;
        int status = 0;
        if (posix_spawn(&child, arguments[0], nullptr, nullptr, arguments.data(), environment.data()) != 0 ||
            waitpid(child, &status, 0) != child || status != 0)
            return std::nullopt;
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }

private:
    bool cold_;
    test::TempDir folder_;
};

} // namespace texplorer::bench
