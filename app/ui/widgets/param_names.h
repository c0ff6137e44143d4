#pragma once

#include "app/ui/state/settings.h"
#include "texplorer/scene/params/params.h"

#include <string_view>

namespace texplorer::ui {

// The names of parameters and their choices: plain words, or OpenGL's names if there are any.

[[nodiscard]] std::string_view shownName(const Settings& settings, const ParamRow& row);
[[nodiscard]] std::string_view shownName(const Settings& settings, const EnumRow& choice);
/// On a button.
[[nodiscard]] std::string_view shownBrief(const Settings& settings, const EnumRow& choice);

} // namespace texplorer::ui
