#include "texplorer/suite/merge.h"

#include "texplorer/base/sentence_format.h"
#include "texplorer/scene/params/param_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <unordered_map>

namespace texplorer::suite {
namespace {

/// A record's case among those that are joined.
struct Joined {
    const CaseRecord* record;
    std::size_t from;
};

/// In the order in which one is worse than the next.
constexpr std::array worstFirst{State::Crashed, State::TimedOut, State::Error,   State::MissingScene,
                                State::Failed,  State::Resized,  State::Missing, State::Extra,
                                State::New,     State::Skipped,  State::Passed};
static_assert(worstFirst.size() == stateRows.size());

bool isWorse(const CaseRecord& a, const CaseRecord& b) {
    if (a.attempt != b.attempt)
        return a.attempt > b.attempt;
    return std::ranges::find(worstFirst, a.state) < std::ranges::find(worstFirst, b.state);
}

/// A sentence for the first few names, and how many more there are.
std::string listed(const std::vector<std::string>& names) {
    constexpr std::size_t shown = 3;
    std::string text;
    for (std::size_t i = 0; i < std::min(shown, names.size()); ++i)
        text += fmt::format("{}{}", i == 0 ? "" : ", ", inQuotes(names[i]));
    return names.size() > shown ? fmt::format("{} and {} more", text, names.size() - shown) : text;
}

Result<void> checkSame(const std::vector<RunRecord>& records, const std::vector<std::string>& names) {
    if (records.empty())
        return fail(ErrorCode::OutOfRange, "expected the reports of a run's parts, found none");
    for (std::size_t i = 1; i < records.size(); ++i) {
        const auto differs = [&](std::string_view what) {
            return fail(
                ErrorCode::OutOfRange,
                Sentence("{0} and {1} are of different {2}", inQuotes(names[0]), inQuotes(names[i]), what),
                inFile(names[i]));
        };
        if (records[i].suites != records[0].suites)
            return differs("suites");
        if (records[i].plan != records[0].plan || records[i].planned != records[0].planned)
            return differs("cases of one suite: the suite or --only has changed");
        if (records[i].shard.count != records[0].shard.count)
            return differs("divisions into parts");
    }
    return {};
}

std::string joinedTexts(const std::vector<RunRecord>& records, std::string RunRecord::*member) {
    std::vector<std::string> texts;
    for (const RunRecord& each : records) {
        if (!(each.*member).empty() && std::ranges::find(texts, each.*member) == texts.end())
            texts.push_back(each.*member);
    }
    std::string joined;
    for (const std::string& text : texts)
        joined += (joined.empty() ? "" : ", ") + text;
    return joined;
}

std::string earliestStart(const std::vector<RunRecord>& records) {
    std::string earliest;
    for (const RunRecord& each : records) {
        if (!each.started.empty() && (earliest.empty() || each.started < earliest))
            earliest = each.started;
    }
    return earliest;
}

/// Of the whole run, where the record's is of a part of it.
std::string wholeCommand(const RunRecord& record) {
    const std::string part = fmt::format(" --shard {}/{}", record.shard.number, record.shard.count);
    std::string command = record.command;
    if (const std::size_t at = command.find(part); at != std::string::npos)
        command.erase(at, part.size());
    return command;
}

/// Reports the missing parts.
void sayAbsentShards(const std::vector<RunRecord>& records, Merged& merged) {
    std::set<int> there;
    for (const RunRecord& each : records)
        there.insert(each.shard.number);
    const int count = records.front().shard.count;
    if (static_cast<int>(there.size()) >= count)
        return;
    std::vector<std::string> absent;
    for (int shard = 1; shard <= count; ++shard) {
        if (!there.contains(shard))
            absent.push_back(fmt::format("{}/{}", shard, count));
    }
    merged.problems.push_back(fmt::format("there is no report of {}", listed(absent)));
}

} // namespace

Result<Merged> merge(const std::vector<RunRecord>& records, const std::vector<std::string>& names) {
    if (const Result<void> same = checkSame(records, names); !same)
        return fail(same.error());
    Merged merged;
    RunRecord& run = merged.run;
    run.program = joinedTexts(records, &RunRecord::program);
    run.command = wholeCommand(records.front());
    run.suites = records.front().suites;
    run.driver = joinedTexts(records, &RunRecord::driver);
    run.version = joinedTexts(records, &RunRecord::version);
    run.plan = records.front().plan;
    run.planned = records.front().planned;
    run.started = earliestStart(records);

    std::set<std::string_view> named;
    std::unordered_map<std::string_view, Joined> joined;
    std::vector<std::string> twice;
    for (std::size_t i = 0; i < records.size(); ++i) {
        run.seconds += records[i].seconds;
        for (const std::string& name : records[i].names) {
            if (named.insert(name).second)
                run.names.push_back(name);
        }
        for (const CaseRecord& each : records[i].cases) {
            const auto [found, isNew] = joined.emplace(each.name, Joined{&each, i});
            if (isNew)
                continue;
            twice.push_back(each.name);
            if (isWorse(each, *found->second.record))
                found->second = {&each, i};
        }
    }
    for (const std::string& name : run.names) {
        if (const auto found = joined.find(name); found != joined.end())
            run.cases.push_back(*found->second.record);
    }
    if (!twice.empty())
        merged.problems.push_back(Sentence::plural("{0} case is in several reports: {1}",
                                                   "{0} cases are in several reports: {1}", twice.size(),
                                                   listed(twice)));
    sayAbsentShards(records, merged);
    if (const std::vector<std::string> missing = run.missing(); !missing.empty())
        merged.problems.push_back(Sentence::plural("{0} case was not run: {1}", "{0} cases were not run: {1}",
                                                   missing.size(), listed(missing)));
    const bool hasHoles = run.cases.size() < run.planned;
    if (hasHoles && run.names.size() < run.planned)
        merged.problems.push_back(fmt::format("{} of {} are in no report", run.planned - run.names.size(),
                                              Sentence::plural("{0} case", "{0} cases", run.planned)));
    merged.status = hasHoles ? 2 : exitStatus(run);
    return merged;
}

} // namespace texplorer::suite
