#include "texplorer/suite/shard.h"

#include "texplorer/base/sentence_format.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/suite/json_reader.h"
#include "texplorer/text/json_encoding.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>

namespace texplorer::suite {
namespace {

constexpr int durationsFormatVersion = 1;
constexpr std::size_t maxDurationsBytes = std::size_t{64} << 20;
constexpr double maxRecordedSeconds = 1e9;

double medianOf(std::vector<double> seconds) {
    if (seconds.empty())
        return 0;
    const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
    std::ranges::nth_element(seconds, middle);
    return *middle;
}

void readSeconds(const Json& json, Problem& problem, Durations& durations) {
    for (const auto& [name, value] : json.items()) {
        const double found = value.is_number() ? value.get<double>() : -1;
        if (!(found >= 0 && found <= maxRecordedSeconds) && !problem)
            problem = Error{
                ErrorCode::OutOfRange,
                Sentence("expected seconds from 0 to {0}, found {1}", maxRecordedSeconds, foundText(value)),
                atPointer("/seconds/" + pointerStep(shortened(name)))};
        durations.emplace(name, found);
    }
}

/// Seconds for each of the names, the median for unknown ones; empty if none is known.
std::vector<double> weightsOf(std::span<const std::string> names, const Durations& durations) {
    std::vector<double> known;
    std::vector<double> weights(names.size(), -1);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto found = durations.find(names[i]);
        if (found != durations.end() && std::isfinite(found->second) && found->second >= 0)
            known.push_back(weights[i] = found->second);
    }
    if (known.empty())
        return {};
    const double median = medianOf(std::move(known));
    std::ranges::replace(weights, -1.0, median);
    return weights;
}

/// Which shard each name is dealt to: the longest first, to the one that has least to do. Of two as long the
/// first name goes first, of two as free the first shard gets it.
std::vector<int> dealtOut(const std::vector<double>& weights, int shards) {
    std::vector<std::size_t> order(weights.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t i) { return weights[i]; });
    struct Load {
        double seconds;
        std::size_t cases;
        int shard;
        auto operator<=>(const Load&) const = default;
    };
    std::priority_queue<Load, std::vector<Load>, std::greater<>> loads;
    for (int shard = 1; shard <= shards; ++shard)
        loads.push({0, 0, shard});
    std::vector<int> dealt(weights.size());
    for (const std::size_t each : order) {
        Load least = loads.top();
        loads.pop();
        dealt[each] = least.shard;
        loads.push({least.seconds + weights[each], least.cases + 1, least.shard});
    }
    return dealt;
}

} // namespace

std::vector<std::size_t> casesOfShard(std::span<const std::string> names, const Shard& shard,
                                      const Durations& durations) {
    const std::vector<double> weights = weightsOf(names, durations);
    std::vector<std::size_t> chosen;
    if (weights.empty()) {
        for (auto i = static_cast<std::size_t>(shard.number - 1); i < names.size();
             i += static_cast<std::size_t>(shard.count))
            chosen.push_back(i);
        return chosen;
    }
    const std::vector<int> dealt = dealtOut(weights, shard.count);
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (dealt[i] == shard.number)
            chosen.push_back(i);
    }
    return chosen;
}

Result<Durations> parseDurations(std::string_view text) {
    const Result<Json> json = parseStrictJson(text, maxDurationsBytes);
    if (!json)
        return fail(json.error());
    Durations durations;
    Problem problem;
    {
        JsonObject object(*json, "", problem);
        readVersion(object, "version", durationsFormatVersion);
        const Json* seconds = object.need("seconds");
        if (seconds && !seconds->is_object())
            object.expect("seconds", "an object");
        else if (seconds)
            readSeconds(*seconds, problem, durations);
    }
    if (problem)
        return fail(*problem);
    return durations;
}

std::string writeDurations(const Durations& durations) {
    Json seconds = Json::object();
    for (const auto& [name, each] : durations)
        seconds[name] = each;
    return dumpJson(Json{{"version", durationsFormatVersion}, {"seconds", std::move(seconds)}}, 2) + "\n";
}

Durations durationsOf(const RunRecord& run, Durations before) {
    for (const CaseRecord& each : run.cases) {
        const bool ran = each.state == State::Passed || each.state == State::Failed ||
                         each.state == State::New || each.state == State::Resized;
        if (ran && std::isfinite(each.seconds) && each.seconds >= 0)
            before[each.name] = each.seconds;
    }
    return before;
}

} // namespace texplorer::suite
