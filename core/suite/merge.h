#pragma once

#include "core/suite/record.h"

namespace texplorer::suite {

struct Merged {
    RunRecord run;                     ///< of all shards, as shard 1 of 1
    std::vector<std::string> problems; ///< sentences: cases that two records have, and that none has
    int status = 0;                    ///< exitStatus, and 2 where a case is missing
};

/// Joins the records of shards; `names` are what they are called in sentences (their files), one for each. Of
/// a case that several have the one with the later attempt stays, or of the same the worse one. Errors:
/// OutOfRange where there is none, or where they are of different suites or cases.
[[nodiscard]] Result<Merged> merge(const std::vector<RunRecord>& records,
                                   const std::vector<std::string>& names);

} // namespace texplorer::suite
