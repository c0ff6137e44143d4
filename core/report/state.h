#pragma once

// The results of cases, as a report shows them.

#include "texplorer/gl/enum_row.h"

#include <array>
#include <cstdint>
#include <span>

namespace texplorer::report {

/// In order of interest: the worst first, the least informative last. The labels are those of a run's
/// summary.
enum class State : std::uint8_t {
    Crashed,
    TimedOut,
    Error,
    Failed,
    Differ,
    Resized,
    Missing,
    Extra,
    New,
    NotRun,
    Passed,
    Agree,
    Skipped,
};

/// The colour of a state on the page. States are never shown by colour alone, but with their label.
enum class Tone : std::uint8_t { Bad, Look, Quiet, Good };

inline constexpr std::array stateRows{
    row(State::Crashed, "crashed", "Crashed", "A signal ended the process that drew it."),
    row(State::TimedOut, "timed-out", "Timed out", "It took longer than allowed."),
    row(State::Error, "error", "In error", "It could not be drawn or compared."),
    row(State::Failed, "failed", "Failed", "The picture differs from the expected one by more than allowed."),
    row(State::Differ, "differ", "Differ", "The two pictures differ by more than allowed."),
    row(State::Resized, "resized", "Resized", "The picture has another size than the expected one."),
    row(State::Missing, "missing", "Missing", "The expected picture has no actual picture."),
    row(State::Extra, "extra", "Extra", "The actual picture has no expected picture."),
    row(State::New, "new", "New", "There is no expected picture yet."),
    row(State::NotRun, "not-run", "Not run", "The run ended before it."),
    row(State::Passed, "passed", "Passed", "The picture is as expected."),
    row(State::Agree, "agree", "Agree", "The two pictures are alike."),
    row(State::Skipped, "skipped", "Skipped", "It was not compared, for the given reason."),
};

/// The names are classes of the page's style sheet.
inline constexpr std::array toneRows{
    row(Tone::Bad, "bad", "Wrong", "There is an error."),
    row(Tone::Look, "look", "To review", "It needs a review."),
    row(Tone::Quiet, "quiet", "Nothing found", "There is no result."),
    row(Tone::Good, "good", "Good", "There is no problem."),
};

[[nodiscard]] constexpr Tone toneOf(State state) {
    if (state <= State::Extra)
        return Tone::Bad;
    if (state == State::New)
        return Tone::Look;
    return state == State::Passed || state == State::Agree ? Tone::Good : Tone::Quiet;
}

} // namespace texplorer::report

namespace texplorer {

template<>
struct EnumTable<report::State> {
    static constexpr std::span<const EnumRow> rows = report::stateRows;
};
static_assert(report::stateRows.size() == 13);

template<>
struct EnumTable<report::Tone> {
    static constexpr std::span<const EnumRow> rows = report::toneRows;
};
static_assert(report::toneRows.size() == 4);

} // namespace texplorer
