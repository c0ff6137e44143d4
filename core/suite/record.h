#pragma once

// The results of cases, as values.

#include "texplorer/base/result.h"
#include "texplorer/gl/enum_row.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::suite {

enum class State : std::uint32_t {
    Passed,
    Failed,       ///< the picture differs from the golden
    New,          ///< there is no golden yet
    MissingScene, ///< the scene file does not exist
    Error,        ///< an error in the scene, a golden or the drawing; see the sentence
    Crashed,      ///< its process was ended by a signal
    TimedOut,
    Skipped,
    Resized, ///< its size differs from the golden's
    Missing, ///< a golden without a picture, with --pictures
    Extra,   ///< a picture without a golden, with --pictures
};

struct StateRow {
    State state;
    std::string_view name; ///< "timed-out": in JSON
    std::string_view text; ///< "timed out": for users
    int status;            ///< the exit status of a run with such a case
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
    int x = 0; ///< from the upper left, as in `texshot probe --at`
    int y = 0;
    std::array<std::uint8_t, 4> expected{};
    std::array<std::uint8_t, 4> actual{};

    bool operator==(const WorstPixel&) const = default;
};

struct CaseRecord {
    std::string name;
    State state = State::Passed;
    Sentence sentence{};       ///< the result: "3.2 % of the pixels differ by more than 2, …"
    std::optional<int> id{};   ///< of the sentence in messages.ids, which core doesn't know
    std::string code{};        ///< of an error: the name of its ErrorCode; else empty
    std::string explanation{}; ///< of the worst pixel: lines of plain text; empty: none
    double seconds = 0;
    int attempt = 1; ///< from 1
    int signal = 0;  ///< that ended its process; 0: none
    std::string renderer{};
    std::string driver{};   ///< GL_RENDERER; empty: not used
    std::string settings{}; ///< environment variables that change the driver's precision
    int width = 0;
    int height = 0;
    double time = 0;
    /// Empty: nothing was compared, and the next are 0. "rule level-blend" if the golden is the reference.
    std::string metric{};
    double score = 0;     ///< of the metric
    double tolerance = 0; ///< of a rule: its bound, in units of 1/255
    /// The allowed share of pixels over the tolerance, 0 to 1; of a rule: of unexplained ones.
    double share = 0;
    double shareOver = 0;                        ///< the share over the tolerance, explained or not
    std::size_t pixels = 0;                      ///< that are compared
    std::size_t over = 0;                        ///< of these, above the tolerance
    std::optional<std::size_t> unexplained = {}; ///< of a rule: those of `over` that it does not explain
    std::optional<WorstPixel> worst{};
    std::string golden{}; ///< the golden that was used, relative to its suite; "reference"; empty: none
    std::string expectedPicture{}; ///< names of files in the report's folder; empty: none
    std::string actualPicture{};
    std::string differencePicture{};
    std::string fingerprint{}; ///< from Fingerprints::of: if it has changed, the case must be run again

    bool operator==(const CaseRecord&) const = default;

    /// The share of pixels that `share` limits.
    [[nodiscard]] double shareThatCounts() const {
        return unexplained && pixels > 0 ? static_cast<double>(*unexplained) / static_cast<double>(pixels)
                                         : shareOver;
    }
};

/// Of a case that an error ends.
[[nodiscard]] CaseRecord problemOf(CaseRecord record, const Error& error, State state = State::Error);

/// A part of a run: its number, from 1, and how many there are.
struct Shard {
    int number = 1;
    int count = 1;

    bool operator==(const Shard&) const = default;
};

/// "2/5". OutOfRange, Malformed.
[[nodiscard]] Result<Shard> parseShard(std::string_view text);

struct RunRecord {
    std::string program{}; ///< "texshot 0.1.0"
    std::string command{}; ///< the command that reproduces it
    std::string started{}; ///< "2026-11-22T02:30:00Z"
    std::vector<std::string> suites{};
    std::string driver{};    ///< GL_RENDERER; of shards on several drivers, joined by ", "
    std::string version{};   ///< GL_VERSION
    std::string plan{};      ///< fingerprintOf the plan
    std::size_t planned = 0; ///< cases of the whole plan
    Shard shard{};
    std::vector<std::string> names{}; ///< of this shard's cases, run or not
    bool endedEarly = false; ///< stopped at the first failure (--fail-fast): missing cases were left out
    double seconds = 0;
    std::vector<CaseRecord> cases{}; ///< in the order of `names`, each case at most once

    bool operator==(const RunRecord&) const = default;

    [[nodiscard]] std::size_t count(State state) const;
    /// The `names` without a record.
    [[nodiscard]] std::vector<std::string> missing() const;
};

/// 0: all passed or were skipped, or a part without cases; 1: some differ, are new, crashed or timed out; 2:
/// some could not be tested, or there are none.
[[nodiscard]] int exitStatus(const RunRecord& run);

/// "36 cases: 33 passed, 2 failed, 1 skipped"
[[nodiscard]] std::string summary(const RunRecord& run);

/// The summary after a line or two for every case that neither passed nor was skipped, and for each reason
/// for skipping. Printable, of several lines.
[[nodiscard]] std::string asText(const RunRecord& run);

} // namespace texplorer::suite
