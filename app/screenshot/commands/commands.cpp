#include "app/screenshot/arguments/scene_argument.h"
#include "core/emit/emit.h"

#include <fmt/core.h>

namespace texplorer::screenshot {
namespace {

struct CallsOptions {
    SceneArgument scene;
    bool all = false;
};

ExitCode commands(const CallsOptions& options) {
    const auto opened = openScene(options.scene);
    if (!opened)
        return complain(opened.error().error, opened.error().code);
    const Result<void> printed = print(textOf(emit::callsOf(opened->scene), options.all));
    return printed ? success : complain(printed.error());
}

} // namespace

void addCommands(CommandLine& line) {
    Command& command = line.command("commands", "The OpenGL calls that draw a scene, in C.");
    auto options = std::make_shared<CallsOptions>();
    addSceneOrLessonArgument(command, options->scene);
    command.flag("--all", options->all,
                 "All calls; without it only those that change what OpenGL starts with.");
    command.footer(
        "The body of a C99 function on standard output, for <GL/gl.h>, <GL/glext.h> and <GL/glu.h> with "
        "GL_GLEXT_PROTOTYPES, in a context with OpenGL's initial state. What doesn't fit into a text, texels and "
        "meshes of many vertices, is declared as extern arrays.\n"
        "Neither OpenGL nor the images of the scene are looked at.\n"
        "Exit status: 0 done, 1 the scene can't be read, 2 a wrong call.");
    command.onCall([options] { return commands(*options); });
}

} // namespace texplorer::screenshot
