#pragma once

#include "app/ui/state/document.h"
#include "texplorer/emit/code.h"

#include <functional>
#include <set>
#include <string>

namespace texplorer::ui {

/// Paths of values in the scene, as the parts of emitted lines name them: "models[0].texCoords0[2]" is a
/// vertex's.
using ChangedPaths = std::set<std::string, std::less<>>;

/// The changes of the last undo step: the parameter, or the changed vertices of a list of coordinates.
[[nodiscard]] ChangedPaths changedPaths(const Document& document);

[[nodiscard]] bool mentionsAny(const emit::Line& line, const ChangedPaths& paths);

} // namespace texplorer::ui
