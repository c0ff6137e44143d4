#pragma once

#include "texplorer/suite/record.h"

namespace texplorer::suite {

struct Merged {
    RunRecord run;                     ///< of all shards, as shard 1 of 1
    std::vector<std::string> problems; ///< sentences about cases that two records or none have
    int status = 0;                    ///< exitStatus, or 2 if a case is missing
};

/// Joins the records of shards; `names` are their names in messages (their files), one for each. If several
/// records have a case, the one with the later attempt is used; of equal attempts, the worse one. Errors:
/// OutOfRange without records, or if they are of different suites or cases.
[[nodiscard]] Result<Merged> merge(const std::vector<RunRecord>& records,
                                   const std::vector<std::string>& names);

} // namespace texplorer::suite
