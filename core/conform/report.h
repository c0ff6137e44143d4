#pragma once

// A sweep's report for people, for programs, and as a folder to look around in.

#include "core/base/bytes.h"
#include "core/conform/sweep.h"

#include <string>
#include <vector>

namespace texplorer::conform {

/// An aligned table for each pair, with what was skipped and why below it.
[[nodiscard]] std::string asText(const Report& report);

/// Everything that the text says, and the tallies by shape.
[[nodiscard]] std::string asJson(const Report& report);

/// What features there are, with the rules that they are held to.
[[nodiscard]] std::string listing();

/// What came of it all: "all agree", "all agree, 4 of 300 comparisons skipped", "not all agree" or "nothing
/// was compared".
[[nodiscard]] std::string summary(const Report& report);

struct ReportFile {
    std::string name; ///< within the folder
    Bytes bytes;
};

/// report.json, index.html that holds everything one looks at, and for each feature and pair its worst scene
/// ("wrap-reference-fixed.json", to open in the window), both pictures and the heat map as PNG. Errors: those
/// of the PNG encoder.
[[nodiscard]] Result<std::vector<ReportFile>> asFolder(const Report& report);

/// "wrap-reference-fixed": what a worst scene's files are called before their extension.
[[nodiscard]] std::string worstName(const PairReport& pair, const Outcome& outcome);

} // namespace texplorer::conform
