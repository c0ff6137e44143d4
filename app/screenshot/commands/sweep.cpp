#include "app/command_line/choice_argument.h"
#include "app/lettering/font_lettering.h"
#include "app/screenshot/arguments/axes_argument.h"
#include "app/screenshot/arguments/input.h"
#include "app/screenshot/arguments/option_use.h"
#include "app/screenshot/arguments/request_argument.h"
#include "app/screenshot/arguments/scene_argument.h"
#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/output/output.h"
#include "app/screenshot/shots/sheet_run.h"
#include "app/screenshot/shots/shot_list.h"
#include "app/screenshot/shots/shot_run.h"
#include "app/view/picture_texts.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/sheet/axis_labels.h"
#include "texplorer/sheet/layout.h"
#include "texplorer/text/printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>

namespace texplorer::screenshot {
namespace {

constexpr std::size_t tableAxes = 2;
constexpr std::size_t maxSweepAxes = 3;
constexpr const char* pagePlace = "page";
constexpr const char* firstPicture = "first";

struct SweepOptions {
    SceneArgument scene;
    std::vector<std::string> axes;
    PictureArgument picture{.size = "320x200"};
    RendererArgument renderer;
    std::string labels = std::string(rowOf(sheet::LabelKind::Names).name);
    std::string difference;
    std::string out;
    bool withoutMetadata = false;
    bool json = false;
    const Option* labelsOption = nullptr;
};

/// What is to be drawn, as the call says it.
struct Sweep {
    ShotRequest request; ///< all but the scene
    OpenedScene opened;
    std::vector<SweepAxis> axes; ///< down, across, pages
    NamePattern pattern;
    sheet::LabelKind labels = sheet::LabelKind::Names;

