#pragma once

// A run of `texshot test`, as the program that has its worker processes do it.

#include "app/screenshot/runs/run_progress.h"
#include "app/screenshot/runs/work_order.h"
#include "texplorer/suite/plan.h"

#include <stop_token>

namespace texplorer::screenshot {

/// A case of the run.
struct RunItem {
    std::string name;
    std::size_t number = 0; ///< in the plan; of pictures: among all pairs
    bool hasActual = true;  ///< of pictures
    bool hasGolden = true;
    bool update = false;
    bool precise = false; ///< held against the reference: Mesa takes no shortcuts then
    double limit = 60;    ///< seconds
    double expected = 0;  ///< seconds that it took in the past: what takes longest begins first
    std::uint64_t pixels = 0;
};

struct PlannedRun {
    RunSetup setup;
    suite::Plan plan; ///< without cases: pictures are compared
    std::vector<RunItem> items;
    bool drawsWithOpenGl = false;
    suite::RunRecord run; ///< but for its driver, cases and seconds
};

struct RunOptions {
    unsigned processes = 1;
    bool failFast = false;
    bool resume = false; ///< setup.report has the journal of an interrupted run
    std::string acceptCommand;
    RunProgress::Says says = RunProgress::Says::OneLine;
    std::stop_token stop;
};

struct FinishedRun {
    suite::RunRecord run;
    std::vector<std::string> wrote; ///< goldens
    std::size_t resumed = 0;        ///< cases that the journal had
};

/// Has every item done, and writes the report where there is a folder. Errors: the folder; no driver, no
/// processes; Cancelled, which says how many are done and how to go on.
[[nodiscard]] Result<FinishedRun> runAll(const PlannedRun& planned, const RunOptions& options);

} // namespace texplorer::screenshot
