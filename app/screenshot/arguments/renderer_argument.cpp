#include "app/screenshot/arguments/renderer_argument.h"

#include "app/screenshot/arguments/choice_argument.h"
#include "app/screenshot/arguments/option_use.h"

#include <fmt/core.h>

namespace texplorer::screenshot {

void addRendererArgument(Command& command, RendererArgument& argument, const std::string& orElse) {
    argument.rendererOption =
        &command.option("--renderer", argument.renderer,
                        fmt::format("The renderer that draws the scene, one of {}.",
                                    listNames(EnumTable<RendererKind>::rows)),
                        {.value = "RENDERER", .showsDefault = true, .offers = {choiceNames<RendererKind>}});
    argument.shadersOption = &command.option(
        "--shaders", argument.shaders,
        fmt::format(
            "With --renderer shader{}: the folder of the shader renderer's files, a copy of shaders/. "
            "Without it: those that the program was built with.",
            orElse),
        {.value = "DIR", .environment = "TEXPLORER_SHADERS"});
    addContextArgument(command, argument.context);
    command.option("--pretend", argument.pretended, view::pretenceHelp(),
                   {.value = "WORDS", .oneEach = true, .offers = {view::pretenceWords, true}});
}

Result<void> putRenderer(const RendererArgument& argument, ShotRequest& request) {
    const Result<RendererKind> renderer = parseChoice<RendererKind>(argument.renderer, "--renderer");
    if (!renderer)
        return fail(renderer.error());
    const Result<view::Pretence> pretence = view::Pretence::parse(argument.pretended);
    if (!pretence)
        return fail(pretence.error());
    const Result<view::ContextChoice> context = parseContext(argument.context);
    if (!context)
        return fail(context.error());
    request.renderer = *renderer;
    request.pretence = *pretence;
    request.context = *context;
    request.shaders = argument.shaders;
    return {};
}

Result<void> checkRendererUse(const RendererArgument& argument, const ShotRequest& request,
                              const std::string& orElse) {
    if (request.window)
        return {};
    if (argument.shadersOption->isGiven() && request.renderer != RendererKind::Shader)
        return unusedOption("--shaders", "it is for --renderer shader" + orElse);
    const bool reference = request.renderer == RendererKind::Reference;
    if (!argument.pretended.empty() && reference)
        return unusedOption("--pretend", "it is about OpenGL's driver, which the reference doesn't ask");
    if (argument.context.option->isGiven() && reference)
        return unusedOption("--context", "it is about OpenGL, which the reference doesn't ask");
    return {};
}

} // namespace texplorer::screenshot
