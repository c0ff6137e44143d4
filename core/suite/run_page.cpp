#include "texplorer/suite/run_page.h"

#include "texplorer/compare/comparison.h"
#include "texplorer/compare/metric.h"
#include "texplorer/suite/case_command.h"
#include "texplorer/text/percent.h"
#include "texplorer/text/shell_word.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

namespace texplorer::suite {
namespace {

report::State pageState(State state) {
    switch (state) {
    case State::Passed:
        return report::State::Passed;
    case State::Failed:
        return report::State::Failed;
    case State::New:
        return report::State::New;
    case State::MissingScene:
    case State::Error:
        return report::State::Error;
    case State::Crashed:
        return report::State::Crashed;
    case State::TimedOut:
        return report::State::TimedOut;
    case State::Skipped:
        return report::State::Skipped;
    case State::Resized:
        return report::State::Resized;
    case State::Missing:
        return report::State::Missing;
    case State::Extra:
        return report::State::Extra;
    }
    return report::State::Error;
}

std::optional<report::Picture> pictureOf(std::string_view label, const std::string& file, bool hasPixels) {
    if (file.empty())
        return {};
    return report::Picture{.label = std::string(label), .file = file, .png = {}, .pixels = hasPixels};
}

std::string colorText(const std::array<std::uint8_t, 4>& color) {
    return fmt::format("{} {} {} {}", color[0], color[1], color[2], color[3]);
}

/// The metric's row; a rule has that of the absolute difference.
const MetricRow& metricOf(const CaseRecord& record) {
    const auto found = std::ranges::find(metricNameRows, std::string_view(record.metric), &EnumRow::name);
    return found == metricNameRows.end() ? metricRows.front() : metricRows.at(found->value);
}

/// "270 (0.351 %)"
std::string countText(std::size_t count, double share) {
    return fmt::format("{} ({})", count, percentText(share));
}

void addComparison(std::vector<report::Fact>& facts, const CaseRecord& record) {
    if (record.metric.empty())
        return;
    const MetricRow& metric = metricOf(record);
    facts.push_back({"Metric", record.metric});
    std::string score(metric.score);
    score.front() = static_cast<char>(std::toupper(score.front()));
    facts.push_back({score, fmt::format("{:.6g}{}", record.score, metric.unit)});
    const std::string allowed = "allowed " + percentText(record.share);
    const std::string over = fmt::format("Over {:.6g}{}", record.tolerance, metric.unit);
    if (record.unexplained) {
        facts.push_back({over, countText(record.over, record.shareOver)});
        facts.push_back(
            {"Unexplained",
             fmt::format("{}, {}",
                         *record.unexplained == 0 ? std::string("0")
                                                  : countText(*record.unexplained, record.shareThatCounts()),
                         allowed)});
    } else {
        facts.push_back({over, fmt::format("{}, {}", countText(record.over, record.shareOver), allowed)});
    }
}

/// What the colours of the difference mean: the values of the metric, which the map has in 255ths of its 1.
std::vector<report::Swatch> legendOf(const CaseRecord& record) {
    const MetricRow& metric = metricOf(record);
    const bool isAbsolute = metric.metric == Metric::Absolute;
    std::vector<report::Swatch> legend;
    for (const HeatStep& step : heatSteps(mapScale(metric.metric, record.tolerance))) {
        const auto& [red, green, blue, alpha] = step.color;
        const std::string label =
            isAbsolute ? std::to_string(step.difference) : fmt::format("{:.2g}", step.difference / 255.0);
        legend.push_back({label, {red, green, blue}});
    }
    return legend;
}

std::vector<report::Fact> factsOf(const CaseRecord& record) {
    std::vector<report::Fact> facts;
    if (!record.renderer.empty())
        facts.push_back({"Renderer", record.renderer});
    if (!record.driver.empty())
        facts.push_back({"Driver", record.driver});
    if (!record.settings.empty())
        facts.push_back({"Settings", record.settings});
    if (!record.golden.empty())
        facts.push_back({"Compared with", record.golden});
    addComparison(facts, record);
    if (record.worst) {
        facts.push_back({"Worst pixel", fmt::format("{}, {}", record.worst->x, record.worst->y)});
        facts.push_back({"Expected there", colorText(record.worst->expected)});
        facts.push_back({"Found there", colorText(record.worst->actual)});
    }
    if (record.signal != 0)
        facts.push_back({"Signal", fmt::format("{}", record.signal)});
    if (record.attempt > 1)
        facts.push_back({"Attempt", fmt::format("{}", record.attempt)});
    if (record.time != 0)
        facts.push_back({"Time", fmt::format("{} s", record.time)});
    return facts;
}

/// What stands before the first "/" of its name; without one it is in none.
std::string groupOf(std::string_view name) {
    const std::size_t slash = name.find('/');
    return slash == std::string_view::npos ? std::string() : std::string(name.substr(0, slash));
}

/// What draws the scene again that its actual picture holds; empty where it holds none.
std::string drawingCommand(const CaseRecord& record) {
    if (record.renderer.empty() || record.actualPicture.empty())
        return {};
    std::string command =
        fmt::format("texshot shot {} --renderer {} --size {}x{}", shellWord(record.actualPicture),
                    shellWord(record.renderer), record.width, record.height);
    if (record.time != 0)
        command += fmt::format(" --time {}", record.time);
    return command + " -o again.png";
}

void addCommands(report::Case& shown, const CaseRecord& record, const std::string& runCommand) {
    if (const std::string test = commandOfCase(runCommand, record.name); !test.empty())
        shown.commands.push_back({"To repeat it, in the folder of the run", test});
    if (const std::string drawing = drawingCommand(record); !drawing.empty()) {
        shown.commands.push_back({"To draw it again, in the report's folder", drawing});
        shown.links.push_back({"The actual picture, which contains the scene", record.actualPicture});
    }
}

/// "2026-11-22 02:30 UTC" of "2026-11-22T02:30:00Z"; another text as it is.
std::string timeText(const std::string& text) {
    const bool isStandard = text.size() == 20 && text[10] == 'T' && text[16] == ':' && text[19] == 'Z';
    return isStandard ? fmt::format("{} {} UTC", text.substr(0, 10), text.substr(11, 5)) : text;
}

report::Case pageCase(const CaseRecord& record, const std::string& runCommand,
                      const RunPageOptions& options) {
    report::Case shown{.name = record.name, .group = groupOf(record.name), .state = pageState(record.state)};
    shown.message = record.sentence.english();
    shown.expected = pictureOf("Expected", record.expectedPicture, options.pixels);
    shown.actual = pictureOf("Actual", record.actualPicture, options.pixels);
    shown.difference = pictureOf("Where it differs", record.differencePicture, options.pixels);
    if (shown.difference)
        shown.legend = legendOf(record);
    shown.size = {record.width, record.height};
    if (record.worst)
        shown.worst = {record.worst->x, record.worst->y};
    shown.distance = record.shareThatCounts();
    shown.seconds = record.seconds;
    shown.facts = factsOf(record);
    shown.explanation = record.explanation;
    addCommands(shown, record, runCommand);
    shown.acceptable = !options.acceptCommand.empty() && isAcceptable(record);
    return shown;
}

report::Case notRun(const std::string& name) {
    report::Case shown{.name = name, .group = groupOf(name), .state = report::State::NotRun};
    shown.message = "It was not run.";
    return shown;
}

report::Tone toneOf(const RunRecord& run) {
    const int status = exitStatus(run);
    return status == 0 ? report::Tone::Good : report::Tone::Bad;
}

void addFact(std::vector<report::Fact>& facts, std::string_view name, const std::string& value) {
    if (!value.empty())
        facts.push_back({std::string(name), value});
}

} // namespace

bool isAcceptable(const CaseRecord& record) {
    const bool isAnother = record.state == State::Failed || record.state == State::New ||
                           record.state == State::Resized || record.state == State::Extra;
    return isAnother && record.golden != "reference" && !record.actualPicture.empty();
}

report::Page pageOf(const RunRecord& run, const RunPageOptions& options) {
    report::Page page;
    for (const std::string& suite : run.suites)
        page.title += (page.title.empty() ? "" : ", ") + suite;
    page.verdict = summary(run);
    page.tone = toneOf(run);
    page.madeBy = fmt::format("{}{}{} in {:.1f} s", run.program, run.started.empty() ? "" : " on ",
                              timeText(run.started), run.seconds);
    page.command = run.command;
    addFact(page.environment, "Driver", run.driver);
    addFact(page.environment, "Version", run.version);
    if (run.shard.count > 1)
        addFact(page.environment, "Part", fmt::format("{} of {}", run.shard.number, run.shard.count));
    page.acceptCommand = options.acceptCommand;
    page.cases.reserve(run.cases.size());
    for (const CaseRecord& each : run.cases)
        page.cases.push_back(pageCase(each, run.command, options));
    for (const std::string& name : run.missing())
        page.cases.push_back(notRun(name));
    return page;
}

} // namespace texplorer::suite
