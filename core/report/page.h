#pragma once

// The content of a report, from which report_files.h makes a folder. Texts may contain anything: the page
// makes them printable, and never takes them for HTML.

#include "texplorer/base/bytes.h"
#include "texplorer/report/state.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::report {

struct Fact {
    std::string name; ///< "Worst pixel"
    std::string value;
};

struct Link {
    std::string label;
    std::string file; ///< relative to the folder, as for pictures
};

/// A command line.
struct Command {
    std::string label; ///< what it does and where: "To draw it again, in the report's folder"
    std::string line;
};

/// A picture of a case: a PNG in the report's folder.
struct Picture {
    std::string label; ///< "Expected", "Fixed function"
    /// Relative to the folder, with '/' as separator. With `png`, it may be empty: the page chooses a name.
    std::string file{};
    /// The bytes of the file, if it is written with the page; its pixels (pixelsOf) are written, too.
    Bytes png{};
    /// Without `png`: whether pixelsOf(file, …) is or will be next to it. If false, the page shows the
    /// picture without the numbers of its pixels.
    bool pixels = false;
};

/// The meaning of a colour in the difference: "4", or "16 and more".
struct Swatch {
    std::string label;
    std::array<std::uint8_t, 3> color;
};

struct Case {
    std::string
        name; ///< the name for `--accept` if it can be accepted; else any name, not necessarily unique
    std::string group{};
    State state = State::Passed;
    std::string message{}; ///< one sentence about the error; empty: none

    std::optional<Picture> expected{};
    std::optional<Picture> actual{};
    std::optional<Picture> difference{};
    std::vector<Swatch> legend{};              ///< for the colours of `difference`
    std::array<int, 2> size{};                 ///< of the pictures, in pixels; 0, 0: unknown
    std::optional<std::array<int, 2>> worst{}; ///< the worst pixel, x and y from the upper left
    double distance = 0;                       ///< the rank among cases of the same state: larger is worse
    std::optional<double> seconds{};
    std::vector<Fact> facts{};
    std::string explanation{}; ///< several lines, shown unchanged
    std::vector<Link> links{};
    std::vector<Command> commands{};
    bool acceptable = false; ///< its name can be added to the list for `--accept`
};

struct Cell {
    std::string text;
    std::optional<State> state{};         ///< the state whose colour it has
    std::optional<std::size_t> leadsTo{}; ///< an index of `Page::cases`
};

struct Column {
    std::string label;
    bool number = false; ///< aligned right
};

/// A summary before the cases.
struct Table {
    std::string title;
    std::vector<Column> columns;
    std::vector<std::vector<Cell>> rows; ///< one cell per column
    std::vector<std::string> notes{};    ///< sentences below it
};

struct Page {
    std::string title;
    std::string verdict{};                   ///< "3 of 36 cases failed"
    Tone tone = Tone::Good;                  ///< of the verdict
    std::vector<std::string> introduction{}; ///< paragraphs
    std::string madeBy{};                    ///< "texshot 0.1.0 on 2026-11-22 02:30 UTC in 12.3 s"
    std::string command{};                   ///< the command that reproduces it
    std::vector<Fact> environment{};         ///< renderer, version, context …
    std::vector<Table> tables{};
    std::vector<Case> cases{}; ///< in the order of the run
    /// The command to type after a list was saved as "accept.txt": "texshot test suite.json --accept
    /// accept.txt". Empty: nothing can be accepted.
    std::string acceptCommand{};
};

} // namespace texplorer::report
