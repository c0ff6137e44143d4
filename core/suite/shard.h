#pragma once

#include "texplorer/suite/plan.h"
#include "texplorer/suite/record.h"

#include <map>
#include <span>

namespace texplorer::suite {

/// Seconds of cases in earlier runs, by name.
using Durations = std::map<std::string, double, std::less<>>;

/// Returns the indices of a shard's names, in order. With durations, the longest cases are assigned first,
/// each to the shard with the least to do (Graham's LPT); unknown cases count as the median. Without
/// durations: round robin. Every name is in exactly one shard if all shards use the same durations.
[[nodiscard]] std::vector<std::size_t> casesOfShard(std::span<const std::string> names, const Shard& shard,
                                                    const Durations& durations = {});

/// {"version": 1, "seconds": {"bricks/fixed@512x512": 0.25}}. Errors: Malformed, TooLarge, OutOfRange
/// (negative, infinite).
[[nodiscard]] Result<Durations> parseDurations(std::string_view json);
[[nodiscard]] std::string writeDurations(const Durations& durations);

/// Updates durations by those of a run. Skipped and killed cases are ignored.
[[nodiscard]] Durations durationsOf(const RunRecord& run, Durations before = {});

} // namespace texplorer::suite
