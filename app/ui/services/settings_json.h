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

} // namespace texplorer::ui
