#pragma once

#include "app/screenshot/command.h"
#include "core/scene/scene.h"
#include "core/texture/image_source.h"

namespace texplorer::screenshot {

/// The scene that a command line names, with its changes.
struct SceneArgument {
    std::string file; ///< empty: the default scene
    std::vector<std::string> assignments;
    std::vector<std::string> presets; ///< applied after them, to unit 0 of pass 0
};

/// Declares SCENE, --set and --preset.
void addSceneArgument(Command& command, SceneArgument& argument);

struct OpenedScene {
    Scene scene;
    ImageSource images; ///< nothing is loaded yet
};

/// Why a scene can't be opened, and the exit status that this leads to.
struct SceneProblem {
    Error error;
    ExitCode code;
};

[[nodiscard]] tl::expected<OpenedScene, SceneProblem> openScene(const SceneArgument& argument);

/// An error about something in the scene, with the scene's file in front of its place.
[[nodiscard]] Error inScene(const SceneArgument& argument, const Error& error);

} // namespace texplorer::screenshot
