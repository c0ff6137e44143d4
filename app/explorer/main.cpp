// texplorer: the window.

#include "app/command_line/command_line.h"
#include "app/command_line/standard_streams.h"
#include "app/explorer/loop.h"
#include "app/explorer/window.h"
#include "app/ui/model/scene_files.h"
#include "app/view/pretence.h"
#include "core/base/thrown.h"
#include "core/lesson/lesson_files.h"
#include "core/text/printable.h"
#include "core/texture/image_budget.h"

#include <fmt/core.h>

#include <cstdio>
#include <exception>
#include <new>

namespace {

using namespace texplorer;

constexpr int failure = 1;
constexpr int wrongCall = 2;
constexpr view::Size startSize{1280, 800}; // at a content scale of 1

constexpr const char* withoutWindow =
    "texshot draws the same window without a display: texshot shot --ui -o window.png";

int complain(const std::string& sentence) {
    std::fprintf(stderr, "texplorer: %s\n", printable(sentence).c_str());
    return failure;
}

/// The options of a call, in addition to its files.
struct Wanted {
    std::string lesson;
    std::string shaders;
    view::Pretence pretence{};
    explorer::ContextApi context{};
};

/// Parses "native" or "egl".
Result<explorer::ContextApi> parseContext(const std::string& word) {
    if (word == "native")
        return explorer::ContextApi::Native;
    if (word == "egl")
        return explorer::ContextApi::Egl;
    return fail(ErrorCode::OutOfRange,
                word == "osmesa" ? "OSMesa draws into memory without a window: use texshot --context osmesa"
                                 : fmt::format("expected native or egl, found \"{}\"", word),
                "--context");
}

int show(explorer::Signals& signals, const std::vector<std::filesystem::path>& paths, const Wanted& wanted) {
    const std::string title = ui::windowTitle({defaultScene(), ImageSource{}});
    Result<explorer::Window> window = explorer::Window::open(startSize, title, wanted.context);
    if (!window)
        return complain(describe(window.error()) + "; " + withoutWindow);
    const Result<void> ended =
        explorer::runLoop(*window, signals, paths, wanted.lesson, wanted.shaders, wanted.pretence);
    if (!ended)
        return complain(describe(ended.error()) + "; " + withoutWindow);
    return 0;
}

int run(const std::vector<std::string>& files, const Wanted& wanted) {
    const std::vector<std::filesystem::path> paths(files.begin(), files.end());
    const std::vector<Error> refused = ui::checkArguments(paths);
    for (const Error& each : refused)
        complain(describe(each));
    if (!paths.empty() && refused.size() == paths.size())
        return failure;
    explorer::Signals signals; // before any other thread starts
    const int status = show(signals, paths, wanted);
    if (signals.received() != 0)
        explorer::endBy(signals.received());
    return status;
}

} // namespace

int main(int argc, char** argv) {
    prepareStandardStreams();
    sayWhatNothingCatches("texplorer");
    CommandLine line("texplorer", TEXPLORER_VERSION,
                     "Explore what each texture parameter of OpenGL does, on a live cube and sphere.");
    std::vector<std::string> files;
    line.option(
        "FILE", files,
        "Scene files (JSON) and images. Images become textures of the scene, and the first one is shown. A "
        "PNG drawn by texshot contains its scene; if it is the only file, the window asks whether to open "
        "the scene or the image.");
    line.footer(fmt::format(
        "Files that can't be opened are listed, and the others are opened.\n"
        "The decoded images of a scene may take {} together.\n"
        "Unsaved work is stored in $XDG_STATE_HOME/texplorer/unsaved (~/.local/state/texplorer/unsaved) "
        "and offered at the next start.\n"
        "Settings are stored in $XDG_CONFIG_HOME/texplorer/settings.json "
        "(~/.config/texplorer/settings.json), and recent files in $XDG_STATE_HOME/texplorer/recent.json.\n"
        "If the driver has only a core profile, without fixed functions, the reference renderer draws.\n"
        "Exit status: 0 the window was closed, 1 it could not be opened, 2 invalid arguments; a signal "
        "ends it as usual, with the unsaved work stored.",
        sceneImageBytesText()));
    Wanted wanted;
    line.option(
        "--shaders", wanted.shaders,
        "The folder of the shader renderer's files, a copy of shaders/. Changes there are drawn at once. "
        "Default: the files that the program was built with.",
        {.value = "DIR", .environment = "TEXPLORER_SHADERS"});
    line.option("--lesson", wanted.lesson,
                "Opens a lesson, by its name (\"texshot lessons\" lists them) or its folder.",
                {.value = "NAME", .offers = {lesson::builtInLessons}});
    std::vector<std::string> pretended;
    line.option("--pretend", pretended, view::pretenceHelp(),
                {.value = "WORDS", .oneEach = true, .offers = {view::pretenceWords, true}});
    std::string context = "native";
    line.option(
        "--context", context,
        "How the window creates its OpenGL context. native: GLX on X11, EGL on Wayland. egl: EGL on both.",
        {.value = "CONTEXT", .showsDefault = true, .offers = {[] {
                                                       return std::vector<std::string>{"native", "egl"};
                                                   }}});
    line.addWords();
    try {
        const Result<std::optional<std::string>> answer = line.parse(argc, argv);
        if (!answer) {
            complain(describe(answer.error()));
            return wrongCall;
        }
        if (!*answer) {
            const Result<view::Pretence> pretence = view::Pretence::parse(pretended);
            const Result<explorer::ContextApi> api = parseContext(context);
            if (!pretence || !api) {
                complain(describe(pretence ? api.error() : pretence.error()));
                return wrongCall;
            }
            wanted.pretence = *pretence;
            wanted.context = *api;
            return run(files, wanted);
        }
        const Result<void> printed = writeStandardOutput(viewBytes(**answer));
        return printed ? 0 : complain(describe(printed.error()));
    } catch (const std::bad_alloc&) {
        return complain("not enough memory");
    } catch (const std::exception& error) { // reported as one sentence and an exit status
        return complain(reasonOf(error));
    }
}
