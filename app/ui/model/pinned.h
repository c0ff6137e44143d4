#pragma once

#include "app/ui/model/settings.h"

#include <string>
#include <string_view>

namespace texplorer::ui {

/// A parameter of any texture, unit, model …: "textures[].wrapR" of "textures[2].wrapR".
[[nodiscard]] std::string patternOf(std::string_view path);

/// Whether Essentials shows a parameter because the user wants it there.
[[nodiscard]] bool isPinned(const Settings& settings, std::string_view path);

/// Whether it is one of those that Essentials always has.
[[nodiscard]] bool isEssential(std::string_view path);

/// Pins it, or takes the pin away.
void togglePin(Settings& settings, std::string_view path);

} // namespace texplorer::ui
