#pragma once

#include "app/ui/state/settings.h"

#include <string>
#include <string_view>

namespace texplorer::ui {

/// The pattern of a path, for any texture, unit, model …: "textures[].wrapR" of "textures[2].wrapR".
[[nodiscard]] std::string patternOf(std::string_view path);

/// Whether the user has pinned a parameter in Essentials.
[[nodiscard]] bool isPinned(const Settings& settings, std::string_view path);

/// Whether it is always in Essentials.
[[nodiscard]] bool isEssential(std::string_view path);

/// Pins or unpins it.
void togglePin(Settings& settings, std::string_view path);

} // namespace texplorer::ui
