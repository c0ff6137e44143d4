#pragma once

#include "app/ui/state/settings.h"
#include "texplorer/base/result.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::ui {

/// Settings as a JSON object; recent files have a separate text. Unknown keys in `before` are kept.
[[nodiscard]] std::string writeSettings(const Settings& settings, std::string_view before = {});
[[nodiscard]] std::string writeRecentFiles(const Settings& settings);

/// Missing values are as in `Settings{}`; unknown keys are ignored. Invalid values are skipped and their JSON
/// pointers added to `leftOut`: they may be from a later version. Fails for invalid JSON and other documents.
[[nodiscard]] Result<Settings> parseSettings(std::string_view json, std::vector<std::string>& leftOut);
[[nodiscard]] Result<std::vector<std::filesystem::path>> parseRecentFiles(std::string_view json,
                                                                          std::vector<std::string>& leftOut);

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
