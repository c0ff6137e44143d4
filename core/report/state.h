#pragma once

// What came of a case, as a report shows it.

#include "core/gl/enum_row.h"

#include <cstdint>
#include <span>

namespace texplorer::report {

/// In the order in which one wants to see them: what is worst comes first.
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
    Skipped,
    Passed,
    Agree,
};

/// Which of the page's colours a state has. It is never told by colour alone: its label stands beside it.
enum class Tone : std::uint8_t {
    Bad,   ///< something is wrong
    Look,  ///< somebody has to look at it
    Quiet, ///< nothing was found out
    Good,
};

[[nodiscard]] Tone toneOf(State state);

} // namespace texplorer::report

namespace texplorer {

template<>
struct EnumTable<report::State> {
    static const std::span<const EnumRow> rows;
};

/// Their names are the classes of the page's style sheet.
template<>
struct EnumTable<report::Tone> {
    static const std::span<const EnumRow> rows;
};

} // namespace texplorer
