#pragma once

// Where an error is.

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace texplorer {

/// The way to something: steps from the outside, as a file, a file in it, a pointer into that. A text alone
/// is the path of a parameter.
class Location {
public:
    enum class Kind : std::uint8_t { File, Line, Option, Parameter, Pointer, Name };

    struct Step {
        Kind kind;
        std::string text;       ///< as it is printed: "line 2, column 5"
        std::size_t line = 0;   ///< of a Line, counted from 1
        std::size_t column = 0; ///< of a Line, counted from 1, in characters; 0: the whole line

        bool operator==(const Step&) const = default;
    };

    Location() = default;
    Location(std::string path)
        : Location(Step{Kind::Parameter, std::move(path)}) {}
    Location(std::string_view path)
        : Location(std::string(path)) {}
    Location(const char* path)
        : Location(std::string(path)) {}
    explicit Location(Step step) {
        if (!step.text.empty())
            steps_.push_back(std::move(step));
    }

    [[nodiscard]] bool empty() const { return steps_.empty(); }
    [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
    /// Whether it begins so.
    [[nodiscard]] bool isOf(Kind kind) const { return !empty() && steps_.front().kind == kind; }
    /// "a.png: a.json: textures[0].file"
    [[nodiscard]] std::string text() const;

    /// What is left without the first step.
    [[nodiscard]] Location inside() const;

    /// A place inside of another. Pointers into one document become one.
    friend Location operator/(Location outer, const Location& inner);

    bool operator==(const Location&) const = default;
    template<std::convertible_to<std::string_view> Text>
    friend bool operator==(const Location& location, const Text& text) {
        return location.text() == std::string_view(text);
    }
    friend std::ostream& operator<<(std::ostream& out, const Location& location);

private:
    std::vector<Step> steps_;
};

/// A file, by its name or as "standard input".
[[nodiscard]] inline Location inFile(std::string name) {
    return Location({Location::Kind::File, std::move(name)});
}

/// Both counted from 1; column 0: the whole line.
[[nodiscard]] Location atLine(std::size_t line, std::size_t column = 0);

/// "--size", "SUITE"
[[nodiscard]] inline Location atOption(std::string option) {
    return Location({Location::Kind::Option, std::move(option)});
}

/// Into a document of JSON (RFC 6901): "/textures/0".
[[nodiscard]] inline Location atPointer(std::string pointer) {
    return Location({Location::Kind::Pointer, std::move(pointer)});
}

/// Of what has a name and is no file, as a suite.
[[nodiscard]] inline Location atName(std::string name) {
    return Location({Location::Kind::Name, std::move(name)});
}

} // namespace texplorer
