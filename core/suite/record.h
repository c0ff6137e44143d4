#pragma once

// What came of cases, as values.

#include "core/base/result.h"
#include "core/gl/enum_row.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::suite {

enum class State : std::uint32_t {
    Passed,
    Failed,       ///< another picture than the golden
    New,          ///< there is no golden yet
    MissingScene, ///< the file isn't there
    Error,        ///< the scene, a golden or the drawing: the sentence says what
    Crashed,      ///< a signal ended its process
    TimedOut,
    Skipped,
    Resized, ///< of another size than its golden
    Missing, ///< a golden without a picture, of --pictures
    Extra,   ///< a picture without a golden, of --pictures
};

struct StateRow {
    State state;
    std::string_view name; ///< "timed-out": in JSON
    std::string_view text; ///< "timed out": for readers
    int status;            ///< the exit status that one of them leads to
};

inline constexpr std::array stateRows{
    StateRow{State::Passed, "passed", "passed", 0},
    StateRow{State::Failed, "failed", "failed", 1},
    StateRow{State::New, "new", "new", 1},
    StateRow{State::MissingScene, "missing-scene", "without scene", 2},
    StateRow{State::Error, "error", "in error", 2},
    StateRow{State::Crashed, "crashed", "crashed", 1},
    StateRow{State::TimedOut, "timed-out", "timed out", 1},
    StateRow{State::Skipped, "skipped", "skipped", 0},
    StateRow{State::Resized, "resized", "resized", 1},
    StateRow{State::Missing, "missing", "missing", 1},
    StateRow{State::Extra, "extra", "extra", 1},
};

[[nodiscard]] const StateRow& rowOf(State state);

struct WorstPixel {
    int x = 0; ///< from the upper left, as `texshot probe --at` counts
    int y = 0;
    std::array<std::uint8_t, 4> expected{};
    std::array<std::uint8_t, 4> actual{};

    bool operator==(const WorstPixel&) const = default;
};

struct CaseRecord {
    std::string name;
    State state = State::Passed;
    std::string sentence{};    ///< what came of it: "3.2 % of the pixels differ by more than 2, …"
    std::string explanation{}; ///< of the worst pixel: lines of plain text; empty: none
    double seconds = 0;
    int attempt = 1; ///< from 1
    int signal = 0;  ///< that ended its process; 0: none
    std::string renderer{};
    std::string driver{};   ///< GL_RENDERER; empty: none was needed
    std::string settings{}; ///< of the environment, that decide how precisely the driver draws it
    int width = 0;
    int height = 0;
    double time = 0;
    std::string metric{};   ///< empty: nothing was compared, and the next are 0. "rule level-blend" where the
                            ///< reference is the golden
    double score = 0;       ///< what the metric says of the pictures
    double tolerance = 0;   ///< of a rule: its bound, in 255ths
    double share = 0;       ///< of the pixels, that may be over the tolerance, 0 to 1; of a rule: unexplained
    double shareOver = 0;   ///< that are over the tolerance, whatever a rule says of them
    std::size_t pixels = 0; ///< that count
    std::size_t over = 0;   ///< of these, over the tolerance
    std::optional<std::size_t> unexplained = {}; ///< of a rule: of those over, what it doesn't explain
    std::optional<WorstPixel> worst{};
    std::string golden{}; ///< which it was held against, relative to its suite; "reference"; empty: none
    std::string expectedPicture{}; ///< files of the report's folder, by their names; empty: none
    std::string actualPicture{};
    std::string differencePicture{};
    std::string fingerprint{}; ///< Fingerprints::of: another one has to be run again

    bool operator==(const CaseRecord&) const = default;

    /// Of its pixels, what `share` is about.
    [[nodiscard]] double shareThatCounts() const {
        return unexplained && pixels > 0 ? static_cast<double>(*unexplained) / static_cast<double>(pixels)
                                         : shareOver;
    }
};

/// Which of how many parts of a run, from 1.
struct Shard {
    int number = 1;
    int count = 1;

    bool operator==(const Shard&) const = default;
};

/// "2/5". OutOfRange, Malformed.
[[nodiscard]] Result<Shard> parseShard(std::string_view text);

struct RunRecord {
    std::string program{}; ///< "texshot 0.1.0"
    std::string command{}; ///< that makes it again
    std::string started{}; ///< "2026-11-22T02:30:00Z"
    std::vector<std::string> suites{};
    std::string driver{};    ///< GL_RENDERER; of shards on several drivers, those with ", " between them
    std::string version{};   ///< GL_VERSION
    std::string plan{};      ///< fingerprintOf the plan
    std::size_t planned = 0; ///< cases of the whole plan
    Shard shard{};
    std::vector<std::string> names{}; ///< of the cases that are this shard's, run or not
    bool endedEarly = false; ///< with its first failure, as --fail-fast has it: what is missing was left out
    double seconds = 0;
    std::vector<CaseRecord> cases{}; ///< in the order of `names`, a case at most once

    bool operator==(const RunRecord&) const = default;

    [[nodiscard]] std::size_t count(State state) const;
    /// Of `names`: those that have no record.
    [[nodiscard]] std::vector<std::string> missing() const;
};

/// 0: all are alike, or a part has none of the cases; 1: some differ, are new, crashed or hung; 2: some could
/// not be tried, or there are none.
[[nodiscard]] int exitStatus(const RunRecord& run);

/// "36 cases: 33 passed, 2 failed, 1 skipped"
[[nodiscard]] std::string summary(const RunRecord& run);

/// The summary after a line or two for every case that neither passed nor was skipped, and for each reason of
/// those that were. Printable, of several lines.
[[nodiscard]] std::string asText(const RunRecord& run);

} // namespace texplorer::suite
