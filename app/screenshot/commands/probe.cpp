#include "texplorer/reference/probe.h"

#include "app/screenshot/arguments/context_argument.h"
#include "app/screenshot/arguments/option_use.h"
#include "app/screenshot/arguments/picture_argument.h"
#include "app/screenshot/arguments/request_argument.h"
#include "app/screenshot/arguments/scene_argument.h"
#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/gl/gl_module.h"
#include "app/screenshot/output/messages.h"
#include "app/screenshot/reports/probe_report.h"
#include "app/screenshot/shots/shot_drawer.h"

#include <algorithm>
#include <span>

namespace texplorer::screenshot {
namespace {

struct ProbeOptions {
    SceneArgument scene;
    PictureArgument picture;
    ContextArgument context;
    std::string at;
    std::string texel;
    int pass = 0;
    const Option* passOption = nullptr;
    bool json = false;
    bool withoutGl = false;
    std::vector<std::string> pretended;
};

Result<reference::PixelPlace> parsePlace(std::string_view text, view::Size size) {
    std::array<int, 2> place{};
    if (!parseNumbers(text, place))
        return fail(ErrorCode::OutOfRange, Sentence("expected X,Y, found \"{0}\"", text), atOption("--at"));
    const auto& [x, y] = place;
    if (x < 0 || y < 0 || x >= size.width || y >= size.height)
        return fail(ErrorCode::OutOfRange,
                    Sentence("expected a pixel from 0,0 to {0},{1}, found {2}", size.width - 1,
                             size.height - 1, text),
                    atOption("--at"));
    return reference::PixelPlace{x, size.height - 1 - y};
}

Result<reference::TexelQuestion> parseTexel(std::string_view text, int pass) {
    std::array<int, 5> numbers{};
    const bool volume = parseNumbers(text, numbers);
    if (!volume && (numbers = {}, !parseNumbers(text, std::span(numbers).first(4))))
        return fail(ErrorCode::OutOfRange, Sentence("expected UNIT,LEVEL,I,J, found \"{0}\"", text),
                    atOption("--texel"));
    return reference::TexelQuestion{
        pass, numbers[0], {numbers[1], {numbers[2], numbers[3], volume ? numbers[4] : 0}}};
}

/// What OpenGL has at the pixel: the whole picture is drawn for it.
std::vector<ReadBack> readBack(ShotRequest request, const reference::PixelPlace& pixel,
                               std::vector<Sentence>& problems) {
    std::vector<ReadBack> all;
    ShotDrawer drawer;
    for (const RendererKind renderer : {RendererKind::Fixed, RendererKind::Shader}) {
        request.renderer = renderer;
        const Result<Shot> shot = drawer.draw(request);
        if (!shot) {
            all.push_back({renderer, fail(shot.error())});
            continue;
        }
        for (const Sentence& problem : shot->frame.problems) {
            if (std::ranges::find(problems, problem) == problems.end())
                problems.push_back(problem);
        }
        reference::PixelBytes bytes{};
        for (std::size_t i = 0; i < bytes.size(); ++i)
            bytes[i] = std::to_integer<std::uint8_t>(shot->frame.image.at(pixel.x, pixel.y)[i]);
        all.push_back({renderer, bytes});
    }
    return all;
}

void complainAbout(const std::vector<Sentence>& problems) {
    for (const Sentence& problem : problems)
        warn({ErrorCode::Driver, problem, {}});
}

ExitCode probePixel(const ProbeOptions& options, ShotRequest request) {
    const Result<reference::PixelPlace> pixel = parsePlace(options.at, request.size);
    if (!pixel)
        return complain(pixel.error(), wrongCall);
    Result<reference::Explanation> explanation =
        reference::probe(request.drawRequest(), *pixel, {.levels = request.levels});
    if (!explanation)
        return complain(explanation.error());
    std::vector<Sentence> problems = explanation->problems;
    const std::vector<ReadBack> readBacks =
        options.withoutGl ? std::vector<ReadBack>() : readBack(std::move(request), *pixel, problems);
    complainAbout(problems);
    const bool isDrawn = options.withoutGl || std::ranges::any_of(readBacks, [](const ReadBack& each) {
                             return each.bytes.has_value();
                         });
    const ExitCode status = isDrawn ? success : complain(readBacks.front().bytes.error());
    const Result<void> printed =
        print(options.json ? asJson(*explanation, readBacks) : asText(*explanation, readBacks));
    return printed ? status : complain(printed.error());
}

/// The option that asks for what the scene lacks; empty: the error is about something else.
std::string_view optionAtFault(const ProbeOptions& options, const Scene& scene, const Error& error) {
    if (error.code != ErrorCode::OutOfRange)
        return {};
    return static_cast<std::size_t>(options.pass) < scene.passes.size() ? "--texel" : "--pass";
}

ExitCode findPixels(const ProbeOptions& options, const ShotRequest& request) {
    const Result<reference::TexelQuestion> question = parseTexel(options.texel, options.pass);
    if (!question)
        return complain(question.error(), wrongCall);
    const Result<reference::Contributions> found =
        reference::contributions(request.drawRequest(), *question, {.levels = request.levels});
    if (!found) {
        const Error& error = found.error();
        const std::string_view option = optionAtFault(options, request.scene, error);
        return option.empty()
                   ? complain(error)
                   : complain({error.code, error.message, atOption(std::string(option))}, wrongCall);
    }
    complainAbout(found->problems);
    const Result<void> printed =
        options.json ? printPieces([&](const Print& piece) { return writeJson(*found, *question, piece); })
                     : print(asText(*found, *question));
    return printed ? success : complain(printed.error());
}

ExitCode probe(const ProbeOptions& options) {
    if (options.at.empty() == options.texel.empty())
        return complain({ErrorCode::OutOfRange, N_("expected either --at or --texel"), {}}, wrongCall);
    if (options.passOption->isGiven() && options.texel.empty())
        noteUnused("--pass", "it needs --texel; --at explains every pass");
    if (options.withoutGl && options.at.empty())
        noteUnused("--no-gl", "it needs --at; --texel doesn't use OpenGL");
    const Result<view::Pretence> pretence = view::Pretence::parse(options.pretended);
    if (!pretence)
        return complain(pretence.error(), wrongCall);
    if (!options.pretended.empty() && !pretence->limitsTextures() &&
        (options.withoutGl || options.at.empty()))
        noteUnused("--pretend", "it concerns the driver, which only --at without --no-gl uses");
    const Result<view::ContextChoice> context = parseContext(options.context);
    if (!context)
        return complain(context.error(), wrongCall);
    if (options.context.option->isGiven() && (options.withoutGl || options.at.empty()))
        noteUnused("--context", "it concerns OpenGL, which only --at without --no-gl uses");
    const Result<view::Size> size = parsePictureSize(options.picture.size);
    if (!size)
        return complain(size.error(), wrongCall);
    const Result<double> time = parseTime(options.picture.time);
    if (!time)
        return complain(time.error(), wrongCall);
    ShotRequest request;
    if (const Result<void> methods = putMethods(options.picture, request); !methods)
        return complain(methods.error(), wrongCall);
    auto opened = openScene(options.scene);
    if (!opened)
        return complain(opened.error().error, opened.error().code);
    request.scene = std::move(opened->scene);
    request.images = std::move(opened->images);
    request.file = options.scene.path();
    request.time = *time;
    request.size = *size;
    request.pretence = *pretence;
    request.context = *context;
    request.levels.cache = BlockCache::ofUser();
    if (const auto loaded = request.images.load(request.scene); !loaded)
        return complain(inScene(options.scene, loaded.error()));
    tellOfImages(request.images);
    return options.at.empty() ? findPixels(options, request) : probePixel(options, std::move(request));
}

} // namespace

void addProbe(CommandLine& line) {
    Command& command = line.command("probe", "Explain why a pixel has its colour, number by number.");
    auto options = std::make_shared<ProbeOptions>();
    addSceneOrLessonArgument(command, options->scene);
    addPictureArgument(command, options->picture);
    command.option("--at", options->at,
                   "The pixel, counted from 0,0 at the top left, as in the PNG of \"texshot shot\". Either "
                   "--at or --texel is required.",
                   {.value = "X,Y"});
    command.option(
        "--texel", options->texel,
        "The reverse: lists the pixels that a texel contributes to, with its weight in each. I and J are "
        "counted from s = 0 and t = 0 (UNIT,LEVEL,I,J,K for a volume; K is the face of a cube map, 0 to "
        "5). -1 and the level's size are the border.",
        {.value = "UNIT,LEVEL,I,J"});
    options->passOption = &command.number("--pass", options->pass, 0, static_cast<long long>(maxPasses) - 1,
                                          "With --texel: the pass of the unit.", {.showsDefault = true});
    command.flag("--json", options->json, "As JSON, for programs: all of the text and more.");
    command.flag("--no-gl", options->withoutGl,
                 "With --at: don't draw the picture with OpenGL for comparison with the specification.");
    addContextArgument(command, options->context);
    command.option("--pretend", options->pretended, view::pretenceHelp(),
                   {.value = "WORDS", .oneEach = true, .offers = {view::pretenceWords, true}});
    command.onCall([options] { return probe(*options); });
}

} // namespace texplorer::screenshot
