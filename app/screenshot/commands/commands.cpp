#include "app/screenshot/arguments/scene_argument.h"
#include "app/screenshot/output/json_text.h"
#include "core/emit/program.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <sstream>

namespace texplorer::screenshot {
namespace {

struct CallsOptions {
    SceneArgument scene;
    bool all = false;
    bool json = false;
};

/// A line each, as C has it.
std::string callsJson(const std::string& text) {
    nlohmann::ordered_json lines = nlohmann::ordered_json::array();
    std::istringstream words(text);
    for (std::string line; std::getline(words, line);)
        lines.push_back(line);
    return documentText({{"language", "C99"}, {"lines", std::move(lines)}});
}

ExitCode commands(const CallsOptions& options) {
    auto opened = openScene(options.scene);
    if (!opened)
        return complain(opened.error().error, opened.error().code);
    if (const Result<void> loaded = opened->images.load(opened->scene); !loaded)
        return complain(inScene(options.scene, loaded.error()));
    emit::TextureCodes codes;
    const auto lines = emit::fixedProgram(opened->scene, opened->images, {}, codes);
    if (!lines)
        return complain(lines.error());
    const std::string text = textOf(*lines, options.all);
    const Result<void> printed = print(options.json ? callsJson(text) : text);
    return printed ? success : complain(printed.error());
}

} // namespace

void addCommands(CommandLine& line) {
    Command& command = line.command("commands", "The OpenGL calls that draw a scene, in C.");
    auto options = std::make_shared<CallsOptions>();
    addSceneOrLessonArgument(command, options->scene);
    command.flag("--all", options->all,
                 "All calls; without it only those that change what OpenGL starts with.");
    command.flag("--json", options->json, "As JSON, for programs: \"language\" and \"lines\".");
    command.footer(
        "The body of a C99 function on standard output, for <GL/gl.h>, <GL/glext.h> and <GL/glu.h> with "
        "GL_GLEXT_PROTOTYPES, in a context with OpenGL's initial state. What doesn't fit into a text, texels and "
        "meshes of many vertices, is declared as extern arrays.\n"
        "Neither OpenGL nor the images of the scene are looked at.\n"
        "Exit status: 0 done, 1 the scene can't be read, 2 a wrong call.");
    command.onCall([options] { return commands(*options); });
}

} // namespace texplorer::screenshot
