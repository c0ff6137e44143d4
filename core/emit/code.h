#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::emit {

/// A piece of a line of C. What stands for a parameter's value names it, so that a panel can make a control
/// of it.
struct Part {
    enum class Kind {
        Plain,   ///< brackets, commas, names that stay
        Call,    ///< the name of a function
        Number,  ///< of an Int, a Float or one component of what has several
        Choice,  ///< an enumerant
        Switch,  ///< glEnable or glDisable, GL_TRUE or GL_FALSE
        Comment, ///< with what makes it one
    };

    Kind kind = Kind::Plain;
    std::string text;
    std::string path{};   ///< the parameter that it is about, "textures[0].wrapS"; empty: none
    int component = -1;   ///< which of a vector's, a matrix's or a vertex's numbers; -1: it has one
    bool negated = false; ///< the number stands there with the other sign
    int occurrence = 0;   ///< how many before it stand for the same value

    bool operator==(const Part&) const = default;
};

/// Many numbers: to write them takes longer than all the rest of a program, and not everybody reads them.
struct Numbers {
    std::function<std::string()> text;
    /// Numbers of the same source are the same, which is known without writing them; nullptr: of none.
    std::shared_ptr<const void> source{};

    bool operator==(const Numbers& other) const {
        return source && other.source ? source == other.source : text() == other.text();
    }
};

struct Line {
    std::vector<Part> parts;
    /// Whether OpenGL's state would be another without it. Else it sets what is set already.
    bool needed = true;
    bool heading = false; ///< a comment over what follows in its braces, up to the next one
    int depth = 0;        ///< how many braces it stands in
    /// Of an array of many numbers: what stands between its braces, of which the parts show nothing.
    std::shared_ptr<const Numbers> data{};

    bool operator==(const Line&) const = default;
};

[[nodiscard]] std::string textOf(const Line& line);

/// Whether both are the same to who reads them, and where they stand.
[[nodiscard]] bool readsAs(const Line& line, const Line& other);

/// Whether a line has to do with a parameter.
[[nodiscard]] bool mentions(const Line& line, std::string_view path);

/// The lines that are needed, or all, with an empty one before headings that begin no brace.
[[nodiscard]] std::vector<Line> shownLines(const std::vector<Line>& lines, bool all);

/// The same as a text, each ended by a newline. Of an array of many numbers there are all.
[[nodiscard]] std::string textOf(const std::vector<Line>& lines, bool all);

/// Breaks a line into rows of at most `columns` characters where that can be done: after a comma or a
/// bracket, numbers in braces only where nothing else helps. Rows after the first begin with four spaces
/// more.
[[nodiscard]] std::vector<std::vector<Part>> wrapped(const Line& line, std::size_t columns);

} // namespace texplorer::emit
