#pragma once

#include "core/suite/record.h"

namespace texplorer::suite {

inline constexpr int recordFormatVersion = 1;
inline constexpr std::size_t maxRecordBytes = std::size_t{256} << 20;

/// The final report: everything of the run, with counts and the exit status, indented.
[[nodiscard]] std::string asJson(const RunRecord& run);

/// The journal of a run that isn't over: a line for the run, then one for each case as it ends. Each ends
/// with a line feed and is to be written at once, so that a killed run leaves whole lines and perhaps a
/// broken last one.
[[nodiscard]] std::string journalStart(const RunRecord& run); ///< without its cases
[[nodiscard]] std::string journalLine(const CaseRecord& record);

struct Journal {
    RunRecord run;              ///< with the last record of each case
    std::size_t wholeBytes = 0; ///< to cut the file to before more is appended
    std::string note{};         ///< a sentence where the last line was cut off; empty: it wasn't
};

/// Errors: Malformed with the line, of any line but a last one without its line feed.
[[nodiscard]] Result<Journal> parseJournal(std::string_view text);

/// A final report, or a journal, whichever it is. Malformed, Unsupported, TooLarge, OutOfRange.
[[nodiscard]] Result<RunRecord> parseRun(std::string_view text);

/// Whether a journal is of the run that begins now: the same program, plan, shard and driver. Else the error
/// says what differs.
[[nodiscard]] Result<void> checkResumable(const RunRecord& journal, const RunRecord& now);

/// One record, as on a line of a journal: what a worker hands back.
[[nodiscard]] Result<CaseRecord> parseCaseRecord(std::string_view json);

} // namespace texplorer::suite
