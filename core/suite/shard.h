#pragma once

#include "core/suite/plan.h"
#include "core/suite/record.h"

#include <map>
#include <span>

namespace texplorer::suite {

/// Seconds of cases in the past, by their names.
using Durations = std::map<std::string, double, std::less<>>;

/// Which of the names are a shard's, in their order. With durations the longest is dealt first, each to the
/// shard that has least to do (Graham's LPT); a case that isn't in them takes as long as the median. Without
/// any: round robin. Every name is in exactly one of the shards, whatever the durations are, as long as all
/// shards are given the same.
[[nodiscard]] std::vector<std::size_t> casesOfShard(std::span<const std::string> names, const Shard& shard,
                                                    const Durations& durations = {});

/// {"version": 1, "seconds": {"bricks/fixed@512x512": 0.25}}. Malformed, TooLarge, OutOfRange (below 0,
/// infinite).
[[nodiscard]] Result<Durations> parseDurations(std::string_view json);
[[nodiscard]] std::string writeDurations(const Durations& durations);

/// Those of a run over those of before. Cases that were skipped or killed say nothing.
[[nodiscard]] Durations durationsOf(const RunRecord& run, Durations before = {});

} // namespace texplorer::suite
