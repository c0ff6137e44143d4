#include "app/screenshot/arguments/criterion_argument.h"

#include "app/command_line/choice_argument.h"
#include "app/screenshot/arguments/option_use.h"

#include <fmt/core.h>

#include <cctype>

namespace texplorer::screenshot {
namespace {

std::string toleranceHelp() {
    std::string text = "The maximum value of a pixel. Default:";
    for (const MetricRow& each : metricRows)
        text += fmt::format("{} {:g} for {}", each.metric == metricRows.front().metric ? "" : ",",
                            each.tolerance, rowOf(each.metric).name);
    return text + ". absolute: of the worst component, in 255ths. ssim: 1 - SSIM. flip: the error, 0 to 1.";
}

Result<void> take(const Result<double>& number, double& to, const char* option) {
    if (!number)
        return fail(number.error().code, number.error().message, atOption(option));
    to = *number;
    return {};
}

} // namespace

void addCriterionArgument(Command& command, CriterionArgument& argument, const Option* needs) {
    const std::string of = needs == nullptr ? std::string() : fmt::format("With {}: ", needs->name());
    const auto help = [&of](std::string text) {
        if (!of.empty()) // the sentence goes on
            text.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
        return of + text;
    };
    command.option(
        "--metric", argument.metric, help("How the value of a pixel is measured.") + explainChoices<Metric>(),
        {.value = "METRIC", .showsDefault = true, .needs = needs, .offers = {choiceNames<Metric>}});
    argument.givenTolerance = &command.option("--tolerance", argument.tolerance, help(toleranceHelp()),
                                              {.value = "N", .needs = needs});
    argument.givenShare = &command.option(
        "--share", argument.share,
        help("The share of the pixels that may be above the tolerance: 0 to 1, or in percent as in 0.1%. "
             "Default: 0."),
        {.value = "P", .needs = needs});
    command.option(
        "--mask", argument.mask,
        help("A picture of the same size. Pixels that are black or fully transparent in it are ignored."),
        {.value = "FILE", .needs = needs});
    command.flag("--rgb", argument.rgb, help("Ignore alpha."), {.needs = needs});
    argument.givenPixelsPerDegree = &command.number(
        "--pixels-per-degree", argument.pixelsPerDegree, 1, 512,
        of + "flip: the pixels of the picture per degree of the viewer's field of view. 67 is a 4K screen "
             "of 0.7 m at a distance of 0.7 m.",
        {.showsDefault = true, .needs = needs});
}

Result<Criterion> parseCriterion(const CriterionArgument& argument) {
    const Result<Metric> metric = parseChoice<Metric>(argument.metric, "--metric");
    if (!metric)
        return fail(metric.error());
    Criterion criterion = criterionOf(*metric);
    if (argument.givenTolerance->isGiven()) {
        const Result<void> taken =
            take(parseTolerance(argument.tolerance, *metric), criterion.tolerance, "--tolerance");
        if (!taken)
            return fail(taken.error());
    }
    if (argument.givenShare->isGiven()) {
        if (const Result<void> taken = take(parseShare(argument.share), criterion.share, "--share"); !taken)
            return fail(taken.error());
    }
    criterion.compared = argument.rgb ? Compared::Rgb : Compared::Rgba;
    criterion.pixelsPerDegree = argument.pixelsPerDegree;
    if (argument.givenPixelsPerDegree->isGiven() && *metric != Metric::Flip)
        noteUnused("--pixels-per-degree", "it needs --metric flip");
    return criterion;
}

} // namespace texplorer::screenshot
