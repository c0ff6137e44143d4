#include "app/screenshot/arguments/choice_argument.h"
#include "app/screenshot/arguments/context_argument.h"
#include "app/screenshot/arguments/option_use.h"
#include "app/screenshot/arguments/picture_argument.h"
#include "app/screenshot/arguments/scene_argument.h"
#include "app/screenshot/command.h"
#include "app/screenshot/gl/gl_module.h"
#include "app/screenshot/output/interrupts.h"
#include "app/screenshot/output/long_work.h"
#include "app/screenshot/output/output.h"
#include "app/ui/window/smallest_window.h"
#include "core/diagnosis/diagnosis.h"
#include "core/image/convert.h"
#include "core/reference/draw.h"
#include "core/reference/false_colors.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace texplorer::screenshot {
namespace {

using reference::AnisotropyMethod;

struct ShotOptions {
    SceneArgument scene;
    PictureArgument picture;
    ContextArgument context;
    bool window = false;
    std::string tab;
    std::string figure;
    std::string layout;
    std::string theme;
    std::string language;
    std::string scale;
    int tour = 0;
    std::string section;
    std::string probe;
    std::string renderer = std::string(rowOf(RendererKind::Fixed).name);
    std::string compared;
    std::string shown = std::string(rowOf(reference::Shown::Picture).name);
    reference::LevelQuestion shownUnit;
    std::string shaders;
    std::vector<std::string> pretended;
    std::string out;
    const Option* rendererOption = nullptr;
    const Option* shownOption = nullptr;
    const Option* shadersOption = nullptr;
};

/// "vertices, commands, …"
template<class Rows>
std::string namesOf(const Rows& rows) {
    std::string names;
    for (const auto& row : rows)
        names += (names.empty() ? "" : ", ") + std::string(row.name);
    return names;
}

/// The row with this name; `option` is named in the error.
template<class Rows>
Result<typename Rows::value_type> parseRow(const Rows& rows, std::string_view name, const char* option) {
    for (const auto& row : rows) {
        if (row.name == name)
            return row;
    }
    return fail(ErrorCode::OutOfRange, fmt::format("expected one of {}, found \"{}\"", namesOf(rows), name),
                option);
}

Result<std::optional<ui::Tab>> parseTab(std::string_view name) {
    if (name.empty())
        return std::nullopt;
    return parseRow(ui::tabRows, name, "--tab").map([](const ui::TabRow& row) {
        return std::optional(row.tab);
    });
}

Result<std::optional<ui::Figure>> parseFigure(std::string_view name) {
    if (name.empty())
        return std::nullopt;
    return parseRow(ui::figureRows, name, "--figure").map([](const ui::FigureRow& row) {
        return std::optional(row.figure);
    });
}

Result<ui::LayoutRow> parseLayout(std::string_view name) {
    if (name.empty())
        return ui::layoutRows.front();
    return parseRow(ui::layoutRows, name, "--layout");
}

Result<ui::Theme> parseTheme(std::string_view name) {
    if (name.empty())
        return ui::Settings{}.theme;
    return parseRow(ui::themeRows, name, "--theme").map(&ui::ThemeRow::theme);
}

Result<ui::Language> parseLanguage(std::string_view name) {
    if (name.empty())
        return ui::Language::English;
    return parseRow(ui::languageRows, name, "--language").map(&ui::LanguageRow::language);
}

constexpr float leastScale = 0.5F;
constexpr float largestScale = 4;

Result<float> parseScale(std::string_view text) {
    if (text.empty())
        return 1.0F;
    float scale = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, scale);
    if (error == std::errc() && stop == end && scale >= leastScale && scale <= largestScale)
        return scale;
    return fail(ErrorCode::OutOfRange,
                fmt::format("expected a number from {} to {}, found \"{}\"", leastScale, largestScale, text),
                "--scale");
}

Result<std::optional<ui::Section>> parseSection(std::string_view name) {
    if (name.empty())
        return std::nullopt;
    return parseRow(ui::sectionRows, name, "--section").map([](const ui::SectionRow& row) {
        return std::optional(row.section);
    });
}

