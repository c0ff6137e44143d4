#include "core/suite/run_page.h"

#include "core/base/percent.h"

#include <fmt/core.h>

#include <unordered_map>

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

std::vector<report::Fact> factsOf(const CaseRecord& record) {
    std::vector<report::Fact> facts;
    if (!record.renderer.empty())
        facts.push_back({"Renderer", record.renderer});
    if (!record.driver.empty())
        facts.push_back({"Driver", record.driver});
    if (!record.golden.empty())
        facts.push_back({"Held against", record.golden});
    if (!record.metric.empty()) {
        facts.push_back({"Metric", record.metric});
        facts.push_back({"Score", fmt::format("{:.6g}", record.score)});
        facts.push_back({"Tolerance", fmt::format("{:.6g}", record.tolerance)});
        facts.push_back({"Over it", fmt::format("{}, allowed {}", percentText(record.shareOver),
                                                percentText(record.share))});
    }
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

/// What stands before the first "/" of its name.
std::string groupOf(std::string_view name) {
    return std::string(name.substr(0, name.find('/')));
}

report::Case pageCase(const CaseRecord& record, const RunPageOptions& options) {
    report::Case shown{.name = record.name, .group = groupOf(record.name), .state = pageState(record.state)};
    shown.message = record.sentence;
    shown.expected = pictureOf("Expected", record.expectedPicture, options.pixels);
    shown.actual = pictureOf("Actual", record.actualPicture, options.pixels);
    shown.difference = pictureOf("Difference", record.differencePicture, options.pixels);
    shown.size = {record.width, record.height};
    if (record.worst)
        shown.worst = {record.worst->x, record.worst->y};
    shown.distance = record.shareOver;
    shown.seconds = record.seconds;
    shown.facts = factsOf(record);
    shown.explanation = record.explanation;
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
                              run.started, run.seconds);
    page.command = run.command;
    addFact(page.environment, "Driver", run.driver);
    addFact(page.environment, "Version", run.version);
    addFact(page.environment, "Settings", run.settings);
    if (run.shard.count > 1)
        addFact(page.environment, "Part", fmt::format("{} of {}", run.shard.number, run.shard.count));
    page.acceptCommand = options.acceptCommand;
    page.cases.reserve(run.cases.size());
    for (const CaseRecord& each : run.cases)
        page.cases.push_back(pageCase(each, options));
    for (const std::string& name : run.missing())
        page.cases.push_back(notRun(name));
    return page;
}

} // namespace texplorer::suite
