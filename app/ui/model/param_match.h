#pragma once

#include "texplorer/scene/params/params.h"

#include <string_view>

namespace texplorer::ui {

/// Whether a parameter matches a search text in any case: by its label, its key, its GL call, its choices or
/// its help. 2: by its name, 1: by its other texts, 0: no match. All words must be found.
[[nodiscard]] int matchOf(const ParamRow& row, std::string_view words);

} // namespace texplorer::ui
