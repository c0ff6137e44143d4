#pragma once

// What came of a case, as a report shows it.

#include "core/gl/enum_row.h"

#include <array>
#include <cstdint>
#include <span>

namespace texplorer::report {

/// In the order in which one wants to see them: what is worst comes first, what says nothing last. Their
/// labels are the words of a run's summary.
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

/// Which of the page's colours a state has. It is never told by colour alone: its label stands beside it.
enum class Tone : std::uint8_t { Bad, Look, Quiet, Good };

inline constexpr std::array stateRows{
    row(State::Crashed, "crashed", "Crashed", "The process that drew it ended by a signal."),
    row(State::TimedOut, "timed-out", "Timed out", "It took longer than it may."),
    row(State::Error, "error", "In error", "It could not be drawn or compared."),
    row(State::Failed, "failed", "Failed", "The picture differs from the expected one by more than it may."),
    row(State::Differ, "differ", "Differ", "The two pictures differ by more than they may."),
    row(State::Resized, "resized", "Resized", "The picture has another size than the expected one."),
    row(State::Missing, "missing", "Missing", "There is no picture for what is expected."),
    row(State::Extra, "extra", "Extra", "There is a picture that nobody expects."),
    row(State::New, "new", "New", "There is nothing yet to compare the picture with."),
    row(State::NotRun, "not-run", "Not run", "The run ended before it."),
    row(State::Passed, "passed", "Passed", "The picture is as expected."),
    row(State::Agree, "agree", "Agree", "The two pictures are alike."),
    row(State::Skipped, "skipped", "Skipped", "It was not compared, for a reason that is given."),
};

/// Their names are classes of the page's style sheet.
inline constexpr std::array toneRows{
    row(Tone::Bad, "bad", "Wrong", "Something is wrong."),
    row(Tone::Look, "look", "To be looked at", "Somebody has to look at it."),
    row(Tone::Quiet, "quiet", "Nothing found", "Nothing was found out."),
    row(Tone::Good, "good", "Good", "All is as it should be."),
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
