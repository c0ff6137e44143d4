#include "app/command_line/choice_argument.h"
#include "app/screenshot/arguments/moves_argument.h"
#include "app/screenshot/arguments/option_use.h"
#include "app/screenshot/arguments/request_argument.h"
#include "app/screenshot/arguments/scene_argument.h"
#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/output/messages.h"
#include "app/screenshot/output/output.h"
#include "app/screenshot/shots/animation_run.h"
#include "app/screenshot/shots/shot_list.h"
#include "app/screenshot/shots/shot_run.h"
#include "texplorer/animation/frame_times.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/params/timeline_check.h"
#include "texplorer/text/name_pattern.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace texplorer::screenshot {
namespace {

constexpr std::size_t maxPictures = 10'000;
constexpr double maxPerSecond = 1000;

struct AnimateOptions {
    SceneArgument scene;
    PictureArgument picture{.size = "640x400"};
    RendererArgument renderer;
    std::string perSecond = "25";
    std::string seconds;
    std::string easing = std::string(rowOf(Easing::Linear).name);
    int plays = 0;
    bool pingPong = false;
    std::string quality;
    std::string out;
    bool withoutMetadata = false;
    const Option* easingOption = nullptr;
    const Option* playsOption = nullptr;
};

/// What is to be drawn, as the call says it.
struct Motion {
    ShotRequest request; ///< all but the scene
    OpenedScene opened;  ///< with its key frames
    double perSecond = 1;
    double seconds = 1;       ///< one way
    std::size_t pictures = 1; ///< one way
};

/// From above `low` to `high`.
Result<double> parseNumber(std::string_view text, double low, double high, const char* option) {
    double number = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error == std::errc() && stop == end && number > low && number <= high)
        return number;
    return fail(ErrorCode::OutOfRange,
                Sentence("expected a number above {0} and up to {1}, found \"{2}\"", low, high, text),
                atOption(option));
}

/// As the line says it, or else as long as the scene's key frames are.
Result<double> lengthOf(const AnimateOptions& options, const Scene& scene, double begin) {
    if (!options.seconds.empty())
        return parseNumber(options.seconds, 0, double{maxKeyTime}, "--seconds");
    const double rest = texplorer::lengthOf(scene.timeline) - begin;
    if (rest > 0)
        return rest;
    return fail(ErrorCode::OutOfRange, "expected a length, as the scene has no key frames",
                atOption("--seconds"));
}

Result<void> putMoves(const AnimateOptions& options, const std::vector<std::string>& moves, Motion& motion) {
    const Result<Easing> easing = parseChoice<Easing>(options.easing, "--easing");
    if (!easing)
        return fail(easing.error());
    if (moves.empty() && options.easingOption->isGiven())
        noteUnused("--easing", "it applies only to parameters that --set moves");
    Scene& scene = motion.opened.scene;
    for (const std::string& move : moves) {
        if (Result<void> put = putMove(scene, move, {motion.request.time, motion.seconds, *easing}); !put)
            return put;
    }
    return checkTimeline(scene);
}

Result<void> countPictures(Motion& motion) {
    const double pictures = std::max(1.0, std::round(motion.seconds * motion.perSecond));
    if (pictures > static_cast<double>(maxPictures))
        return fail(ErrorCode::TooLarge,
                    Sentence("expected at most {0} pictures, found {1}: {2} s with {3} a second", maxPictures,
                             pictures, motion.seconds, motion.perSecond),
                    atOption("--seconds"));
    motion.pictures = static_cast<std::size_t>(pictures);
    return {};
}

