#pragma once

// Names of many files, written as one: "{scene}-{minFilter}.png".

#include "core/base/result.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer {

/// The same as a part of a file's name that leads nowhere else: what is neither a letter, a digit, one of
/// "+-.,=@[]_" nor printable beyond ASCII becomes "_", and so does a dot at the beginning. Never empty, and
/// at most 100 bytes.
[[nodiscard]] std::string fileNamePart(std::string_view value);

/// A name with places in braces that are filled in for each file; "{{" and "}}" are braces themselves.
class NamePattern {
public:
    /// Refused: a place that isn't closed, or has no name.
    [[nodiscard]] static Result<NamePattern> parse(std::string_view text);

    /// The names of the places, each once, in the order of the pattern.
    [[nodiscard]] std::vector<std::string> places() const;

    /// With `valueOf(place)` in each place, as fileNamePart has it.
    [[nodiscard]] std::string fill(const std::function<std::string(const std::string& place)>& valueOf) const;

private:
    struct Piece {
        std::string text;
        bool isPlace = false;
    };
    std::vector<Piece> pieces_;
};

} // namespace texplorer
