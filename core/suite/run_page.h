#pragma once

#include "texplorer/report/page.h"
#include "texplorer/suite/record.h"

namespace texplorer::suite {

/// Whether a case can be in the list for --accept: its picture differs from a stored golden, or has none yet.
[[nodiscard]] bool isAcceptable(const CaseRecord& record);

struct RunPageOptions {
    std::string
        acceptCommand{}; ///< "texshot test suite.json --accept accept.txt"; empty: nothing can be accepted
    bool pixels = true;  ///< report::pixelsOf each picture is next to it
};

/// Makes the page of a run: a case for each record, and for each one without a record yet.
[[nodiscard]] report::Page pageOf(const RunRecord& run, const RunPageOptions& options = {});

} // namespace texplorer::suite
