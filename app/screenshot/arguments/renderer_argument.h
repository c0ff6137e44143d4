#pragma once

#include "app/screenshot/arguments/context_argument.h"
#include "app/screenshot/command.h"
#include "app/screenshot/gl/gl_module.h"

#include <string>
#include <vector>

namespace texplorer::screenshot {

/// Which renderer draws and by which OpenGL, as the command line spells it.
struct RendererArgument {
    std::string renderer = std::string(rowOf(RendererKind::Fixed).name);
    std::string shaders;
    std::vector<std::string> pretended;
    ContextArgument context;
    const Option* rendererOption = nullptr;
    const Option* shadersOption = nullptr;
};

/// Declares --renderer, --shaders, --context and --pretend. `orElse`: what uses the shaders beside their
/// renderer, " or --ui".
void addRendererArgument(Command& command, RendererArgument& argument, const std::string& orElse = {});

/// What it says, put into a request. The error is a wrong call.
[[nodiscard]] Result<void> putRenderer(const RendererArgument& argument, ShotRequest& request);

/// Refuses those of them that change nothing with this request.
[[nodiscard]] Result<void> checkRendererUse(const RendererArgument& argument, const ShotRequest& request,
                                            const std::string& orElse = {});

} // namespace texplorer::screenshot
