#pragma once

#include "app/ui/model/document.h"
#include "core/emit/code.h"

#include <functional>
#include <set>
#include <string>

namespace texplorer::ui {

/// Values of the scene, as the parts of emitted lines name them: "models[0].texCoords0[2]" is a vertex's.
using ChangedPaths = std::set<std::string, std::less<>>;

/// What the last step of undo changed: the parameter, or of a list of coordinates those vertices that have
/// others than before.
[[nodiscard]] ChangedPaths changedPaths(const Document& document);

[[nodiscard]] bool mentionsAny(const emit::Line& line, const ChangedPaths& paths);

} // namespace texplorer::ui
