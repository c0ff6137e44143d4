#pragma once

#include "texplorer/suite/record.h"

namespace texplorer::suite {

inline constexpr int recordFormatVersion = 1;
inline constexpr std::size_t maxRecordBytes = std::size_t{256} << 20;

/// The final report: the whole run, with counts and the exit status, indented.
[[nodiscard]] std::string asJson(const RunRecord& run);

/// The journal of a running run: a line for the run, then one for each finished case. Each ends with a line
/// feed and must be written at once, so that a killed run leaves complete lines and at most one incomplete
/// last line.
[[nodiscard]] std::string journalStart(const RunRecord& run); ///< without its cases
[[nodiscard]] std::string journalLine(const CaseRecord& record);

struct Journal {
    RunRecord run;              ///< with the last record of each case
    std::size_t wholeBytes = 0; ///< truncate the file to this size before appending
    std::string note{};         ///< a sentence if the last line was incomplete; else empty
};

/// Errors: Malformed with the line; an incomplete last line is not an error.
[[nodiscard]] Result<Journal> parseJournal(std::string_view text);

/// Parses a final report or a journal. Errors: Malformed, Unsupported, TooLarge, OutOfRange.
[[nodiscard]] Result<RunRecord> parseRun(std::string_view text);

/// Checks that a journal belongs to the run that begins now: the same program, plan, shard and driver. The
/// error says what differs.
[[nodiscard]] Result<void> checkResumable(const RunRecord& journal, const RunRecord& now);

/// Parses one record, as in a line of a journal: the result of a worker.
[[nodiscard]] Result<CaseRecord> parseCaseRecord(std::string_view json);

} // namespace texplorer::suite
