#include "app/screenshot/arguments/renderer_argument.h"

#include "app/command_line/choice_argument.h"
#include "app/screenshot/arguments/each_of_list.h"
#include "app/screenshot/arguments/option_use.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::screenshot {

void addRendererArgument(Command& command, RendererArgument& argument, Several several,
                         const std::string& orElse) {
    const bool joined = several == Several::Yes;
    argument.rendererOption = &command.option(
        "--renderer", argument.renderer,
        fmt::format("The renderer that draws the scene, one of {}.{}",
                    listNames(EnumTable<RendererKind>::rows),
                    joined ? " Of several, with commas: a picture for each." : ""),
        {.value = "RENDERER", .showsDefault = true, .offers = {choiceNames<RendererKind>, joined}});
    argument.shadersOption = &command.option(
        "--shaders", argument.shaders,
        fmt::format(
            "With --renderer shader{}: the folder of the shader renderer's files, a copy of shaders/. "
            "Default: the files that the program was built with.",
            orElse),
        {.value = "DIR", .environment = "TEXPLORER_SHADERS"});
    addContextArgument(command, argument.context);
    command.option("--pretend", argument.pretended, view::pretenceHelp(),
                   {.value = "WORDS", .oneEach = true, .offers = {view::pretenceWords, true}});
}

Result<std::vector<RendererKind>> parseRenderers(std::string_view text, const char* option) {
    return parseEach(text, option,
                     [option](std::string_view each) { return parseChoice<RendererKind>(each, option); });
}

Result<void> putContext(const RendererArgument& argument, ShotRequest& request) {
    const Result<view::Pretence> pretence = view::Pretence::parse(argument.pretended);
    if (!pretence)
        return fail(pretence.error());
    const Result<view::ContextChoice> context = parseContext(argument.context);
    if (!context)
        return fail(context.error());
    request.pretence = *pretence;
    request.context = *context;
    request.shaders = argument.shaders;
    return {};
}

void noteRendererUse(const RendererArgument& argument, std::span<const RendererKind> renderers,
                     const std::string& orElse) {
    if (argument.shadersOption->isGiven() &&
        std::ranges::find(renderers, RendererKind::Shader) == renderers.end())
        noteUnused("--shaders", "it needs --renderer shader" + orElse);
    const bool asksOpenGl = std::ranges::any_of(
        renderers, [](RendererKind renderer) { return renderer != RendererKind::Reference; });
    const Result<view::Pretence> pretence = view::Pretence::parse(argument.pretended);
    if (!argument.pretended.empty() && !asksOpenGl && !(pretence && pretence->limitsTextures()))
        noteUnused("--pretend", "it concerns OpenGL's driver, which the reference doesn't use");
    if (argument.context.option->isGiven() && !asksOpenGl)
        noteUnused("--context", "it concerns OpenGL, which the reference doesn't use");
}

} // namespace texplorer::screenshot
