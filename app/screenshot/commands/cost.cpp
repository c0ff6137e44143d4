// How long the driver takes for what documents call slow or fast.

#include "app/screenshot/arguments/context_argument.h"
#include "app/screenshot/arguments/scene_argument.h"
#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/gl/gl_module.h"
#include "app/screenshot/output/json_text.h"
#include "app/screenshot/output/long_work.h"
#include "app/screenshot/output/output.h"
#include "texplorer/text/printable.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace texplorer::screenshot {
namespace {

constexpr int maxPairs = 1000;

struct CostOptions {
    SceneArgument scene;
    int pairs = static_cast<int>(view::costPairs);
    ContextArgument context;
    std::vector<std::string> pretended{};
    bool json = false;
};

struct Measured {
    conform::Driver driver;
    std::string context;
    view::TextureCosts costs;
};

/// The texture of the first enabled unit.
view::CostSubject subjectOf(OpenedScene& opened) {
    for (const Pass& pass : opened.scene.passes) {
        for (const Unit& unit : pass.units) {
            const auto texture = static_cast<std::size_t>(unit.texture);
            if (!pass.enabled || !unit.enabled || texture >= opened.scene.textures.size())
                continue;
            const Texture& shown = opened.scene.textures[texture];
            const TexturePictures pictures = opened.images.picturesOf(shown);
            if (!pictures.base)
                return {unit.target, nullptr, N_("its image is not loaded")};
            return {unit.target,
                    std::make_shared<const PreparedLevels>(prepareLevels(shown, pictures, unit.target))};
        }
    }
    return {Target::Texture2D, nullptr, N_("no enabled unit has a texture")};
}

/// "12.3 µs (12.1 µs to 12.9 µs)"
std::string timesText(const Quartiles& times) {
    return fmt::format("{} ({} to {})", view::timeText(times.median).english(),
                       view::timeText(times.low).english(), view::timeText(times.high).english());
}

std::string costText(const Measured& measured) {
    std::string text = fmt::format("{}, {}\n", printable(measured.driver.name), measured.context);
    for (std::size_t i = 0; i < view::costRows.size(); ++i) {
        const view::CostRow& row = view::costRows.at(i);
        const view::CostTimes& times = measured.costs.at(i);
        text += fmt::format("\n{}: {}\n", row.name, row.label);
        if (times.lack.empty()) {
            const TimeComparison compared = compareTimes(times.times);
            text += fmt::format("  A  {:14}{}\n  B  {:14}{}\n", row.a.label, timesText(compared.a),
                                row.b.label, timesText(compared.b));
        }
        text += fmt::format("  {}\n  {}\n", printable(view::verdictOn(times).english()), row.claim);
    }
    text += "\nWhat these numbers can't tell:\n";
    for (const Sentence& limit : view::costLimits(measured.driver.name))
        text += fmt::format("  {}\n", limit.english());
    return text;
}

nlohmann::ordered_json jsonOf(const Quartiles& values) {
    return {{"low", values.low}, {"median", values.median}, {"high", values.high}};
}

std::string costJson(const Measured& measured) {
    auto rows = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < view::costRows.size(); ++i) {
        const view::CostRow& row = view::costRows.at(i);
        const view::CostTimes& times = measured.costs.at(i);
        nlohmann::ordered_json each{
            {"row", row.name}, {"label", row.label}, {"claim", messageJson(row.claim)}};
        if (!times.lack.empty()) {
            each["lack"] = messageJson(times.lack);
        } else {
            const TimeComparison compared = compareTimes(times.times);
            const auto variant = [](const char* label, const Quartiles& seconds,
                                    const std::vector<double>& samples) {
                return nlohmann::ordered_json{
                    {"label", label}, {"seconds", jsonOf(seconds)}, {"samples", samples}};
            };
            each["a"] = variant(row.a.label, compared.a, times.times.a);
            each["b"] = variant(row.b.label, compared.b, times.times.b);
            each["ratio"] = jsonOf(compared.ratio);
            each["differs"] = compared.differs;
            each["verdict"] = messageJson(view::verdictOn(times));
        }
        rows.push_back(std::move(each));
    }
    return documentText(
        nlohmann::ordered_json::array({{{"driver", measured.driver.name},
                                        {"version", measured.driver.version},
                                        {"context", measured.context},
                                        {"rows", std::move(rows)},
                                        {"limits", messagesJson(view::costLimits(measured.driver.name))}}}));
}

Result<Measured> measure(const CostOptions& options, OpenedScene& opened, const view::Pretence& pretence,
                         const view::ContextChoice& context) {
    const auto studio = openStudio({}, pretence, context);
    if (!studio)
        return fail(studio.error());
    LongWork work("texshot: measuring");
    Result<view::TextureCosts> costs = (*studio)->measure(
        subjectOf(opened), static_cast<std::size_t>(options.pairs),
        {.progress = [&work](float done) { work.report(done); }, .stop = work.stopToken()});
    work.finish();
    if (!costs)
        return fail(costs.error());
    return Measured{(*studio)->driver(), (*studio)->context(), *std::move(costs)};
}

ExitCode printCost(const CostOptions& options) {
    const auto context = parseContext(options.context);
    if (!context)
        return complain(context.error(), wrongCall);
    const Result<view::Pretence> pretence = view::Pretence::parse(options.pretended);
    if (!pretence)
        return complain(pretence.error(), wrongCall);
    auto opened = openScene(options.scene);
    if (!opened)
        return complain(opened.error().error, opened.error().code);
    if (const auto loaded = opened->images.load(opened->scene); !loaded)
        return complain(inScene(options.scene, loaded.error()));
    const Result<Measured> measured = measure(options, *opened, *pretence, *context);
    if (!measured)
        return complain(measured.error());
    const Result<void> printed = print(options.json ? costJson(*measured) : costText(*measured));
    return printed ? success : complain(printed.error());
}

} // namespace

void addCost(CommandLine& line) {
    Command& command =
        line.command("cost", "Measure what textures cost on the driver, against what documents claim.");
    auto options = std::make_shared<CostOptions>();
    addSceneOrLessonArgument(command, options->scene);
    command.number("--pairs", options->pairs, 1, maxPairs,
                   "The number of pairs of times in each row. Fewer than 20 are too few for a verdict.",
                   {.showsDefault = true});
    addContextArgument(command, options->context);
    command.option("--pretend", options->pretended, view::pretenceHelp(),
                   {.value = "WORDS", .oneEach = true, .offers = {view::pretenceWords, true}});
    command.flag("--json", options->json, "As JSON, for programs, with all times.");
    command.footer(
        "Each row has two variants, A and B, that draw a square with a texture: bind or upload, 256 × 256 or 128 × "
        "128, compressed or not, with mipmaps or not, and filters. They are measured in turns. Printed are the "
        "medians of the times, the quartiles of these and of the ratio B/A, and whether that shows a difference: "
        "three quarters of the pairs must agree. The row \"scene\" has the texture of the scene's first enabled "
        "unit.\n"
        "Exit status: 0 done, 1 the scene can't be read or nothing can be drawn, 2 invalid arguments.");
    command.onCall([options] { return printCost(*options); });
}

} // namespace texplorer::screenshot
