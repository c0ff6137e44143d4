#pragma once

#include "app/ui/model/settings.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::ui {

// Several windows share the files: each writes only what it has changed, into what lies there by then.

/// The text of a settings' file with what changed between `before` and `now`. Everything else stays as the
/// file has it, with keys that nobody knows; what it lacks gets the value of now. Of pinned parameters
/// those that were added and taken away count. `file` is empty or one that parseSettings takes.
[[nodiscard]] std::string mergeSettings(std::string_view file, const Settings& before, const Settings& now);

/// The recent files of both: first those that were opened between `before` and `now`, then the file's. What
/// was forgotten in between goes.
[[nodiscard]] std::vector<std::filesystem::path>
mergeRecentFiles(const std::vector<std::filesystem::path>& file,
                 const std::vector<std::filesystem::path>& before,
                 const std::vector<std::filesystem::path>& now);

} // namespace texplorer::ui
