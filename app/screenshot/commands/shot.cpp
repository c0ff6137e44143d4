#include "app/screenshot/arguments/choice_argument.h"
#include "app/screenshot/arguments/context_argument.h"
#include "app/screenshot/arguments/option_use.h"
#include "app/screenshot/arguments/picture_argument.h"
#include "app/screenshot/arguments/scene_argument.h"
#include "app/screenshot/arguments/window_argument.h"
#include "app/screenshot/command.h"
#include "app/screenshot/gl/gl_module.h"
#include "app/screenshot/output/output.h"
#include "app/screenshot/shots/shot_list.h"
#include "app/screenshot/shots/shot_run.h"
#include "app/ui/window/smallest_window.h"
#include "core/base/file_io.h"
#include "core/reference/false_colors.h"

#include <fmt/core.h>

#include <filesystem>
#include <optional>
#include <set>
#include <utility>

namespace texplorer::screenshot {
namespace {

using reference::AnisotropyMethod;

struct ShotOptions {
    std::vector<std::string> files; ///< of scenes; none: the default scene
    SceneArgument scene;            ///< what is changed in each of them, or a lesson
    std::vector<std::string> axes;
    PictureArgument picture;
    ContextArgument context;
    bool window = false;
    WindowArgument shownWindow;
    std::string renderer = std::string(rowOf(RendererKind::Fixed).name);
    std::string shown = std::string(rowOf(reference::Shown::Picture).name);
    reference::LevelQuestion shownUnit;
    std::string shaders;
    std::vector<std::string> pretended;
    std::string out;
    bool withoutMetadata = false;
    bool json = false;
    const Option* rendererOption = nullptr;
    const Option* shownOption = nullptr;
    const Option* shadersOption = nullptr;
};

/// What the call says of every picture. The error is a wrong call.
Result<ShotRequest> requestOf(const ShotOptions& options) {
    ShotRequest request;
    request.window = options.window;
    if (const Result<void> window = putWindow(options.shownWindow, request); !window)
        return fail(window.error());
    const Result<RendererKind> renderer = parseChoice<RendererKind>(options.renderer, "--renderer");
    if (!renderer)
        return fail(renderer.error());
    const Result<AnisotropyMethod> anisotropy = parseAnisotropy(options.picture.anisotropy);
    if (!anisotropy)
        return fail(anisotropy.error());
    const Result<view::Pretence> pretence = view::Pretence::parse(options.pretended);
    if (!pretence)
        return fail(pretence.error());
    const Result<view::ContextChoice> context = parseContext(options.context);
    if (!context)
        return fail(context.error());
    const Result<reference::Shown> shown = parseChoice<reference::Shown>(options.shown, "--show");
    if (!shown)
        return fail(shown.error());
    request.renderer = *renderer;
    request.anisotropy = *anisotropy;
    request.pretence = *pretence;
    request.context = *context;
    request.shown = *shown;
    request.shownUnit = options.shownUnit;
    request.shaders = options.shaders;
    request.lesson = options.scene.lesson;
    request.lessonStep = options.scene.step - 1;
    request.levels.cache = BlockCache::ofUser();
    return request;
}

/// An option that changes nothing in this call.
Result<void> checkUse(const ShotOptions& options, const ShotRequest& request) {
    const auto unused = [](const char* option, const char* why) {
        return fail(ErrorCode::OutOfRange, fmt::format("has no effect here: {}", why), option);
    };
    const bool reference = request.renderer == RendererKind::Reference;
    if (options.picture.anisotropyOption->isGiven() && !request.window && !reference)
        return unused("--anisotropy", "OpenGL's driver decides, only the reference has a choice");
    if (options.shadersOption->isGiven() && !request.window && request.renderer != RendererKind::Shader)
        return unused("--shaders", "it is for --renderer shader and --ui");
    if (!options.pretended.empty() && !request.window && reference)
        return unused("--pretend", "it is about OpenGL's driver, which the reference doesn't ask");
    if (options.context.option->isGiven() && !request.window && reference)
        return unused("--context", "it is about OpenGL, which the reference doesn't ask");
    if (options.rendererOption->isGiven() && !request.compared.empty())
        return unused("--renderer", "--compare names the renderers");
    if (options.shownOption->isGiven() && !request.window && !reference)
        return unused("--show", "it is for --renderer reference and --ui");
    return {};
}

ExitCode shootOne(const ShotOptions& options, const std::string& name, ShotRequest request,
                  ShotReport* report) {
    const auto output = openImageOutput(name, "PNG");
    if (!output)
        return output.error();
    if (options.withoutMetadata && output->format->name != "PNG")
        return refuseUnused("--no-metadata", "it is for PNG files");
    SceneArgument argument = options.scene;
    if (!options.files.empty())
        argument.file = options.files.front();
    auto opened = openScene(argument);
    if (!opened)
        return complain(opened.error().error, opened.error().code);
    request.scene = std::move(opened->scene);
    request.images = std::move(opened->images);
    request.file = argument.path();
    return drawOne(std::move(request), argument, *output, !options.withoutMetadata, report);
}

/// "{scene}" in the names of pictures.
std::string sceneNameOf(const SceneArgument& scene, const std::string& file) {
    if (!scene.example.empty())
        return scene.example;
    if (scene.lesson.empty())
        return sceneName(file);
    return fmt::format("{}-{}", std::filesystem::path(scene.lesson).filename().string(), scene.step);
}

/// The scenes that can be read, with their axes; the others' sentences are said. The error is the exit status
/// of a wrong call.
tl::expected<std::vector<ShotList::Entry>, ExitCode> entriesOf(const ShotOptions& options,
                                                               ShotReport* report) {
    std::vector<ShotList::Entry> entries;
    std::vector<std::string> files = options.files;
    if (files.empty())
        files.emplace_back();
    for (const std::string& file : files) {
        SceneArgument argument = options.scene;
        argument.file = file;
        auto opened = openScene(argument);
        if (!opened && opened.error().code == wrongCall)
            return tl::unexpected(complain(inScene(argument, opened.error().error), wrongCall));
        if (!opened) {
            complain(opened.error().error);
            if (report != nullptr)
                report->addUnread(file, opened.error().error);
            continue;
        }
        ShotList::Entry entry{sceneNameOf(options.scene, file), file, *std::move(opened)};
        for (const std::string& text : options.axes) {
            Result<SweepAxis> axis = parseSweepAxis(entry.opened.scene, text);
            if (!axis)
                return tl::unexpected(complain(inScene(argument, axis.error()), wrongCall));
            if (std::ranges::find(entry.axes, axis->path, &SweepAxis::path) != entry.axes.end())
                return tl::unexpected(
                    complain({ErrorCode::OutOfRange,
                              fmt::format("expected each axis once, found {} twice", axis->path), "--axis"},
                             wrongCall));
            entry.axes.push_back(*std::move(axis));
        }
        entries.push_back(std::move(entry));
    }
    return entries;
}

/// Each folder once: what else a name may be is seen when it is written. `makes`: those that aren't there.
Result<void> checkFolders(const std::vector<std::string>& names, bool makes) {
    std::set<std::filesystem::path> folders;
    for (const std::string& name : names) {
        const std::filesystem::path folder = std::filesystem::path(name).parent_path();
        if (!folders.insert(folder).second)
            continue;
        if (std::error_code error; makes && !folder.empty()) {
            std::filesystem::create_directories(folder, error);
            if (error)
                return fail(ErrorCode::Unwritable, "can't make the folder: " + error.message(),
                            folder.string());
        }
        if (const Result<void> writable = checkPlace(name); !writable)
            return fail(writable.error());
    }
    return {};
}

/// What to call several pictures: "{minFilter}.png".
std::string nameForSeveral(const ShotOptions& options) {
    if (options.axes.empty())
        return "{scene}.png";
    const std::string path = options.axes.front().substr(0, options.axes.front().find('='));
    return fmt::format("{{{}}}.png", path.substr(path.rfind('.') + 1));
}

ExitCode shootAll(const ShotOptions& options, const NamePattern& pattern, std::vector<view::Size> sizes,
                  std::vector<double> times, ShotRequest request, ShotReport* report) {
    const bool several = options.files.size() > 1 || sizes.size() > 1 || times.size() > 1;
    const bool toStream = isStandardOutput(options.out) && !options.axes.empty();
    if ((several || toStream) && pattern.places().empty())
        return complain({ErrorCode::OutOfRange,
                         fmt::format("expected a name that differs for each picture, as in {} or "
                                     "{{number}}.png, found \"{}\"",
                                     nameForSeveral(options), options.out),
                         "--out"},
                        wrongCall);
    const Result<const CodecRow*> format = imageFormatOf(options.out, {});
    if (!format)
        return complain(format.error(), wrongCall);
    if (options.withoutMetadata && (*format)->name != "PNG")
        return refuseUnused("--no-metadata", "it is for PNG files");
    auto entries = entriesOf(options, report);
    if (!entries)
        return entries.error();
    if (entries->empty()) {
        if (report != nullptr)
            report->finish();
        return failure;
    }
    const bool incomplete = entries->size() < std::max<std::size_t>(1, options.files.size());
    const ShotList list(*std::move(entries), std::move(sizes), std::move(times));
    Result<std::vector<std::string>> names = list.names(pattern, std::string(rowOf(request.renderer).name));
    if (!names)
        return complain(names.error(), wrongCall);
    if (const Result<void> writable = checkFolders(*names, !pattern.places().empty()); !writable)
        return complain(writable.error());
    return drawAll(
        {list, *std::move(names), *format, std::move(request), !options.withoutMetadata, report, incomplete});
}

ExitCode shoot(const ShotOptions& options, ShotReport* report) {
    Result<std::vector<view::Size>> sizes =
        parsePictureSizes(options.picture.size, options.window ? ui::smallestWindow : view::Size{1, 1});
    if (!sizes)
        return complain(sizes.error(), wrongCall);
    Result<std::vector<double>> times = parseTimes(options.picture.time);
    if (!times)
        return complain(times.error(), wrongCall);
    Result<ShotRequest> request = requestOf(options);
    if (!request)
        return complain(request.error(), wrongCall);
    if (const Result<void> used = checkUse(options, *request); !used)
        return complain(used.error(), wrongCall);
    const Result<NamePattern> pattern = NamePattern::parse(options.out);
    if (!pattern)
        return complain({pattern.error().code, pattern.error().message, "--out"}, wrongCall);
    const bool many = options.files.size() > 1 || !options.axes.empty() || sizes->size() > 1 ||
                      times->size() > 1 || !pattern->places().empty();
    if (many)
        return shootAll(options, *pattern, *std::move(sizes), *std::move(times), *std::move(request), report);
    request->size = sizes->front();
    request->time = times->front();
    const auto noPlaces = [](const std::string& /*place*/) { return std::string(); };
    return shootOne(options, pattern->fill(noPlaces), *std::move(request), report);
}

/// With --json what was drawn is told, even if a part of it couldn't be.
ExitCode shootAndTell(const ShotOptions& options) {
    if (!options.json)
        return shoot(options, nullptr);
    if (isStandardOutput(options.out))
        return complain(
            {ErrorCode::OutOfRange, "standard output takes the picture or the JSON, not both", "--json"},
            wrongCall);
    ShotReport report;
    const ExitCode status = shoot(options, &report);
    if (!report.isFinished())
        return status;
    const Result<void> printed = print(report.json());
    return printed ? status : complain(printed.error());
}

} // namespace

void addShot(CommandLine& line) {
    Command& command = line.command("shot", "Draw scenes into pictures.");
    auto options = std::make_shared<ShotOptions>();
    addSceneOrLessonArgument(command, options->scene, &options->files);
    command.option(
        "--axis", options->axes,
        "A parameter and values that it goes through, as in 'textures[0].minFilter=*': a picture for "
        "each, and for each combination where this is given again. V1,V2 are values (of vectors "
        "and colours with ; between them), A..B/N are N numbers, * is every choice.",
        {.value = "PATH=VALUES", .oneEach = true, .offers = {.assigned = assignedParams}});
    addPictureArgument(command, options->picture, Several::Yes);
    const Option& window = command.flag("--ui", options->window, "Draw the whole window with its panels.");
    addWindowArgument(command, window, options->shownWindow);
    options->rendererOption =
        &command.option("--renderer", options->renderer,
                        fmt::format("The renderer that draws the scene, one of {}.",
                                    listNames(EnumTable<RendererKind>::rows)),
                        {.value = "RENDERER", .showsDefault = true, .offers = {choiceNames<RendererKind>}});
    options->shownOption = &command.option(
        "--show", options->shown,
        fmt::format(
            "With --renderer reference or --ui: the picture, or of one texture unit a number for each "
            "pixel in false colours, one of {}. lambda: the level of detail, from dark violet at the "
            "base level to yellow at the last one, black at 0 and below. anisotropy: how many times as "
            "long as wide the footprint is, from 1, dark violet, in equal steps to 2, 4, 8 and 16, "
            "yellow. Transparent where the unit samples nothing.",
            listNames(EnumTable<reference::Shown>::rows)),
        {.value = "WHAT", .showsDefault = true, .offers = {choiceNames<reference::Shown>}});
    command.number("--pass", options->shownUnit.pass, 0, maxPasses - 1, "With --show: the pass.",
                   {.needs = options->shownOption});
    command.number("--unit", options->shownUnit.unit, 0, maxUnits - 1, "With --show: its texture unit.",
                   {.needs = options->shownOption});
    options->shadersOption =
        &command.option("--shaders", options->shaders,
                        "With --renderer shader or --ui: the folder of the shader renderer's files, a copy "
                        "of shaders/. Without it: those that the program was built with.",
                        {.value = "DIR", .environment = "TEXPLORER_SHADERS"});
    addContextArgument(command, options->context);
    command.option("--pretend", options->pretended, view::pretenceHelp(),
                   {.value = "WORDS", .oneEach = true, .offers = {view::pretenceWords, true}});
    command.flag(
        "--no-metadata", options->withoutMetadata,
        "Write no texts into a PNG, which say the program, the renderer, the driver, time, size and the "
        "complete scene: files of two drivers are the same bytes where their pixels are.");
    command.option(
        "-o,--out", options->out,
        fmt::format("The picture to write, its format by its extension: {}; - for standard output, as PNG. "
                    "Of several pictures a name with places to fill in: {{scene}}, {{number}}, {{renderer}}, "
                    "{{time}}, {{size}} and the axes' paths or their last parts, as in "
                    "'out/{{scene}}-{{minFilter}}.png', whose folder is made; {{{{ is a brace.",
                    writtenExtensions(" or ")),
        {.value = "FILE", .required = true});
    command.flag("--json", options->json,
                 "Print what was drawn as JSON, for programs: of each picture file, scene, axes, size, time, "
                 "renderer, driver, context and warnings, or its error.");
    command.footer(fmt::format(
        "One call draws at most {} pictures. A scene that can't be read or drawn gets its sentence, and the "
        "others go on; a file that can't be written ends it.\n"
        "Exit status: 0 done, 1 a picture couldn't be drawn or written, 2 a wrong call, 130 Ctrl+C: what was "
        "written by then is whole.",
        maxShots));
    command.onCall([options] { return shootAndTell(*options); });
}

} // namespace texplorer::screenshot
