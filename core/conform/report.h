#pragma once

// A sweep's report as text, as JSON, and as a folder with a page.

#include "texplorer/conform/sweep.h"
#include "texplorer/report/report_files.h"

#include <string>
#include <vector>

namespace texplorer::conform {

/// An aligned table for each pair, followed by what was skipped and why.
[[nodiscard]] std::string asText(const Report& report);

/// The content of the text, and the tallies by shape.
[[nodiscard]] std::string asJson(const Report& report);

/// The name of the JSON file in a report's folder.
inline constexpr const char* reportName = "report.json";

/// Whether a text was written by asJson.
[[nodiscard]] bool isReport(const std::string& json);

/// Lists the features with their rules.
[[nodiscard]] std::string listing();
/// The same as JSON: "features", "rules" and "notCompared".
[[nodiscard]] std::string listingJson();

/// The result in one phrase: "all agree", "all agree, 4 of 300 comparisons skipped", "not all agree" or
/// "nothing was compared".
[[nodiscard]] std::string summary(const Report& report);

/// A case for each feature and pair, with its worst scene: its pictures, the worst pixel, the rule and what
/// it allows. Errors: those of the PNG encoder.
[[nodiscard]] Result<report::Page> asPage(const Report& report);

/// That page (core/report) with its pictures, report.json, and for each feature and pair its worst scene
/// ("wrap-reference-fixed.json", for the window) with the files that the scenes refer to. Errors: those of
/// asPage.
[[nodiscard]] Result<std::vector<report::File>> asFolder(const Report& report);

/// "wrap-reference-fixed": the names of a worst scene's files, without extension.
[[nodiscard]] std::string worstName(const PairReport& pair, const Outcome& outcome);

} // namespace texplorer::conform