tl::expected<Motion, SceneProblem> motionOf(const AnimateOptions& options) {
    const auto wrong = [](const Error& error) { return tl::unexpected(SceneProblem{error, wrongCall}); };
    Result<ShotRequest> request = requestOf(options.picture, options.renderer);
    if (!request)
        return wrong(request.error());
    if (request->time < 0 || request->time >= double{maxKeyTime})
        return wrong({ErrorCode::OutOfRange,
                      Sentence("expected a begin from 0 to {0} s, found {1}", maxKeyTime, request->time),
                      atOption("--time")});
    const Result<double> perSecond = parseNumber(options.perSecond, 0, maxPerSecond, "--fps");
    if (!perSecond)
        return wrong(perSecond.error());
    SceneArgument scene = options.scene;
    const std::vector<std::string> moves = takeMoves(scene.assignments);
    auto opened = openScene(scene);
    if (!opened)
        return tl::unexpected(opened.error());
    Motion motion{*std::move(request), *std::move(opened), *perSecond};
    const Result<double> seconds = lengthOf(options, motion.opened.scene, motion.request.time);
    if (!seconds)
        return wrong(seconds.error());
    motion.seconds = *seconds;
    if (motion.request.time + motion.seconds > double{maxKeyTime})
        return wrong({ErrorCode::TooLarge,
                      Sentence("expected an end within {0} s, found {1}", maxKeyTime,
                               motion.request.time + motion.seconds),
                      atOption("--seconds")});
    if (const Result<void> counted = countPictures(motion); !counted)
        return wrong(counted.error());
    if (const Result<void> put = putMoves(options, moves, motion); !put)
        return wrong(put.error());
    return motion;
}

/// When each picture is taken: there, and back without the two ends, which are there already.
std::vector<double> timesOf(const AnimateOptions& options, const Motion& motion) {
    std::vector<double> times;
    const auto at = [&](std::size_t i) {
        return motion.request.time + static_cast<double>(i) / motion.perSecond;
    };
    for (std::size_t i = 0; i < motion.pictures + (options.pingPong ? 1 : 0); ++i)
        times.push_back(at(i));
    for (std::size_t i = motion.pictures; options.pingPong && i-- > 1;)
        times.push_back(at(i));
    return times;
}

/// "frame-%04d.png": the name of each picture's file, or of one that holds them all.
struct FileNames {
    NamePattern pattern;
    std::size_t digits = 0; ///< of the number; 0: it has no place

    [[nodiscard]] std::string at(std::size_t number) const {
        return pattern.fill([&](const std::string&) { return fmt::format("{:0{}}", number, digits); });
    }
};

constexpr std::string_view numberPlace = "number";

/// As printf has it, "%d" or "%04d", with the place in braces, "{%04d}". Refused: everything else behind a %.
Result<std::string> withBracedNumbers(std::string_view name) {
    std::string braced;
    while (true) {
        const std::size_t place = name.find('%');
        braced += name.substr(0, place);
        if (place == std::string_view::npos)
            return braced;
        name.remove_prefix(place);
        const std::size_t end = name.find_first_not_of("0123456789", 1);
        const bool isPlain = end == 1 || (end == 3 && name[1] == '0'); // up to 9 digits
        if (end == std::string_view::npos || name[end] != 'd' || !isPlain || braced.ends_with('{'))
            return fail(ErrorCode::Malformed, {});
        braced.append("{").append(name.substr(0, end + 1)).append("}");
        name.remove_prefix(end + 1);
    }
}

Result<FileNames> fileNames(const std::string& name, std::size_t pictures) {
    const auto wrong = [&] {
        return fail(ErrorCode::OutOfRange,
                    Sentence("expected a place for the number as %04d or {{number}}, found \"{0}\"", name),
                    atOption("--out"));
    };
    const Result<std::string> braced = withBracedNumbers(name);
    if (!braced)
        return wrong();
    Result<NamePattern> pattern = NamePattern::parse(*braced);
    if (!pattern)
        return fail(pattern.error().code, pattern.error().message, atOption("--out"));
    const std::vector<std::string> places = pattern->places();
    if (places.size() > 1)
        return fail(ErrorCode::OutOfRange,
                    Sentence("expected one place for the number, found two in \"{0}\"", name),
                    atOption("--out"));
    FileNames names{*std::move(pattern)};
    for (const std::string_view place : places) {
        if (place == numberPlace)
            names.digits = std::to_string(pictures).size();
        else if (place.starts_with('%'))
            names.digits =
                place.size() == 2 ? 1 : std::max<std::size_t>(1, static_cast<std::size_t>(place[2] - '0'));
        else
            return wrong();
    }
    return names;
}

