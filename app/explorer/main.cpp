// texplorer: the window.

#include "app/command_line/choice_argument.h"
#include "app/command_line/command_line.h"
#include "app/command_line/standard_streams.h"
#include "app/explorer/loop.h"
#include "app/explorer/window.h"
#include "app/ui/files/scene_files.h"
#include "app/view/pretence.h"
#include "texplorer/base/thrown.h"
#include "texplorer/lesson/lesson_files.h"
#include "texplorer/texture/image_budget.h"

#include <fmt/core.h>

#include <charconv>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <system_error>

namespace {

using namespace texplorer;

constexpr int failure = 1;
constexpr int wrongCall = 2;
constexpr view::Size startSize{1280, 800}; // at a content scale of 1

constexpr const char* frameVariable = "TEXPLORER_FRAME_SECONDS";
constexpr const char* withoutWindow =
    N_("texshot draws the same window without a display: texshot shot --ui -o window.png");

int complain(const std::string& sentence) {
    texplorer::complain("texplorer", sentence);
    return failure;
}

/// The words of a call.
struct Words {
    std::vector<std::string> files;
    std::string lesson;
    std::string renderer; ///< empty: the best one
    std::string shaders;
    std::vector<std::string> pretended;
    std::string context = "native";
};

/// What they mean.
struct Wanted {
    explorer::Beginning beginning;
    explorer::ContextApi context{};
    double frameSeconds = explorer::FrameWatch::usualSeconds;
    std::string program;               ///< how it was called
    std::vector<std::string> repeated; ///< the options of a program that starts again: see explorer::Restart
};

/// Parses "native" or "egl".
Result<explorer::ContextApi> parseContext(const std::string& word) {
    if (word == "native")
        return explorer::ContextApi::Native;
    if (word == "egl")
        return explorer::ContextApi::Egl;
    return fail(ErrorCode::OutOfRange,
                word == "osmesa"
                    ? N_("OSMesa draws into memory without a window: use texshot --context osmesa")
                    : Sentence("expected native or egl, found \"{0}\"", word),
                atOption("--context"));
}

/// Parses the time in which a frame must be drawn.
Result<double> parseFrameSeconds() {
    const char* text = std::getenv(frameVariable); // NOLINT(concurrency-mt-unsafe): no other thread runs yet
    if (!text)
        return explorer::FrameWatch::usualSeconds;
    constexpr double most = 3600;
    double seconds = 0;
    const char* end = text + std::strlen(text);
    const auto [stop, error] = std::from_chars(text, end, seconds);
    if (error == std::errc() && stop == end && seconds >= 0 && seconds <= most)
        return seconds;
    return fail(ErrorCode::OutOfRange, Sentence("expected seconds from 0 to {0}, found \"{1}\"", most, text),
                atName(frameVariable));
}

/// Parses the name of a renderer.
Result<std::optional<RendererKind>> parseRenderer(const std::string& name) {
    if (name.empty())
        return std::nullopt;
    const Result<RendererKind> kind = parseChoice<RendererKind>(name, "--renderer");
    return kind ? Result<std::optional<RendererKind>>(*kind) : fail(kind.error());
}

std::vector<std::string> repeatedOf(const Words& words) {
    std::vector<std::string> repeated{"--context", words.context};
    for (const std::string& each : words.pretended)
        repeated.insert(repeated.end(), {"--pretend", each});
    if (!words.shaders.empty())
        repeated.insert(repeated.end(), {"--shaders", words.shaders});
    return repeated;
}

/// The error is a wrong call.
Result<Wanted> wantedOf(const Words& words) {
    const Result<view::Pretence> pretence = view::Pretence::parse(words.pretended);
    if (!pretence)
        return fail(pretence.error());
    const Result<explorer::ContextApi> context = parseContext(words.context);
    if (!context)
        return fail(context.error());
    const Result<std::optional<RendererKind>> renderer = parseRenderer(words.renderer);
    if (!renderer)
        return fail(renderer.error());
    const Result<double> frameSeconds = parseFrameSeconds();
    if (!frameSeconds)
        return fail(frameSeconds.error());
    explorer::Beginning beginning{
        {words.files.begin(), words.files.end()}, words.lesson, words.shaders, *pretence, *renderer,
        explorer::Restart::takeReason()};
    return Wanted{std::move(beginning), *context, *frameSeconds, {}, repeatedOf(words)};
}

int show(explorer::Signals& signals, const Wanted& wanted) {
    explorer::Restart restart(signals, wanted.program, wanted.repeated);
    restart.note({explorer::argumentsOf(wanted.beginning),
                  !wanted.beginning.hungFor && wanted.beginning.renderer != RendererKind::Reference});
    explorer::FrameWatch watch(signals, wanted.frameSeconds);
    watch.whenHanging([&restart](double seconds) { restart.run(seconds); });
    const std::string title = ui::windowTitle({defaultScene(), ImageSource{}});
    Result<explorer::Window> window = explorer::Window::open(startSize, title, wanted.context);
    if (!window)
        return complain(describe(window.error()).english() + "; " + withoutWindow);
    const Result<void> ended = explorer::runLoop({*window, signals, watch, restart}, wanted.beginning);
    if (!ended)
        return complain(describe(ended.error()).english() + "; " + withoutWindow);
    return 0;
}

int run(const Wanted& wanted) {
    const std::vector<std::filesystem::path>& paths = wanted.beginning.files;
    const std::vector<Error> refused = ui::checkArguments(paths);
    for (const Error& each : refused)
        complain(describe(each));
    if (!paths.empty() && refused.size() == paths.size())
        return failure;
    explorer::Signals signals; // before any other thread starts
    const int status = show(signals, wanted);
    if (signals.received() != 0)
        explorer::endBy(signals.received());
    return status;
}

void describeProgram(CommandLine& line) {
    line.footer(fmt::format(
        "Files that can't be opened are listed, and the others are opened.\n"
        "The decoded images of a scene may take {} together.\n"
        "Unsaved work is stored in $XDG_STATE_HOME/texplorer/unsaved (~/.local/state/texplorer/unsaved) "
        "and offered at the next start.\n"
        "Settings are stored in $XDG_CONFIG_HOME/texplorer/settings.json "
        "(~/.config/texplorer/settings.json), and recent files in $XDG_STATE_HOME/texplorer/recent.json.\n"
        "If the driver has only a core profile, without fixed functions, the reference renderer draws.\n"
        "If the driver does not finish a picture within $TEXPLORER_FRAME_SECONDS (default {:g}, 0: no limit; "
        "{:g} times as long for the first one), the window starts again, the reference renderer draws, and "
        "unsaved work is offered.\n"
        "Exit status: 0 the window was closed, 1 it could not be opened or the driver did not finish a "
        "picture, 2 invalid arguments; a signal ends it as usual, with the unsaved work stored.",
        sceneImageBytesText(), explorer::FrameWatch::usualSeconds, explorer::FrameWatch::firstFactor));
}

void declareOptions(CommandLine& line, Words& words) {
    line.option(
        "FILE", words.files,
        N_("Scene files (JSON), OBJ files and images. Images become textures of the scene, and the first one "
           "is shown. The models of an OBJ file become a scene. A PNG drawn by texshot contains its scene; if "
           "it is the only file, the window asks whether to open the scene or the image."));
    line.option("--renderer", words.renderer,
                fmt::format("The renderer that the view begins with, one of {}. Default: the first one that "
                            "the driver has.",
                            listNames(EnumTable<RendererKind>::rows)),
                {.value = "RENDERER", .offers = {choiceNames<RendererKind>}});
    line.option(
        "--shaders", words.shaders,
        N_("The folder of the shader renderer's files, a copy of shaders/. Changes there are drawn at once. "
           "Default: the files that the program was built with."),
        {.value = "DIR", .environment = "TEXPLORER_SHADERS"});
    line.option("--lesson", words.lesson,
                N_("Opens a lesson, by its name (\"texshot lessons\" lists them) or its folder."),
                {.value = "NAME", .offers = {lesson::builtInLessons}});
    line.option("--pretend", words.pretended, view::pretenceHelp(),
                {.value = "WORDS", .oneEach = true, .offers = {view::pretenceWords, true}});
    line.option(
        "--context", words.context,
        N_("How the window creates its OpenGL context. native: GLX on X11, EGL on Wayland. egl: EGL on both."),
        {.value = "CONTEXT", .showsDefault = true, .offers = {[] {
                                                       return std::vector<std::string>{"native", "egl"};
                                                   }}});
    line.addWords();
}

} // namespace

int main(int argc, char** argv) {
    prepareStandardStreams();
    sayWhatNothingCatches("texplorer");
    CommandLine line("texplorer", TEXPLORER_VERSION,
                     N_("Explore what each texture parameter of OpenGL does, on a live cube and sphere."));
    Words words;
    declareOptions(line, words);
    describeProgram(line);
    try {
        const Result<std::optional<std::string>> answer = line.parse(argc, argv);
        if (!answer) {
            complain(describe(answer.error()));
            return wrongCall;
        }
        if (!*answer) {
            Result<Wanted> wanted = wantedOf(words);
            if (!wanted) {
                complain(describe(wanted.error()));
                return wrongCall;
            }
            wanted->program = argc > 0 ? argv[0] : "texplorer";
            return run(*wanted);
        }
        const Result<void> printed = writeStandardOutput(viewBytes(**answer));
        return printed ? 0 : complain(describe(printed.error()));
    } catch (const std::bad_alloc&) {
        return complain(N_("not enough memory"));
    } catch (const std::exception& error) { // reported as one sentence and an exit status
        return complain(reasonOf(error));
    }
}
