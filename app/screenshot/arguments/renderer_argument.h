#pragma once

#include "app/command_line/command_line.h"
#include "app/screenshot/arguments/context_argument.h"
#include "app/screenshot/arguments/picture_argument.h"
#include "app/screenshot/gl/gl_module.h"

#include <span>
#include <string>
#include <string_view>
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
void addRendererArgument(Command& command, RendererArgument& argument, Several several = Several::No,
                         const std::string& orElse = {});

/// With commas between them, each once; `option` is named in the error.
[[nodiscard]] Result<std::vector<RendererKind>> parseRenderers(std::string_view text, const char* option);

/// What it says, put into a request, all but the renderer. The error is a wrong call.
[[nodiscard]] Result<void> putContext(const RendererArgument& argument, ShotRequest& request);

/// A note for those of them that change nothing where these renderers draw; a window has all of them.
void noteRendererUse(const RendererArgument& argument, std::span<const RendererKind> renderers,
                     const std::string& orElse = {});

} // namespace texplorer::screenshot