Result<std::optional<reference::PixelPlace>> parseProbe(std::string_view text) {
    if (text.empty())
        return std::nullopt;
    std::array<int, 2> place{};
    if (parseNumbers(text, place) && place[0] >= 0 && place[1] >= 0)
        return reference::PixelPlace{place[0], place[1]};
    return fail(ErrorCode::OutOfRange, fmt::format("expected X,Y, found \"{}\"", text), "--probe");
}

/// "fixed,reference"
Result<std::vector<RendererKind>> parseCompared(std::string_view text) {
    constexpr const char* option = "--compare";
    std::vector<RendererKind> renderers;
    for (bool more = !text.empty(); more;) {
        const std::size_t end = std::min(text.find(','), text.size());
        more = end < text.size(); // a comma at the end asks for one more
        const Result<RendererKind> renderer = parseChoice<RendererKind>(text.substr(0, end), option);
        if (!renderer)
            return fail(renderer.error());
        if (std::ranges::find(renderers, *renderer) != renderers.end())
            return fail(ErrorCode::OutOfRange,
                        fmt::format("expected each renderer once, found \"{}\" twice", text.substr(0, end)),
                        option);
        renderers.push_back(*renderer);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (renderers.size() == 1)
        return fail(ErrorCode::OutOfRange, "expected two renderers or more, found one", option);
    return renderers;
}

/// Without OpenGL: the module that holds it is not even loaded.
Result<Shot> drawByReference(const ShotRequest& request) {
    Result<Frame> drawn = reference::drawReference(request.drawRequest(),
                                                   {.levels = request.levels, .stop = request.levels.stop});
    if (!drawn)
        return fail(drawn.error());
    return Shot{std::move(*drawn), {}};
}

/// Of the unit's levels of detail or footprints; transparent where it samples nothing.
Result<Shot> drawFalseColors(const ShotRequest& request) {
    Result<reference::LevelMap> map = reference::levelMap(
        request.drawRequest(), request.shownUnit, {.levels = request.levels, .stop = request.levels.stop});
    if (!map)
        return fail(map.error());
    return Shot{{reference::falseColors(*map, request.shown), std::move(map->problems)}, {}};
}

Result<Shot> drawAsAsked(const ShotRequest& request) {
    if (request.window || request.renderer != RendererKind::Reference)
        return draw(request);
    return request.shown == reference::Shown::Picture ? drawByReference(request) : drawFalseColors(request);
}

ExitCode shoot(const ShotOptions& options) {
    const Result<view::Size> size =
        parsePictureSize(options.picture.size, options.window ? ui::smallestWindow : view::Size{1, 1});
    if (!size)
        return complain(size.error(), wrongCall);
    const Result<double> time = parseTime(options.picture.time);
    if (!time)
        return complain(time.error(), wrongCall);

    const Result<std::optional<ui::Tab>> tab = parseTab(options.tab);
    if (!tab)
        return complain(tab.error(), wrongCall);
    const Result<std::optional<ui::Figure>> figure = parseFigure(options.figure);
    if (!figure)
        return complain(figure.error(), wrongCall);
    const Result<ui::LayoutRow> layout = parseLayout(options.layout);
    if (!layout)
        return complain(layout.error(), wrongCall);
    const Result<ui::Theme> theme = parseTheme(options.theme);
    if (!theme)
        return complain(theme.error(), wrongCall);
    const Result<ui::Language> language = parseLanguage(options.language);
    if (!language)
        return complain(language.error(), wrongCall);
    const Result<float> scale = parseScale(options.scale);
    if (!scale)
        return complain(scale.error(), wrongCall);
    const Result<std::optional<ui::Section>> section = parseSection(options.section);
    if (!section)
        return complain(section.error(), wrongCall);

    const Result<RendererKind> renderer = parseChoice<RendererKind>(options.renderer, "--renderer");
    if (!renderer)
        return complain(renderer.error(), wrongCall);
    const Result<AnisotropyMethod> anisotropy = parseAnisotropy(options.picture.anisotropy);
    if (!anisotropy)
        return complain(anisotropy.error(), wrongCall);
    if (options.picture.anisotropyOption->isGiven() && !options.window &&
        *renderer != RendererKind::Reference)
        return refuseUnused("--anisotropy", "OpenGL's driver decides, only the reference has a choice");
    if (options.shadersOption->isGiven() && !options.window && *renderer != RendererKind::Shader)
        return refuseUnused("--shaders", "it is for --renderer shader and --ui");
    const Result<view::Pretence> pretence = view::Pretence::parse(options.pretended);
    if (!pretence)
        return complain(pretence.error(), wrongCall);
    if (!options.pretended.empty() && !options.window && *renderer == RendererKind::Reference)
        return refuseUnused("--pretend", "it is about OpenGL's driver, which the reference doesn't ask");
    const Result<view::ContextChoice> context = parseContext(options.context);
    if (!context)
        return complain(context.error(), wrongCall);
    if (options.context.option->isGiven() && !options.window && *renderer == RendererKind::Reference)
        return refuseUnused("--context", "it is about OpenGL, which the reference doesn't ask");
    if (options.rendererOption->isGiven() && !options.compared.empty())
        return refuseUnused("--renderer", "--compare names the renderers");

    const Result<reference::Shown> shown = parseChoice<reference::Shown>(options.shown, "--show");
    if (!shown)
        return complain(shown.error(), wrongCall);
    if (options.shownOption->isGiven() && !options.window && *renderer != RendererKind::Reference)
        return refuseUnused("--show", "it is for --renderer reference and --ui");

    const Result<std::optional<reference::PixelPlace>> probed = parseProbe(options.probe);
    if (!probed)
        return complain(probed.error(), wrongCall);

    const Result<std::vector<RendererKind>> compared = parseCompared(options.compared);
    if (!compared)
        return complain(compared.error(), wrongCall);

    const auto output = openImageOutput(options.out, "PNG");
    if (!output)
        return output.error();

    auto opened = openScene(options.scene);
    if (!opened)
        return complain(opened.error().error, opened.error().code);
    ShotRequest request{std::move(opened->scene),
                        std::move(opened->images),
                        options.scene.file,
                        *time,
                        *size,
                        options.window,
                        *tab,
                        *probed,
                        *renderer,
                        *compared,
                        options.shaders,
                        *anisotropy,
                        *section};
    if (const auto loaded = request.images.load(request.scene); !loaded)
        return complain(inScene(options.scene, loaded.error()));
    std::optional<LongWork> compressing; // else Ctrl+C ends the program at once
    request.pretence = *pretence;
    request.context = *context;
    request.shown = *shown;
    request.shownUnit = options.shownUnit;
    request.figure = *figure;
    request.layout = *layout;
    request.theme = *theme;
    request.lesson = options.scene.lesson;
    request.lessonStep = options.scene.step - 1;
    request.language = *language;
    request.tour = options.tour;
    request.scale = *scale;
    request.levels.cache = BlockCache::ofUser();
    if (std::ranges::find(request.scene.textures, Compression::Cached, &Texture::compression) !=
        request.scene.textures.end()) {
        compressing.emplace("texshot: compressing");
        request.levels.progress = [&work = *compressing](float done) { work.report(done); };
        request.levels.stop = compressing->stopToken();
    }
    Result<Shot> shot = drawAsAsked(request);
    if (compressing)
        compressing->finish();
    if (request.levels.stop.stop_requested())
        return complainInterrupted();
    if (!shot)
        return complain(shot.error());
    for (const std::string& problem : shot->frame.problems)
        complain({ErrorCode::Driver, problem, {}});
    for (const Finding& each : diagnose(request.scene, request.images, shot->driver)) {
        if (each.severity <= Severity::Warning && !each.reportedByRenderer) // else it is a problem already
            complain({ErrorCode::Malformed, each.sentence, each.path});
    }
    // What one sees: a viewer would let its own background through the framebuffer's alpha. False colours are
    // no framebuffer: where there is none, there is nothing.
    const bool isPicture = request.window || request.shown == reference::Shown::Picture;
    const TextureImage seen =
        textureOf(isPicture ? withoutAlpha(std::move(shot->frame.image)) : std::move(shot->frame.image), {});
    if (const auto written = output->write(seen); !written)
        return complain(written.error());
    return success;
}

} // namespace

