#pragma once

#include "core/report/page.h"
#include "core/suite/record.h"

namespace texplorer::suite {

/// Whether a case can go to the list for --accept: its picture is another one than a stored golden, or the
/// first.
[[nodiscard]] bool isAcceptable(const CaseRecord& record);

struct RunPageOptions {
    std::string
        acceptCommand{}; ///< "texshot test suite.json --accept accept.txt"; empty: nothing is accepted
    bool pixels = true;  ///< whether report::pixelsOf each picture lies beside it
};

/// The page of a run. A case for each record, and for each that has none yet.
[[nodiscard]] report::Page pageOf(const RunRecord& run, const RunPageOptions& options = {});

} // namespace texplorer::suite
