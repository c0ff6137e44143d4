#pragma once

#include "tests/bench/child.h"
#include "tests/support/temp_dir.h"

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::bench {

namespace fs = std::filesystem;

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
        const auto begin = std::chrono::steady_clock::now();
        if (!hasSucceeded(startChild(words, cacheVariable)))
            return std::nullopt;
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }

private:
    bool cold_;
    test::TempDir folder_;
};

} // namespace texplorer::bench
