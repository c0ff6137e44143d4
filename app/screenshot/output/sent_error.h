#pragma once

// Errors that pass from one process of texshot to another.

#include "texplorer/base/result.h"

#include <nlohmann/json.hpp>

namespace texplorer::screenshot {

[[nodiscard]] nlohmann::json sentJson(const Error& error);

/// The same error. Its message keeps its ID if it has one. Throws an exception of nlohmann-json for anything
/// else.
[[nodiscard]] Error sentError(const nlohmann::json& sent);

} // namespace texplorer::screenshot
