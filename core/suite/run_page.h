#pragma once

#include "core/report/page.h"
#include "core/suite/record.h"

namespace texplorer::suite {

struct RunPageOptions {
    std::string
        acceptCommand{}; ///< "texshot test suite.json --accept accept.txt"; empty: nothing is accepted
    bool pixels = true;  ///< whether report::pixelsOf each picture lies beside it
};

/// The page of a run. A case for each record, and for each that has none yet.
[[nodiscard]] report::Page pageOf(const RunRecord& run, const RunPageOptions& options = {});

} // namespace texplorer::suite
