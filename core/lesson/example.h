#pragma once

// The scenes of assets/scenes, which are embedded in the program.

#include "texplorer/base/result.h"
#include "texplorer/scene/scene.h"

#include <span>
#include <string_view>
#include <vector>

namespace texplorer {

struct ExampleFile {
    std::string_view name; ///< "checker.json"
    std::string_view text;
};
[[nodiscard]] const std::vector<ExampleFile>& exampleFiles();

struct Example {
    std::string_view file;
    const char* title;
    const char* help; ///< what it shows
};

/// In the order of the menu.
[[nodiscard]] std::span<const Example> examples();

/// Returns the scene of a file. Errors: NotFound, and those of parseScene.
[[nodiscard]] Result<Scene> exampleScene(std::string_view file);

} // namespace texplorer