/// What a file of its own can't be: the error is about the line.
Result<void> checkFormat(const AnimateOptions& options, const Motion& motion,
                         const animation::FormatRow& format) {
    if (motion.perSecond > format.maxPerSecond)
        return fail(
            ErrorCode::OutOfRange,
            Sentence("expected at most {0} a second in {1} files, which viewers show slower; found {2}",
                     format.maxPerSecond, format.name, motion.perSecond),
            atOption("--fps"));
    const double shown = std::min(1 / motion.perSecond, motion.seconds);
    const double longest = static_cast<double>(format.maxShownUnits) / format.unitsPerSecond;
    if (shown > longest)
        return fail(
            ErrorCode::OutOfRange,
            Sentence("expected in {0} files pictures that are shown for at most {1:g} s, found {2:g} s",
                     format.name, longest, shown),
            atOption("--fps"));
    const auto [width, height] = motion.request.size;
    if (std::max(width, height) > format.maxExtent)
        return fail(ErrorCode::TooLarge,
                    Sentence("expected at most {0}x{0} for {1} files, found {2}x{3}", format.maxExtent,
                             format.name, width, height),
                    atOption("--size"));
    if (!options.quality.empty() && format.format != animation::Format::WebP)
        noteUnused("--quality", "it applies to WebP only");
    if (options.withoutMetadata && format.format != animation::Format::Apng)
        noteUnused("--no-metadata", "it applies to PNG files only");
    return {};
}

/// A whole number of pictures a second is said exactly in an APNG; everywhere else what is rounded is when
/// each picture begins.
std::vector<int> durationsFor(const Motion& motion, std::size_t pictures, animation::Settings& settings,
                              const animation::FormatRow& format) {
    settings.unitsPerSecond = format.unitsPerSecond;
    const double seconds = motion.seconds * (pictures > motion.pictures ? 2 : 1);
    const double even = motion.perSecond;
    if (format.format == animation::Format::Apng && even == std::round(even) &&
        seconds * even == static_cast<double>(pictures))
        settings.unitsPerSecond = static_cast<int>(even);
    std::vector<int> durations = animation::durationsOf(pictures, even, seconds, settings.unitsPerSecond);
    const auto [shortest, longest] = std::ranges::minmax(durations);
    const double hundredths = format.unitsPerSecond / even;
    if (format.format == animation::Format::Gif && hundredths != std::round(hundredths) &&
        shortest != longest)
        warn(
            {ErrorCode::Unsupported,
             Sentence("a GIF counts in hundredths of a second: with {0} pictures a second they are shown for "
                      "{1} to {2} of them each, and the whole length is kept",
                      even, shortest, longest),
             {}});
    return durations;
}

ExitCode animateIntoFile(const AnimateOptions& options, const std::string& out, Motion motion) {
    const animation::FormatRow* format = animation::formatOfName(out);
    if (format == nullptr)
        return complain({ErrorCode::Unsupported,
                         Sentence("expected a name that ends in .gif, .webp or .png, or one with a place for "
                                  "the number of each picture, as frame-%04d.tga; found \"{0}\"",
                                  out),
                         atOption("--out")},
                        wrongCall);
    if (const Result<void> fits = checkFormat(options, motion, *format); !fits)
        return complain(fits.error(), wrongCall);
    animation::Settings settings;
    settings.width = motion.request.size.width;
    settings.height = motion.request.size.height;
    settings.plays = options.plays;
    if (!options.quality.empty()) {
        const Result<double> quality = parseNumber(options.quality, -1, 100, "--quality");
        if (!quality || *quality < 0)
            return complain({ErrorCode::OutOfRange,
                             Sentence("expected a number from 0 to 100, found \"{0}\"", options.quality),
                             atOption("--quality")},
                            wrongCall);
        settings.quality = static_cast<float>(*quality);
    }
    if (const Result<void> apart =
            checkPicturesApart({&out, 1}, options.scene, motion.opened, options.renderer);
        !apart)
        return complain(apart.error(), wrongCall);
    Result<Output> output = Output::open(out);
    if (!output)
        return complain(output.error());
    const std::vector<double> times = timesOf(options, motion);
    std::vector<int> durations = durationsFor(motion, times.size(), settings, *format);
    const ShotList list({{nameOf(options.scene), options.scene.file, motion.opened, {}}},
                        {{motion.request.renderer}, {motion.request.size}, times});
    return drawAnimation({list, std::move(durations), format->format, std::move(settings),
                          std::move(motion.request), *std::move(output),
                          format->format == animation::Format::Apng && !options.withoutMetadata});
}

