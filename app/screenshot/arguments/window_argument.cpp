#include "app/screenshot/arguments/window_argument.h"

#include "app/command_line/choice_argument.h"
#include "app/screenshot/arguments/picture_argument.h"
#include "app/screenshot/arguments/renderer_argument.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace texplorer::screenshot {
namespace {

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
        if (isSameName(row.name, name))
            return row;
    }
    return refuseChoice(namesIn(rows), name, option);
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

constexpr float minScale = 0.5F;
constexpr float maxScale = 4;

Result<float> parseScale(std::string_view text) {
    if (text.empty())
        return 1.0F;
    float scale = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, scale);
    if (error == std::errc() && stop == end && scale >= minScale && scale <= maxScale)
        return scale;
    return fail(ErrorCode::OutOfRange,
                Sentence("expected a number from {0} to {1}, found \"{2}\"", minScale, maxScale, text),
                atOption("--scale"));
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
    return fail(ErrorCode::OutOfRange, Sentence("expected X,Y, found \"{0}\"", text), atOption("--probe"));
}

/// "fixed,reference"
Result<std::vector<RendererKind>> parseCompared(std::string_view text) {
    constexpr const char* option = "--compare";
    if (text.empty())
        return std::vector<RendererKind>();
    Result<std::vector<RendererKind>> renderers = parseRenderers(text, option);
    if (renderers && renderers->size() == 1)
        return fail(ErrorCode::OutOfRange, "expected two renderers or more, found one", atOption(option));
    return renderers;
}

/// Into its place, or the error.
template<class T>
Result<void> take(Result<T> parsed, T& place) {
    if (!parsed)
        return fail(parsed.error());
    place = *std::move(parsed);
    return {};
}

} // namespace

void addWindowArgument(Command& command, const Option& window, WindowArgument& argument) {
    command.option("--tab", argument.tab,
                   fmt::format("With --ui: the selected tab, one of {}.", namesOf(ui::tabRows)),
                   {.value = "TAB", .needs = &window, .offers = {[] { return namesIn(ui::tabRows); }}});
    command.option("--figure", argument.figure,
                   fmt::format("With --ui: the selected figure, one of {}.", namesOf(ui::figureRows)),
                   {.value = "FIGURE", .needs = &window, .offers = {[] { return namesIn(ui::figureRows); }}});
    command.option("--layout", argument.layout,
                   fmt::format("With --ui: the layout of the panels, one of {}.", namesOf(ui::layoutRows)),
                   {.value = "LAYOUT", .needs = &window, .offers = {[] { return namesIn(ui::layoutRows); }}});
    command.option("--theme", argument.theme,
                   fmt::format("With --ui: the colours, one of {}.", namesOf(ui::themeRows)),
                   {.value = "THEME", .needs = &window, .offers = {[] { return namesIn(ui::themeRows); }}});
    command.option(
        "--language", argument.language,
        fmt::format("With --ui: the language of the window's texts, one of {}.", namesOf(ui::languageRows)),
        {.value = "LANGUAGE", .needs = &window, .offers = {[] { return namesIn(ui::languageRows); }}});
    command.option("--scale", argument.scale, "With --ui: the scale of text and controls, 0.5 to 4.",
                   {.value = "S", .needs = &window});
    command.flag("--large-controls", argument.largeControls,
                 "With --ui: controls are large enough for fingers.", {.needs = &window});
    command.number("--tour", argument.tour, 1, ui::tourSteps,
                   "With --ui: a step of the tour over the window.", {.needs = &window});
    command.option(
        "--section", argument.section,
        fmt::format("With --ui: the open section of the parameters, one of {}.", namesOf(ui::sectionRows)),
        {.value = "SECTION", .needs = &window, .offers = {[] { return namesIn(ui::sectionRows); }}});
    command.option("--probe", argument.probe,
                   "With --ui: the explained pixel, counted from the picture's top left.",
                   {.value = "X,Y", .needs = &window});
    command.option("--compare", argument.compared,
                   "With --ui: two renderers in one picture, as in fixed,reference; or all three and the "
                   "difference of the first two.",
                   {.value = "A,B", .needs = &window, .offers = {choiceNames<RendererKind>, true}});
}

Result<void> putWindow(const WindowArgument& argument, ShotRequest& request) {
    return take(parseTab(argument.tab), request.tab)
        .and_then([&] { return take(parseFigure(argument.figure), request.figure); })
        .and_then([&] { return take(parseLayout(argument.layout), request.layout); })
        .and_then([&] { return take(parseTheme(argument.theme), request.theme); })
        .and_then([&] { return take(parseLanguage(argument.language), request.language); })
        .and_then([&] { return take(parseScale(argument.scale), request.scale); })
        .and_then([&] { return take(parseSection(argument.section), request.section); })
        .and_then([&] { return take(parseProbe(argument.probe), request.probed); })
        .and_then([&] { return take(parseCompared(argument.compared), request.compared); })
        .map([&] {
            request.tour = argument.tour;
            request.largeControls = argument.largeControls;
        });
}

} // namespace texplorer::screenshot