    [[nodiscard]] bool hasPlace(std::string_view place) const {
        const std::vector<std::string> places = pattern.places();
        return std::ranges::find(places, place) != places.end();
    }
    /// Whether the name differs for each value of the axis.
    [[nodiscard]] bool hasPlaceOf(const SweepAxis& axis) const {
        return hasPlace(axis.path) || hasPlace(keyOfPath(axis.path));
    }
    [[nodiscard]] bool hasPages() const { return axes.size() > tableAxes; }
    [[nodiscard]] std::size_t pageCount() const { return hasPages() ? axes.back().values.size() : 1; }
};

tl::expected<Sweep, SceneProblem> sweepOf(const SweepOptions& options) {
    const auto wrong = [](const Error& error) { return tl::unexpected(SceneProblem{error, wrongCall}); };
    Result<ShotRequest> request = requestOf(options.picture, options.renderer);
    if (!request)
        return wrong(request.error());
    const Result<sheet::LabelKind> labels = parseChoice<sheet::LabelKind>(options.labels, "--labels");
    if (!labels)
        return wrong(labels.error());
    if (!options.difference.empty() && options.difference != firstPicture)
        return wrong(refuseChoice({firstPicture}, options.difference, "--difference").value());
    Result<NamePattern> pattern = NamePattern::parse(options.out);
    if (!pattern)
        return wrong({pattern.error().code, pattern.error().message, atOption("--out")});
    auto opened = openScene(options.scene);
    if (!opened)
        return tl::unexpected(opened.error());
    Result<std::vector<SweepAxis>> axes = parseAxes(opened->scene, options.axes);
    if (!axes)
        return wrong(inScene(options.scene, axes.error()));
    return Sweep{*std::move(request), *std::move(opened), *std::move(axes), *std::move(pattern), *labels};
}

/// A name whose every axis has a place is that of single pictures.
bool isOfSingleFiles(const Sweep& sweep) {
    return sweep.hasPlace("number") ||
           std::ranges::all_of(sweep.axes, [&](const SweepAxis& axis) { return sweep.hasPlaceOf(axis); });
}

/// "{wrapS}" of "textures[0].wrapS".
std::string placeOf(const SweepAxis& axis) {
    return fmt::format("{{{}}}", keyOfPath(axis.path));
}

/// What is wrong with the name of sheets, or with how many there would be.
Result<void> checkSheets(const Sweep& sweep, const std::string& out) {
    if (sweep.axes.size() > maxSweepAxes)
        return fail(
            ErrorCode::OutOfRange,
            Sentence("expected at most {0} axes, down, across and pages, found {1}; a name with a place "
                     "for each of them writes single pictures",
                     maxSweepAxes, sweep.axes.size()),
            atOption("--axis"));
    const std::array<std::string_view, 4> fixedPlaces{"scene", "renderer", "time", "size"};
    for (const std::string& place : sweep.pattern.places()) {
        const bool ofPages =
            place == pagePlace || (sweep.hasPages() && (place == sweep.axes.back().path ||
                                                        place == keyOfPath(sweep.axes.back().path)));
        if (!ofPages && std::ranges::find(fixedPlaces, place) == fixedPlaces.end())
            return fail(
                ErrorCode::OutOfRange,
                Sentence("expected {{page}}, {{scene}}, {{renderer}}, {{time}}, {{size}}{0} for sheets, "
                         "or a place of every axis for single pictures, found {{{1}}}",
                         sweep.hasPages() ? " or " + placeOf(sweep.axes.back()) : std::string(), place),
                atOption("--out"));
    }
    if (sweep.pageCount() > 1 && !sweep.hasPlace(pagePlace) && !sweep.hasPlaceOf(sweep.axes.back()))
        return fail(
            ErrorCode::OutOfRange,
            Sentence("expected a name that differs for each of {0} pages, as in sheet-{{page}}.png or "
                     "{1}.png, found \"{2}\"",
                     sweep.pageCount(), placeOf(sweep.axes.back()), out),
            atOption("--out"));
    return {};
}

/// What is written above the pictures.
std::string titleOf(const SceneArgument& scene) {
    if (isStandardInput(scene.file))
        return "Scene";
    const bool named = !scene.file.empty() || !scene.example.empty() || !scene.lesson.empty();
    return named ? printable(nameOf(scene)) : "Default scene";
}

/// What a page says, all but its output.
Result<sheet::Layout> layoutOfPage(const SweepOptions& options, const Sweep& sweep, std::size_t page,
                                   const sheet::Lettering& lettering) {
    const std::vector<sheet::AxisLabels> labels =
        sheet::labelsOf(sweep.opened.scene, sweep.axes, sweep.labels);
    sheet::Content content;
    content.title = titleOf(options.scene);
    content.cell = {sweep.request.size.width, sweep.request.size.height};
    content.down = labels.front();
    if (labels.size() > 1)
        content.across = labels[1];
    if (sweep.hasPages())
        content.subtitle = fmt::format("{}: {} (page {} of {})", labels.back().title,
                                       labels.back().values[page], page + 1, sweep.pageCount());
    if (!options.difference.empty()) {
        content.caption = "The other pictures show the difference from the first: black is equal, and "
                          "lighter pixels differ more.";
        content.widestNote = wordsOfDifference(static_cast<std::size_t>(sweep.request.size.width) *
                                               static_cast<std::size_t>(sweep.request.size.height));
    }
    return sheet::layoutOf(content, lettering);
}

std::string nameOfPage(const SweepOptions& options, const Sweep& sweep, std::size_t page) {
    const std::size_t digits = std::to_string(sweep.pageCount()).size();
    return sweep.pattern.fill([&](const std::string& place) {
        if (place == pagePlace)
            return fmt::format("{:0{}}", page + 1, digits);
        if (place == "scene")
            return nameOf(options.scene);
        if (place == "renderer")
            return std::string(rowOf(sweep.request.renderer).name);
        if (place == "time")
            return fmt::format("{}", sweep.request.time);
        return place == "size" ? fmt::format("{}x{}", sweep.request.size.width, sweep.request.size.height)
                               : sweep.axes.back().values[page];
    });
}

/// The error is the exit status; it has been said.
tl::expected<std::vector<ImageOutput>, ExitCode> outputsOf(const SweepOptions& options, const Sweep& sweep) {
    std::vector<std::string> names;
    for (std::size_t page = 0; page < sweep.pageCount(); ++page) {
        std::string name = nameOfPage(options, sweep, page);
        if (std::ranges::find(names, name) != names.end())
            return tl::unexpected(
                complain({ErrorCode::OutOfRange,
                          Sentence("expected a name for each page, found \"{0}\" for two; {{page}} in it "
                                   "makes them different",
                                   name),
                          atOption("--out")},
                         wrongCall));
        names.push_back(std::move(name));
    }
    if (const Result<void> apart = checkPicturesApart(names, options.scene, sweep.opened, options.renderer);
        !apart)
        return tl::unexpected(complain(apart.error(), wrongCall));
    std::vector<ImageOutput> outputs;
    for (const std::string& name : names) {
        auto output = openImageOutput(name, "PNG");
        if (!output)
            return tl::unexpected(output.error());
        outputs.push_back(*std::move(output));
    }
    if (options.withoutMetadata && outputs.front().format->name != "PNG")
        noteUnused("--no-metadata", "it applies to PNG files only");
    return outputs;
}

/// The scene's variations, in the order of sheets: page by page, row by row.
ShotList shotsOf(const SweepOptions& options, const Sweep& sweep, bool pagesFirst) {
    std::vector<SweepAxis> axes = sweep.axes;
    if (pagesFirst && sweep.hasPages())
        std::rotate(axes.begin(), axes.end() - 1, axes.end());
    return {{{nameOf(options.scene), options.scene.file, sweep.opened, std::move(axes)}},
            {{sweep.request.renderer}, {sweep.request.size}, {sweep.request.time}}};
}

ExitCode sweepIntoSheets(const SweepOptions& options, const Sweep& sweep,
                         std::vector<WrittenSheet>* written) {
    if (const Result<void> sheets = checkSheets(sweep, options.out); !sheets)
        return complain(sheets.error(), wrongCall);
    const ShotList list = shotsOf(options, sweep, true);
    if (list.count() > sheet::maxPictures)
        return complain(
            {ErrorCode::TooLarge,
             list.count() > maxShots
                 ? Sentence("expected at most {0} pictures on the sheets of a call, found more than {1}",
                            sheet::maxPictures, maxShots)
                 : Sentence("expected at most {0} pictures on the sheets of a call, found {1}",
                            sheet::maxPictures, list.count()),
             atOption("--axis")},
            wrongCall);
    const Result<std::unique_ptr<sheet::Lettering>> lettering = openLettering();
    if (!lettering)
        return complain(lettering.error());
    std::vector<sheet::Layout> layouts;
    for (std::size_t page = 0; page < sweep.pageCount(); ++page) {
        Result<sheet::Layout> layout = layoutOfPage(options, sweep, page, **lettering);
        if (!layout)
            return complain({layout.error().code, layout.error().message, atOption("--size")}, wrongCall);
        layouts.push_back(*std::move(layout));
    }
    auto outputs = outputsOf(options, sweep);
    if (!outputs)
        return outputs.error();
    std::vector<SheetRun::Page> pages;
    for (std::size_t page = 0; page < sweep.pageCount(); ++page) {
        Scene scene = sweep.opened.scene;
        std::vector<std::string> axes;
        for (std::size_t i = 0; i < std::min(sweep.axes.size(), tableAxes); ++i)
            axes.push_back(view::axisText(sweep.axes[i], sweep.axes[i].values));
        if (sweep.hasPages()) {
            const SweepAxis& axis = sweep.axes.back();
            if (const Result<void> set = setParam(scene, axis.path, axis.values[page]); !set)
                return complain(inScene(options.scene, set.error()));
            axes.push_back(view::axisText(axis, std::span(&axis.values[page], 1)));
        }
        pages.push_back(
            {std::move((*outputs)[page]), std::move(layouts[page]), std::move(scene), std::move(axes)});
    }
    return drawSheets({.list = list,
                       .pages = std::move(pages),
                       .common = sweep.request,
                       .lettering = **lettering,
                       .difference = !options.difference.empty(),
                       .withTexts = !options.withoutMetadata,
                       .written = written});
}

ExitCode sweepIntoFiles(const SweepOptions& options, const Sweep& sweep, ShotReport* report) {
    if (!options.difference.empty())
        return complain({ErrorCode::OutOfRange, N_("expected a name for sheets: it applies to sheets only"),
                         atOption("--difference")},
                        wrongCall);
    if (options.labelsOption->isGiven())
        noteUnused("--labels", "it applies to sheets only");
    const Result<const CodecRow*> format = imageFormatOf(options.out, {});
    if (!format)
        return complain(format.error(), wrongCall);
    if (options.withoutMetadata && (*format)->name != "PNG")
        noteUnused("--no-metadata", "it applies to PNG files only");
    const ShotList list = shotsOf(options, sweep, false);
    Result<std::vector<std::string>> names = list.names(sweep.pattern);
    if (!names)
        return complain(names.error(), wrongCall);
    if (const Result<void> apart = checkPicturesApart(*names, options.scene, sweep.opened, options.renderer);
        !apart)
        return complain(apart.error(), wrongCall);
    NewFolders made;
    if (const Result<void> writable = checkPlaces(*names, made); !writable)
        return complain(writable.error());
    return drawAll({list, *std::move(names), *format, sweep.request, !options.withoutMetadata, report});
}

/// With --json what was drawn is told, even if a part of it couldn't be.
ExitCode sweep(const SweepOptions& options) {
    if (options.json && isStandardOutput(options.out))
        return complain(standardOutputIsTaken("--json").value(), wrongCall);
    const auto made = sweepOf(options);
    if (!made)
        return complain(made.error().error, made.error().code);
    ExitCode status = success;
    std::optional<std::string> told;
    if (isOfSingleFiles(*made)) {
        ShotReport report;
        status = sweepIntoFiles(options, *made, options.json ? &report : nullptr);
        if (report.isFinished())
            told = report.json();
    } else {
        std::vector<WrittenSheet> sheets;
        status = sweepIntoSheets(options, *made, options.json ? &sheets : nullptr);
        if (!sheets.empty())
            told = sheetsJson(sheets);
    }
    if (!options.json || !told)
        return status;
    const Result<void> printed = print(*told);
    return printed ? status : complain(printed.error());
}

} // namespace

void addSweep(CommandLine& line) {
    Command& command = line.command(
        "sweep", "Draw a scene with every value of a parameter, side by side on a labelled sheet.");
    auto options = std::make_shared<SweepOptions>();
    addSceneOrLessonArgument(command, options->scene);
    addAxesArgument(
        command, options->axes,
        "a picture for each, in rows. A second axis makes a table, with the first down and the second "
        "across; a third axis makes a page for each value",
        true);
    addPictureArgument(command, options->picture);
    addRendererArgument(command, options->renderer);
    options->labelsOption = &command.option(
        "--labels", options->labels, "The names of values." + explainChoices<sheet::LabelKind>(),
        {.value = "KIND", .showsDefault = true, .offers = {choiceNames<sheet::LabelKind>}});
    command.option("--difference", options->difference,
                   "first: every other picture shows its difference from the first, in the colours of "
                   "\"texshot compare -o\", and the number of different pixels.",
                   {.value = "FIRST", .offers = {[] { return std::vector<std::string>{firstPicture}; }}});
    command.flag("--no-metadata", options->withoutMetadata,
                 "Don't write texts into a PNG (how it was drawn, its axes and the complete scene).");
    command.option(
        "-o,--out", options->out,
        fmt::format(
            "The sheet to write, with the format of its extension: {}; - for standard output, as PNG. For "
            "several pages a name with {{page}} or a place of the third axis in it, "
            "'sheet-{{magFilter}}.png'. With a place for every axis, or {{number}}, each picture is a "
            "separate file, as of \"texshot shot\": '{{wrapS}}-{{minFilter}}.png'. {{scene}}, "
            "{{renderer}}, {{time}} and {{size}} are allowed anywhere.",
            writtenExtensions(" or ")),
        {.value = "FILE", .required = true});
    command.flag(
        "--json", options->json,
        "Print the result as JSON, for programs: for each sheet its file, size, axes and driver, and for "
        "each cell its place in pixels from the upper left, values and warnings, or an error.");
    command.footer(fmt::format(
        "--size is the size of each picture, whose pixels equal those of \"texshot shot\" with these "
        "values. A sheet has at most {0} × {0} pixels; a call draws at most {1} pictures onto sheets. If a "
        "picture can't be drawn, its error is reported, also in its place on the sheet, and the others "
        "continue.\n"
        "Exit status: 0 done, 1 a picture couldn't be drawn or a file written, 2 invalid arguments, 130 "
        "Ctrl+C: files written so far are complete.",
        sheet::maxSheetExtent, sheet::maxPictures));
    command.onCall([options] { return sweep(*options); });
}

} // namespace texplorer::screenshot
