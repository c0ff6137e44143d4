#pragma once

#include "core/scene/scene.h"

#include <string>
#include <vector>

namespace texplorer::ui {

/// A line of the command view.
struct Command {
    enum class Kind { Heading, Call };
    Kind kind = Kind::Call;
    std::string text;
    std::string path;     ///< the parameter that the call sets
    bool changed = false; ///< its value isn't GL's initial one
};

/// The GL calls that make the state of a scene, with their values, as a program makes them: textures, camera,
/// light, material, passes, models. Units that are off are left out,
/// and so are GL_COMBINE's state under another mode and coordinates that aren't generated.
[[nodiscard]] std::vector<Command> commandsOf(const Scene& scene);

/// Breaks a call into lines of at most `columns` characters: after a comma or a bracket, continued with four
/// spaces.
[[nodiscard]] std::vector<std::string> wrapCall(const std::string& call, std::size_t columns);

} // namespace texplorer::ui
