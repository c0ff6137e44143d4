#pragma once

#include "app/screenshot/runs/test_run.h"
#include "texplorer/suite/shard.h"

#include <span>

namespace texplorer::screenshot {

/// What the command line says of which cases there are, beside RunSetup.
struct RunChoice {
    suite::Shard shard{};
    suite::Durations durations{};
    std::optional<std::string> accepted{}; ///< an accept list's text: its cases alone, whose goldens are
                                           ///< written
    std::string acceptedFrom{};            ///< the list's name, for its errors
    bool update = false;                   ///< every golden that is new or different is written
    double seconds = 0;                    ///< after which a case has hung; 0: as its suite says
};

/// What the files of setup.suites have, with its renderers and only. A worker reads them as the program does
/// that it works for.
[[nodiscard]] Result<suite::Plan> readPlan(const RunSetup& setup);

/// The cases of suites. `setup` has suites, renderers and only; it gets its plan.
[[nodiscard]] Result<PlannedRun> planSuites(RunSetup setup, const RunChoice& choice);

/// The PNGs of the folders setup.actual and setup.golden.
[[nodiscard]] Result<PlannedRun> planPictures(const RunSetup& setup, const RunChoice& choice);

} // namespace texplorer::screenshot
