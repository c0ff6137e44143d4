#pragma once

// Patterns for the names of several files: "{scene}-{minFilter}.png".

#include "texplorer/base/result.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer {

/// Converts a text to a part of a file name, without separators: everything except letters, digits,
/// "+-.,=@[]_" and printable characters beyond ASCII becomes "_", as does a leading dot. Never empty; at most
/// 100 bytes.
[[nodiscard]] std::string fileNamePart(std::string_view value);

/// A name with places in braces, which are filled in for each file; "{{" and "}}" stand for single braces.
class NamePattern {
public:
    /// Errors: a place without closing brace or name.
    [[nodiscard]] static Result<NamePattern> parse(std::string_view text);

    /// Returns the names of the places, each once, in the order of the pattern.
    [[nodiscard]] std::vector<std::string> places() const;

    /// Fills each place with `valueOf(place)`, converted by fileNamePart.
    [[nodiscard]] std::string fill(const std::function<std::string(const std::string& place)>& valueOf) const;

private:
    struct Piece {
        std::string text;
        bool isPlace = false;
    };
    std::vector<Piece> pieces_;
};

} // namespace texplorer
