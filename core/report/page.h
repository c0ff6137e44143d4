#pragma once

// What a report says: a value, of which report_files.h makes a folder. Texts are as they are, from wherever
// they came: the page shows what is printable of them, and nothing in them is taken for HTML.

#include "core/base/bytes.h"
#include "core/report/state.h"

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
    std::string file; ///< within the folder, as that of a picture
};

/// A line for a shell.
struct Command {
    std::string label; ///< what it does and where: "To draw it again, in the report's folder"
    std::string line;
};

/// A picture of a case, a PNG in the report's folder.
struct Picture {
    std::string label; ///< "Expected", "Fixed function"
    /// Within the folder, with '/' between folders. Empty, where `png` is given: the page finds a name.
    std::string file{};
    /// The file's bytes, if it is to be written with the page; with them come its pixels (pixelsOf).
    Bytes png{};
    /// Without `png`: whether pixelsOf(file, …) lies beside it, or will. Without, the page shows the picture,
    /// but no numbers of its pixels.
    bool pixels = false;
};

/// What a colour of the difference means: "4", or "16 and more".
struct Swatch {
    std::string label;
    std::array<std::uint8_t, 3> color;
};

struct Case {
    std::string name; ///< as `--accept` takes it, if it can be accepted; else any, even twice
    std::string group{};
    State state = State::Passed;
    std::string message{}; ///< one sentence: what is wrong, or nothing

    std::optional<Picture> expected{};
    std::optional<Picture> actual{};
    std::optional<Picture> difference{};
    std::vector<Swatch> legend{};              ///< of the colours of `difference`
    std::array<int, 2> size{};                 ///< in pixels, of the pictures; 0, 0: not known
    std::optional<std::array<int, 2>> worst{}; ///< the worst pixel, x and y from the upper left
    double distance = 0;                       ///< how bad it is, beside others of its state: more is worse
    std::optional<double> seconds{};
    std::vector<Fact> facts{};
    std::string explanation{}; ///< several lines, shown as they are
    std::vector<Link> links{};
    std::vector<Command> commands{};
    bool acceptable = false; ///< whether its name may go to the list for `--accept`
};

struct Cell {
    std::string text;
    std::optional<State> state{};         ///< whose colour it has
    std::optional<std::size_t> leadsTo{}; ///< an index of `Page::cases`
};

struct Column {
    std::string label;
    bool number = false; ///< set to the right
};

/// A summary above the cases.
struct Table {
    std::string title;
    std::vector<Column> columns;
    std::vector<std::vector<Cell>> rows; ///< a cell for each column
    std::vector<std::string> notes{};    ///< sentences below it
};

struct Page {
    std::string title;
    std::string verdict{};                   ///< "3 of 36 cases failed"
    Tone tone = Tone::Good;                  ///< of the verdict
    std::vector<std::string> introduction{}; ///< paragraphs
    std::string madeBy{};                    ///< "texshot 0.1.0 on 2026-11-22 02:30 UTC in 12.3 s"
    std::string command{};                   ///< that makes it again
    std::vector<Fact> environment{};         ///< renderer, version, context …
    std::vector<Table> tables{};
    std::vector<Case> cases{}; ///< in the order in which they ran
    /// What one types once a list has been written, with "accept.txt" for it: "texshot test suite.json
    /// --accept accept.txt". Empty: nothing can be accepted.
    std::string acceptCommand{};
};

} // namespace texplorer::report
