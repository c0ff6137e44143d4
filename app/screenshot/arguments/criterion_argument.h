#pragma once

#include "app/command_line/command_line.h"
#include "texplorer/compare/criterion.h"

#include <string>

namespace texplorer::screenshot {

/// What two pictures are held to, as the command line spells it.
struct CriterionArgument {
    std::string metric{rowOf(Metric::Absolute).name};
    std::string tolerance;
    std::string share;
    std::string mask; ///< a picture's file; empty: none
    int pixelsPerDegree = 67;
    bool rgb = false;
    const Option* givenTolerance = nullptr;
    const Option* givenShare = nullptr;
    const Option* givenPixelsPerDegree = nullptr;
};

/// Declares --metric, --tolerance, --share, --mask, --rgb and --pixels-per-degree. `needs`: without which
/// they are refused.
void addCriterionArgument(Command& command, CriterionArgument& argument, const Option* needs = nullptr);

/// The error is about the option that is wrong, or has no effect.
[[nodiscard]] Result<Criterion> parseCriterion(const CriterionArgument& argument);

} // namespace texplorer::screenshot
