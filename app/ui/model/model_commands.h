#pragma once

#include "app/ui/model/commands.h"

namespace texplorer::ui {

/// The calls that place a model and draw it, at time 0, while the modelview matrix is the camera's: the first
/// line is the heading.
[[nodiscard]] std::vector<Command> modelCommands(const Scene& scene, std::size_t index);

/// The calls of one step of a texture matrix at time 0; `path` is "passes[0].units[0].matrix[1]", which is
/// also the heading. `light` is whose view a step may be.
[[nodiscard]] std::vector<Command> stepCommands(const MatrixStep& step, const std::string& path,
                                                const Light& light);

} // namespace texplorer::ui
