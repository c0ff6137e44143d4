#pragma once

#include "core/scene/params/params.h"

#include <string_view>

namespace texplorer::ui {

/// Whether a parameter is what somebody looks for who types this, in whatever case: by its label, its key,
/// its GL call, its choices or its help. 2: by its name, 1: by what is said of it, 0: it isn't. All words
/// must be found.
[[nodiscard]] int matchOf(const ParamRow& row, std::string_view words);

} // namespace texplorer::ui
