#pragma once

#include "app/ui/state/settings.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::ui {

// Several windows share the files: each window merges only its own changes into the current files.

/// Merges the changes between `before` and `now` into the text of a settings file. The rest of the file is
/// kept, including unknown keys; missing values are taken from `now`. Pinned parameters are added and removed
/// individually. `file` is empty or accepted by parseSettings.
[[nodiscard]] std::string mergeSettings(std::string_view file, const Settings& before, const Settings& now);

/// Merges recent files: first those that were opened between `before` and `now`, then the file's. Files that
/// were removed in between are left out.
[[nodiscard]] std::vector<std::filesystem::path>
mergeRecentFiles(const std::vector<std::filesystem::path>& file,
                 const std::vector<std::filesystem::path>& before,
                 const std::vector<std::filesystem::path>& now);

} // namespace texplorer::ui
