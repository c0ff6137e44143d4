#pragma once

#include "app/screenshot/arguments/scene_argument.h"
#include "core/emit/program.h"

#include <string>
#include <vector>

namespace texplorer::screenshot {

/// The program that draws the scene of a command line. With a lesson its text is said at the top, and what
/// the step is about has a word on it. options.source is the path of the program: images are named from
/// there.
[[nodiscard]] tl::expected<std::vector<emit::Line>, SceneProblem>
programOf(const SceneArgument& argument, emit::Flavour flavour, emit::ProgramOptions options);

} // namespace texplorer::screenshot
