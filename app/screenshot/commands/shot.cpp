#include "app/command_line/choice_argument.h"
#include "app/screenshot/arguments/axes_argument.h"
#include "app/screenshot/arguments/option_use.h"
#include "app/screenshot/arguments/picture_argument.h"
#include "app/screenshot/arguments/request_argument.h"
#include "app/screenshot/arguments/window_argument.h"
#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/gl/gl_module.h"
#include "app/screenshot/output/output.h"
#include "app/screenshot/shots/shot_list.h"
#include "app/screenshot/shots/shot_run.h"
#include "app/ui/state/min_window_size.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/reference/false_colors.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

namespace texplorer::screenshot {
namespace {

struct ShotOptions {
    std::vector<std::string> files; ///< of scenes; none: the default scene
    SceneArgument scene;            ///< what is changed in each of them, or a lesson
    std::vector<std::string> axes;
    PictureArgument picture;
    RendererArgument renderer;
    bool window = false;
    WindowArgument shownWindow;
    std::string shown = std::string(rowOf(reference::Shown::Picture).name);
    reference::LevelQuestion shownUnit;
    std::string out;
    bool withoutMetadata = false;
    bool json = false;
    const Option* shownOption = nullptr;
};

constexpr const char* orWindow = " or --ui";

/// What the call says of every picture. The error is a wrong call.
Result<ShotRequest> requestOf(const ShotOptions& options) {
    ShotRequest request;
    request.window = options.window;
    if (const Result<void> window = putWindow(options.shownWindow, request); !window)
        return fail(window.error());
    if (const Result<void> context = putContext(options.renderer, request); !context)
        return fail(context.error());
    if (const Result<void> methods = putMethods(options.picture, request); !methods)
        return fail(methods.error());
    const Result<reference::Shown> shown = parseChoice<reference::Shown>(options.shown, "--show");
    if (!shown)
        return fail(shown.error());
    request.shown = *shown;
    request.shownUnit = options.shownUnit;
    request.lesson = options.scene.lesson;
    request.lessonStep = options.scene.step - 1;
    request.rendererIsGiven = options.renderer.rendererOption->isGiven();
    request.shownIsGiven = options.shownOption->isGiven();
    request.levels.cache = BlockCache::ofUser();
    return request;
}

/// What can't be shown as it is asked for is refused; an option that changes nothing gets a note.
Result<void> checkUse(const ShotOptions& options, const ShotRequest& request,
                      std::span<const RendererKind> renderers) {
    const auto isReference = [](RendererKind renderer) { return renderer == RendererKind::Reference; };
    if (options.shownOption->isGiven() && !request.window && !std::ranges::all_of(renderers, isReference))
        return fail(ErrorCode::OutOfRange, "requires --renderer reference or --ui", atOption("--show"));
    noteMethodsUse(options.picture, request.window || std::ranges::any_of(renderers, isReference));
    if (!request.window)
        noteRendererUse(options.renderer, renderers, orWindow);
    if (options.renderer.rendererOption->isGiven() && !request.compared.empty())
        noteUnused("--renderer", "--compare has the renderers");
    return {};
}

/// The texts of a PNG are left out of a format that has none anyway.
void noteMetadata(const ShotOptions& options, const CodecRow& format) {
    if (options.withoutMetadata && format.name != "PNG")
        noteUnused("--no-metadata", "it applies to PNG files only");
}

/// The scene that a request is about, as the driver that is pretended has it; the reference asks none.
SceneArgument sceneFor(const ShotOptions& options, const ShotRequest& request, const std::string& file) {
    SceneArgument argument = options.scene;
    argument.file = file;
    if (request.window || request.renderer != RendererKind::Reference)
        argument.units = request.pretence.facts().textureUnits;
    return argument;
}

/// The error: the scene lacks what --show is about.
Result<void> checkShown(const ShotOptions& options, const Scene& scene) {
    const auto pass = static_cast<std::size_t>(options.shownUnit.pass);
    if (pass == 0 || pass < scene.passes.size())
        return {};
    return fail(ErrorCode::OutOfRange,
                Sentence("there is no pass {0}, the scene has {1}", pass, scene.passes.size()),
                atOption("--pass"));
}

ExitCode shootOne(const ShotOptions& options, const std::string& name, ShotRequest request,
                  ShotReport* report) {
    const auto output = openImageOutput(name, "PNG");
    if (!output)
        return output.error();
    noteMetadata(options, *output->format);
    const SceneArgument argument =
        sceneFor(options, request, options.files.empty() ? std::string() : options.files.front());
    auto opened = openScene(argument);
    if (!opened)
        return complain(opened.error().error, opened.error().code);
    if (const Result<void> apart = checkPicturesApart({&name, 1}, argument, *opened, options.renderer);
        !apart)
        return complain(apart.error(), wrongCall);
    if (const Result<void> shown = checkShown(options, opened->scene); !shown)
        return complain(inScene(argument, shown.error()), wrongCall);
    request.scene = std::move(opened->scene);
    request.images = std::move(opened->images);
    request.file = argument.path();
    return drawOne(std::move(request), argument, *output, !options.withoutMetadata, report);
}

/// The scenes that can be read, with their axes; the others' sentences are said. The error is the exit status
/// of a wrong call.
tl::expected<std::vector<ShotList::Entry>, ExitCode> entriesOf(const ShotOptions& options,
                                                               const ShotRequest& request) {
    std::vector<ShotList::Entry> entries;
    std::vector<std::string> files = options.files;
    if (files.empty())
        files.emplace_back();
    for (const std::string& file : files) {
        const SceneArgument argument = sceneFor(options, request, file);
        auto opened = openScene(argument);
        if (!opened && opened.error().code == wrongCall)
            return tl::unexpected(complain(inScene(argument, opened.error().error), wrongCall));
        if (!opened) {
            complain(opened.error().error);
            continue;
        }
        if (const Result<void> shown = checkShown(options, opened->scene); !shown)
            return tl::unexpected(complain(inScene(argument, shown.error()), wrongCall));
        Result<std::vector<SweepAxis>> axes = parseAxes(opened->scene, options.axes);
        if (!axes)
            return tl::unexpected(complain(inScene(argument, axes.error()), wrongCall));
        entries.push_back({nameOf(argument), file, *std::move(opened), *std::move(axes)});
    }
    return entries;
}

/// What to call several pictures: "{minFilter}.png".
std::string nameForSeveral(const ShotOptions& options) {
    if (options.axes.empty())
        return "{scene}.png";
    const std::string path = options.axes.front().substr(0, options.axes.front().find('='));
    return fmt::format("{{{}}}.png", path.substr(path.rfind('.') + 1));
}

ExitCode shootAll(const ShotOptions& options, const NamePattern& pattern, PictureKinds kinds,
                  ShotRequest request, ShotReport* report) {
    const bool several = options.files.size() > 1 || kinds.count() > 1;
    const bool toStream = isStandardOutput(options.out) && !options.axes.empty();
    if ((several || toStream) && pattern.places().empty())
        return complain({ErrorCode::OutOfRange,
                         Sentence("expected a name that differs for each picture, as in {0} or "
                                  "{{number}}.png, found \"{1}\"",
                                  nameForSeveral(options), options.out),
                         atOption("--out")},
                        wrongCall);
    const Result<const CodecRow*> format = imageFormatOf(options.out, {});
    if (!format)
        return complain(format.error(), wrongCall);
    noteMetadata(options, **format);
    auto entries = entriesOf(options, request);
    if (!entries)
        return entries.error();
    if (entries->empty()) {
        if (report != nullptr)
            report->finish();
        return failure;
    }
    const bool incomplete = entries->size() < std::max<std::size_t>(1, options.files.size());
    const ShotList list(*std::move(entries), std::move(kinds));
    Result<std::vector<std::string>> names = list.names(pattern);
    if (!names)
        return complain(names.error(), wrongCall);
    for (const ShotList::Entry& entry : list.entries()) {
        SceneArgument argument = options.scene;
        argument.file = entry.file;
        if (const Result<void> apart = checkPicturesApart(*names, argument, entry.opened, options.renderer);
            !apart)
            return complain(apart.error(), wrongCall);
    }
    NewFolders made;
    if (const Result<void> writable = checkPlaces(*names, made); !writable)
        return complain(writable.error());
    return drawAll(
        {list, *std::move(names), *format, std::move(request), !options.withoutMetadata, report, incomplete});
}

ExitCode shoot(const ShotOptions& options, ShotReport* report) {
    Result<std::vector<view::Size>> sizes =
        parsePictureSizes(options.picture.size, options.window ? ui::minWindowSize : view::Size{1, 1});
    if (!sizes)
        return complain(sizes.error(), wrongCall);
    Result<std::vector<double>> times = parseTimes(options.picture.time);
    if (!times)
        return complain(times.error(), wrongCall);
    Result<std::vector<RendererKind>> renderers = parseRenderers(options.renderer.renderer, "--renderer");
    if (!renderers)
        return complain(renderers.error(), wrongCall);
    Result<ShotRequest> request = requestOf(options);
    if (!request)
        return complain(request.error(), wrongCall);
    if (const Result<void> used = checkUse(options, *request, *renderers); !used)
        return complain(used.error(), wrongCall);
    const Result<NamePattern> pattern = NamePattern::parse(options.out);
    if (!pattern)
        return complain({pattern.error().code, pattern.error().message, atOption("--out")}, wrongCall);
    PictureKinds kinds{*std::move(renderers), *std::move(sizes), *std::move(times)};
    request->renderer = kinds.renderers.front();
    if (options.files.size() > 1 || !options.axes.empty() || kinds.count() > 1 || !pattern->places().empty())
        return shootAll(options, *pattern, std::move(kinds), *std::move(request), report);
    request->size = kinds.sizes.front();
    request->time = kinds.times.front();
    const auto noPlaces = [](const std::string& /*place*/) { return std::string(); };
    return shootOne(options, pattern->fill(noPlaces), *std::move(request), report);
}

/// With --json what was drawn is told, even if a part of it couldn't be.
ExitCode shootAndTell(const ShotOptions& options) {
    if (!options.json)
        return shoot(options, nullptr);
    if (isStandardOutput(options.out))
        return complain(standardOutputIsTaken("--json").value(), wrongCall);
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
    addAxesArgument(command, options->axes, "a picture for each value; if repeated, for each combination");
    addPictureArgument(command, options->picture, Several::Yes);
    const Option& window = command.flag("--ui", options->window, "Draw the whole window with its panels.");
    addWindowArgument(command, window, options->shownWindow);
    addRendererArgument(command, options->renderer, Several::Yes, orWindow);
    options->shownOption = &command.option(
        "--show", options->shown,
        fmt::format(
            "With --renderer reference or --ui: the picture, or false colours for one texture unit, one of "
            "{}. lambda: the level of detail, from dark violet at the base level to yellow at the last "
            "one, black at 0 and below. anisotropy: the ratio of length to width of the footprint, from 1, "
            "dark violet, in equal steps to 2, 4, 8 and 16, yellow. Transparent where the unit samples no "
            "texture.",
            listNames(EnumTable<reference::Shown>::rows)),
        {.value = "WHAT", .showsDefault = true, .offers = {choiceNames<reference::Shown>}});
    command.number("--pass", options->shownUnit.pass, 0, maxPasses - 1, "With --show: the pass.",
                   {.needs = options->shownOption});
    command.number("--unit", options->shownUnit.unit, 0, maxUnits - 1, "With --show: its texture unit.",
                   {.needs = options->shownOption});
    command.flag(
        "--no-metadata", options->withoutMetadata,
        "Don't write texts into a PNG (program, renderer, driver, time, size and the complete scene), so "
        "that files with equal pixels are equal.");
    command.option(
        "-o,--out", options->out,
        fmt::format("The picture to write, with the format of its extension: {}; - for standard output, as "
                    "PNG. For several pictures a name with placeholders: {{scene}}, {{number}}, "
                    "{{renderer}}, {{time}}, {{size}} and the axes' paths or their last parts, as in "
                    "'out/{{scene}}-{{minFilter}}.png', whose folder is created; {{{{ is a brace.",
                    writtenExtensions(" or ")),
        {.value = "FILE", .required = true});
    command.flag(
        "--json", options->json,
        "Print the result as JSON, for programs: for each picture file, scene, values of the axes, width, "
        "height, time, renderer, driver, version, context and warnings, or its error.");
    command.footer(fmt::format(
        "One call draws at most {} pictures. If a scene can't be read or drawn, its error is reported and "
        "the others continue; if a file can't be written, the call ends.\n"
        "Exit status: 0 done, 1 a picture couldn't be drawn or written, 2 invalid arguments, 130 Ctrl+C: "
        "files written so far are complete.",
        maxShots));
    command.onCall([options] { return shootAndTell(*options); });
}

} // namespace texplorer::screenshot
