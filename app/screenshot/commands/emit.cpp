// A scene as a program.

#include "app/screenshot/arguments/choice_argument.h"
#include "app/screenshot/output/output.h"
#include "app/screenshot/reports/program_text.h"

#include <fmt/core.h>

namespace texplorer::screenshot {
namespace {

struct EmitOptions {
    SceneArgument scene;
    std::string out = "-";
    std::string flavour{rowOf(emit::Flavour::Fixed).name};
};

ExitCode emitProgram(const EmitOptions& options) {
    const Result<emit::Flavour> flavour = parseChoice<emit::Flavour>(options.flavour, "--as");
    if (!flavour)
        return complain(flavour.error(), wrongCall);
    if (const Result<void> apart = checkOutputsApart({{"--out", options.out}}, {options.scene.file}); !apart)
        return complain(apart.error(), wrongCall);
    const Result<Output> out = Output::open(options.out);
    if (!out)
        return complain(out.error());
    emit::ProgramOptions asked;
    asked.title.clear();
    if (!isStandardOutput(options.out))
        asked.source = options.out;
    const auto lines = programOf(options.scene, *flavour, std::move(asked));
    if (!lines)
        return complain(lines.error().error, lines.error().code);
    const std::string text = textOf(*lines, false);
    const Result<void> written = out->write(std::as_bytes(std::span(text)));
    return written ? success : complain(written.error());
}

} // namespace

void addEmit(CommandLine& line) {
    Command& command = line.command("emit", "A scene as a program, which a C compiler takes as it is.");
    auto options = std::make_shared<EmitOptions>();
    addSceneOrLessonArgument(command, options->scene);
    command.option("--as", options->flavour, "What it is written for." + explainChoices<emit::Flavour>(),
                   {.value = "FLAVOUR", .showsDefault = true, .offers = {choiceNames<emit::Flavour>}});
    command.option("-o,--out", options->out, "The file to write; - for standard output.",
                   {.value = "FILE", .showsDefault = true});
    command.footer(
        "One file that needs GLFW and OpenGL; the line that compiles it stands at its top. It draws the pixels of "
        "\"texshot shot\", moves as the scene does and turns by the mouse. Patterns of few lines are computed; the "
        "texels of other images, and meshes of many vertices, are arrays at its end. With --lesson the step's text "
        "stands at the top, and the calls that it is about have a word on what they do.\n"
        "The shaders of glsl and webgl are those of the GLSL tab. A page of webgl needs no other file, and its pixels are "
        "the browser's. What OpenGL 3.3 or WebGL 2 has no word for is named in one sentence, and nothing is written.\n"
        "Exit status: 0 done, 1 the scene, an image or what the flavour can't say, 2 a wrong call.");
    command.onCall([options] { return emitProgram(*options); });
}

} // namespace texplorer::screenshot
