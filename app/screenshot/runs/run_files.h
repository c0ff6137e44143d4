#pragma once

// The files of a run, for who asks whether what it writes would take the place of what it reads.

#include "app/screenshot/runs/test_run.h"

#include <string>
#include <vector>

namespace texplorer::screenshot {

struct RunFiles {
    std::vector<std::string> read;    ///< suites, scenes, images, masks, the pictures of another program
    std::vector<std::string> goldens; ///< those that are there, and those that may be written
};

/// Of all cases, whatever part of them is run.
[[nodiscard]] RunFiles filesOfRun(const PlannedRun& planned);

} // namespace texplorer::screenshot
