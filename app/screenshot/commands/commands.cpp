#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/output/json_text.h"
#include "app/screenshot/reports/program_text.h"

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
    return documentText(nlohmann::ordered_json::array({{{"language", "C99"}, {"lines", std::move(lines)}}}));
}

ExitCode commands(const CallsOptions& options) {
    const auto program = programOf(options.scene, emit::Flavour::Fixed, {.title = ""});
    if (!program)
        return complain(program.error().error, program.error().code);
    const std::string text = textOf(program->lines, options.all);
    const Result<void> printed = print(options.json ? callsJson(text) : text);
    return printed ? success : complain(printed.error());
}

} // namespace

void addCommands(CommandLine& line) {
    Command& command = line.command("commands", "The OpenGL calls that draw a scene, as a program in C.");
    auto options = std::make_shared<CallsOptions>();
    addSceneOrLessonArgument(command, options->scene);
    command.flag("--all", options->all, "All calls. Default: only those that change OpenGL's initial state.");
    command.flag("--json", options->json, "As JSON, for programs: language and lines.");
    command.footer("The program of \"texshot emit\" on standard output, as in the window's Commands tab.\n"
                   "Exit status: 0 done, 1 the scene or an image can't be read, 2 invalid arguments.");
    command.onCall([options] { return commands(*options); });
}

} // namespace texplorer::screenshot
