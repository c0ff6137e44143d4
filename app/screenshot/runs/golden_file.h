#pragma once

// Goldens that a run writes.

#include "app/screenshot/runs/work_order.h"
#include "texplorer/suite/judge_case.h"

#include <filesystem>

namespace texplorer::screenshot {

/// Whether a new golden would make the case pass: it differs, holds no picture, or there is none yet, and it
/// is a stored one.
[[nodiscard]] bool isUpdatable(const suite::JudgedCase& judged);

/// Puts the picture in the golden's place, within the suite's folder, as a whole; then the case has passed.
/// Where that can't be done, it is in error.
[[nodiscard]] WorkAnswer writeGolden(const std::filesystem::path& folder, const std::string& golden,
                                     const Image& actual, suite::CaseRecord record);

/// The same with the bytes of a PNG.
[[nodiscard]] WorkAnswer writeGolden(const std::filesystem::path& folder, const std::string& golden,
                                     ByteView png, suite::CaseRecord record);

} // namespace texplorer::screenshot
