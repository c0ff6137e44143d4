#include "texplorer/suite/record.h"

#include "texplorer/base/error_name.h"
#include "texplorer/base/sentence.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/text/printable.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <unordered_map>
#include <unordered_set>

namespace texplorer::suite {
namespace {

bool parsePositive(std::string_view text, int& number) {
    constexpr int max = 1'000'000;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() && number >= 1 && number <= max;
}

/// Why cases were skipped: a reason for all that have it, under the name of the first.
std::string skippedText(const RunRecord& run) {
    struct Skipped {
        const CaseRecord* first;
        std::size_t count;
    };
    std::vector<Skipped> reasons;
    std::unordered_map<std::string_view, std::size_t> numbers;
    for (const CaseRecord& each : run.cases) {
        if (each.state != State::Skipped)
            continue;
        const auto [at, isNew] = numbers.try_emplace(each.sentence.english(), reasons.size());
        if (isNew)
            reasons.push_back({&each, 1});
        else
            ++reasons[at->second].count;
    }
    std::string text;
    for (const auto& [first, count] : reasons)
        text += fmt::format(
            "skipped: {}{}\n    {}\n", printable(first->name),
            count > 1 ? fmt::format(" and {}", Sentence::plural("{0} more case", "{0} more cases", count - 1))
                      : "",
            printable(first->sentence));
    return text;
}

bool isWorthALine(State state) {
    return state != State::Passed && state != State::Skipped;
}

} // namespace

const StateRow& rowOf(State state) {
    return stateRows[static_cast<std::size_t>(state)];
}

Result<Shard> parseShard(std::string_view text) {
    const std::size_t slash = text.find('/');
    Shard shard;
    if (slash == std::string_view::npos || !parsePositive(text.substr(0, slash), shard.number) ||
        !parsePositive(text.substr(slash + 1), shard.count))
        return fail(ErrorCode::Malformed,
                    Sentence("expected a part and how many there are, as in 2/5, found {0}", inQuotes(text)));
    if (shard.number > shard.count)
        return fail(ErrorCode::OutOfRange, Sentence("expected a part from 1 to {0}, as in 1/{0}, found {1}",
                                                    shard.count, shard.number));
    return shard;
}

std::size_t RunRecord::count(State state) const {
    return static_cast<std::size_t>(std::ranges::count(cases, state, &CaseRecord::state));
}

std::vector<std::string> RunRecord::missing() const {
    std::unordered_set<std::string_view> there;
    for (const CaseRecord& each : cases)
        there.insert(each.name);
    std::vector<std::string> absent;
    std::ranges::copy_if(names, std::back_inserter(absent),
                         [&](const std::string& name) { return !there.contains(name); });
    return absent;
}

CaseRecord problemOf(CaseRecord record, const Error& error, State state) {
    record.state = state;
    record.sentence = describe(error);
    record.code = nameOf(error.code);
    return record;
}

int exitStatus(const RunRecord& run) {
    const bool isEmptyPart = run.names.empty() && run.planned > 0; // more parts than cases
    if (isEmptyPart)
        return 0;
    if (run.cases.empty() || (!run.endedEarly && !run.missing().empty()))
        return 2;
    int status = 0;
    for (const CaseRecord& each : run.cases)
        status = std::max(status, rowOf(each.state).status);
    return status;
}

std::string summary(const RunRecord& run) {
    std::string text =
        Sentence::plural("{0} case", "{0} cases", run.names.empty() ? run.cases.size() : run.names.size());
    std::string_view separator = ": ";
    for (const StateRow& row : stateRows) {
        if (const std::size_t count = run.count(row.state); count > 0) {
            text += fmt::format("{}{} {}", separator, count, row.text);
            separator = ", ";
        }
    }
    if (const std::size_t missing = run.missing().size(); missing > 0)
        text += fmt::format("{}{} not run", separator, missing);
    return text;
}

std::string asText(const RunRecord& run) {
    std::string text;
    for (const CaseRecord& each : run.cases) {
        if (isWorthALine(each.state))
            text += fmt::format("{}: {}\n    {}\n", rowOf(each.state).text, printable(each.name),
                                printable(each.sentence));
    }
    text += skippedText(run);
    constexpr std::size_t shown = 20;
    const std::vector<std::string> missing = run.missing();
    for (std::size_t i = 0; i < std::min(shown, missing.size()); ++i)
        text += fmt::format("not run: {}\n", printable(missing[i]));
    if (missing.size() > shown)
        text += fmt::format("not run: {} more\n", missing.size() - shown);
    return text + summary(run) + "\n";
}

} // namespace texplorer::suite
