#pragma once

// A sweep's report for people, for programs, and as a folder to look around in.

#include "core/conform/sweep.h"
#include "core/report/report_files.h"

#include <string>
#include <vector>

namespace texplorer::conform {

/// An aligned table for each pair, with what was skipped and why below it.
[[nodiscard]] std::string asText(const Report& report);

/// Everything that the text says, and the tallies by shape.
[[nodiscard]] std::string asJson(const Report& report);

/// What the file with it is called in a report's folder.
inline constexpr const char* reportName = "report.json";

/// Whether a text is what asJson has written.
[[nodiscard]] bool isReport(const std::string& json);

/// What features there are, with the rules that they are held to.
[[nodiscard]] std::string listing();
/// The same for programs: "features", "rules" and "notCompared".
[[nodiscard]] std::string listingJson();

/// What came of it all: "all agree", "all agree, 4 of 300 comparisons skipped", "not all agree" or "nothing
/// was compared".
[[nodiscard]] std::string summary(const Report& report);

/// A case for each feature and pair, with its worst scene: its pictures, where it is worst, the rule and what
/// is allowed. Errors: those of the PNG encoder.
[[nodiscard]] Result<report::Page> asPage(const Report& report);

/// That page (core/report) with its pictures, report.json, and for each feature and pair its worst scene
/// ("wrap-reference-fixed.json", to open in the window) with the files that scenes name. Errors: those of
/// asPage.
[[nodiscard]] Result<std::vector<report::File>> asFolder(const Report& report);

/// "wrap-reference-fixed": what a worst scene's files are called before their extension.
[[nodiscard]] std::string worstName(const PairReport& pair, const Outcome& outcome);

} // namespace texplorer::conform
