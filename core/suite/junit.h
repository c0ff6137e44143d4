#pragma once

#include "texplorer/suite/record.h"

namespace texplorer::suite {

/// Writes JUnit's XML for Jenkins, GitLab and others: a <testsuite> for each suite, a <testcase> for each
/// case. Failed, New, Crashed and TimedOut are a <failure>, MissingScene and Error an <error>, Skipped is
/// <skipped>. Planned cases that were not run are an <error>, too. Characters that XML 1.0 forbids become
/// U+FFFD.
[[nodiscard]] std::string asJunit(const RunRecord& run);

} // namespace texplorer::suite
