#pragma once

#include "app/command_line/command_line.h"
#include "texplorer/scene/params/sweep_axis.h"

#include <string>
#include <vector>

namespace texplorer::screenshot {

/// Declares --axis. `what`: what there is for its values, "a picture for each".
void addAxesArgument(Command& command, std::vector<std::string>& axes, const std::string& what,
                     bool required = false);

/// Of a scene, each of another parameter.
[[nodiscard]] Result<std::vector<SweepAxis>> parseAxes(const Scene& scene,
                                                       const std::vector<std::string>& axes);

} // namespace texplorer::screenshot