void addShot(CommandLine& line) {
    Command& command = line.command("shot", "Draw a scene into a picture.");
    auto options = std::make_shared<ShotOptions>();
    addSceneOrLessonArgument(command, options->scene);
    addPictureArgument(command, options->picture);
    const Option& window = command.flag("--ui", options->window, "Draw the whole window with its panels.");
    command.option(
        "--tab", options->tab,
        fmt::format("With --ui: the tab that is in front where it lies, one of {}.", namesOf(ui::tabRows)),
        {.value = "TAB", .needs = &window});
    command.option("--figure", options->figure,
                   fmt::format("With --ui: the figure that is in front with its tab, one of {}.",
                               namesOf(ui::figureRows)),
                   {.value = "FIGURE", .needs = &window});
    command.option("--layout", options->layout,
                   fmt::format("With --ui: which panels are open, one of {}.", namesOf(ui::layoutRows)),
                   {.value = "LAYOUT", .needs = &window});
    command.option("--theme", options->theme,
                   fmt::format("With --ui: the colours, one of {}.", namesOf(ui::themeRows)),
                   {.value = "THEME", .needs = &window});
    command.option(
        "--language", options->language,
        fmt::format("With --ui: the language of the window's texts, one of {}.", namesOf(ui::languageRows)),
        {.value = "LANGUAGE", .needs = &window});
    command.option("--scale", options->scale,
                   "With --ui: the size of text and controls, 0.5 to 4, as of a monitor with that scale.",
                   {.value = "S", .needs = &window});
    command.number("--tour", options->tour, 1, ui::tourSteps,
                   "With --ui: a step of the tour over the window.", {.needs = &window});
    command.option(
        "--section", options->section,
        fmt::format("With --ui: the part of the parameters that is opened, at their top, one of {}.",
                    namesOf(ui::sectionRows)),
        {.value = "SECTION", .needs = &window});
    command.option(
        "--probe", options->probe,
        "With --ui: the pixel of the picture that is explained, counted from the picture's top left.",
        {.value = "X,Y", .needs = &window});
    options->rendererOption = &command.option("--renderer", options->renderer,
                                              fmt::format("The renderer that draws the scene, one of {}.",
                                                          listNames(EnumTable<RendererKind>::rows)),
                                              {.value = "RENDERER", .showsDefault = true});
    command.option("--compare", options->compared,
                   "With --ui: two renderers across one picture, as in fixed,reference; or all three and the "
                   "difference of the first two.",
                   {.value = "A,B", .needs = &window});
    options->shownOption = &command.option(
        "--show", options->shown,
        fmt::format(
            "With --renderer reference or --ui: the picture, or of one texture unit a number for each "
            "pixel in false colours, one of {}. lambda: the level of detail, from dark violet at the "
            "base level to yellow at the last one, black at 0 and below. anisotropy: how many times as "
            "long as wide the footprint is, from 1, dark violet, in equal steps to 2, 4, 8 and 16, "
            "yellow. Transparent where the unit samples nothing.",
            listNames(EnumTable<reference::Shown>::rows)),
        {.value = "WHAT", .showsDefault = true});
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
                   {.value = "WORDS", .oneEach = true});
    command.option(
        "-o,--out", options->out,
        fmt::format("The picture to write, its format by its extension: {}; - for standard output, as PNG.",
                    writtenExtensions(" or ")),
        {.value = "FILE", .required = true});
    command.onCall([options] { return shoot(*options); });
}

} // namespace texplorer::screenshot