ExitCode animateIntoFiles(const AnimateOptions& options, const Motion& motion, const FileNames& name) {
    if (!options.quality.empty())
        noteUnused("--quality", "it applies to WebP only");
    if (options.playsOption->isGiven())
        noteUnused("--loop", "single pictures don't loop");
    const Result<const CodecRow*> format = imageFormatOf(options.out, {});
    if (!format)
        return complain(format.error(), wrongCall);
    if (options.withoutMetadata && (*format)->name != "PNG")
        noteUnused("--no-metadata", "it applies to PNG files only");
    const std::vector<double> times = timesOf(options, motion);
    const ShotList list({{nameOf(options.scene), options.scene.file, motion.opened, {}}},
                        {{motion.request.renderer}, {motion.request.size}, times});
    std::vector<std::string> names;
    for (std::size_t i = 1; i <= times.size(); ++i)
        names.push_back(name.at(i));
    if (const Result<void> apart = checkPicturesApart(names, options.scene, motion.opened, options.renderer);
        !apart)
        return complain(apart.error(), wrongCall);
    NewFolders made;
    if (const Result<void> writable = checkPlaces(names, made); !writable)
        return complain(writable.error());
    return drawAll({list, std::move(names), *format, motion.request, !options.withoutMetadata});
}

ExitCode animate(const AnimateOptions& options) {
    auto motion = motionOf(options);
    if (!motion)
        return complain(motion.error().error, motion.error().code);
    const Result<FileNames> name = fileNames(options.out, 2 * motion->pictures);
    if (!name)
        return complain(name.error(), wrongCall);
    if (!isAnimated(motion->opened.scene))
        warn({ErrorCode::Unsupported, N_("nothing in the scene moves: all pictures are the same"), {}});
    return name->digits > 0 ? animateIntoFiles(options, *motion, *name)
                            : animateIntoFile(options, name->at(0), *std::move(motion));
}

} // namespace

void addAnimate(CommandLine& line) {
    Command& command =
        line.command("animate", "Draw an animated scene into a GIF, WebP or APNG, or into numbered files.");
    auto options = std::make_shared<AnimateOptions>();
    addSceneOrLessonArgument(command, options->scene);
    command.option("--fps", options->perSecond, "Pictures a second.", {.value = "N", .showsDefault = true});
    command.option("--seconds", options->seconds, "The length. Default: that of the scene's key frames.",
                   {.value = "S"});
    options->easingOption =
        &command.option("--easing", options->easing,
                        "The easing of --set from each value to the next." + explainChoices<Easing>(),
                        {.value = "NAME", .showsDefault = true, .offers = {choiceNames<Easing>}});
    command.flag("--pingpong", options->pingPong,
                 "Then play the pictures backwards: twice as long, and always a smooth loop.");
    options->playsOption =
        &command.number("--loop", options->plays, 0, 65535, "How often it is played; 0: forever.");
    addPictureArgument(command, options->picture);
    addRendererArgument(command, options->renderer);
    command.option("--quality", options->quality,
                   "The quality of a lossy WebP, 0 to 100. Default: "
                   "lossless.",
                   {.value = "Q"});
    command.flag("--no-metadata", options->withoutMetadata,
                 "Don't write texts into a PNG (how it was drawn and the complete scene).");
    command.option(
        "-o,--out", options->out,
        "The file to write: .gif, .webp or .png (APNG). With a place for a number, 'frame-%04d.png' or "
        "'frame-{number}.tga', each picture is a separate file, as of \"texshot shot\", counted from 1.",
        {.value = "FILE", .required = true});
    command.footer(fmt::format(
        "What moves: the scene's key frames, spins and rates, and parameters of --set. --set PATH=A..B "
        "goes from A to B over the whole length, A..B..C through B; for vectors and colours every "
        "component, 'view.background=0,0,0,1..1,1,1,1'. Names and switches are not interpolated: each "
        "value is shown for an equal part of the length, and * means all of them.\n"
        "Picture number i, from 0, is \"texshot shot --time\" at i / fps after --time. The picture at the "
        "very end isn't drawn: if it equals the first one, as with 'view.azimuth=0..360', the loop is "
        "exact.\n"
        "GIFs have 256 colours in each picture, count in hundredths of a second and go up to {} pictures a "
        "second; APNG and WebP are lossless. A call draws at most {} pictures each way.\n"
        "Exit status: 0 done, 1 a picture couldn't be drawn or the file written, 2 invalid arguments, 130 "
        "Ctrl+C: then there is no file, or the numbered files written so far are complete.",
        animation::rowOf(animation::Format::Gif).maxPerSecond, maxPictures));
    command.onCall([options] { return animate(*options); });
}

} // namespace texplorer::screenshot
