#pragma once

// The pieces that messages about parameters are made of. Input from outside is quoted, cut and made
// printable.

#include "core/scene/params/params.h"

#include <glm/vec4.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer {

/// The shortest digits that read back as the same float: "0.1", "1000", "1e-05". Independent of the locale.
[[nodiscard]] std::string formatNumber(float number);

/// Such numbers, one after the other.
[[nodiscard]] std::string formatNumbers(std::span<const float> numbers, std::string_view separator = ",");

/// The text in double quotes, at most about 40 bytes of it, printable
/// (core/base/printable.h).
[[nodiscard]] std::string inQuotes(std::string_view text);

/// The same without the quotes, for a name inside a path.
[[nodiscard]] std::string shortened(std::string_view text);

/// `did you mean "minFilter"?`, or else `expected one of a, b, c`.
[[nodiscard]] std::string suggestName(std::string_view text, const std::vector<std::string_view>& names);

/// The numbers that an element of a list has for each vertex: so many, or the last ones left out where they
/// are those of `rest`.
struct ElementNumbers {
    std::size_t least;
    std::size_t most;
    glm::vec4 rest{0, 0, 0, 1};

    /// How many of this element have to be written.
    [[nodiscard]] std::size_t needed(glm::vec4 element) const;
};

/// Nothing where the kind isn't a list of vectors.
[[nodiscard]] std::optional<ElementNumbers> elementNumbers(Kind kind);

/// The elements of such a list, and back.
[[nodiscard]] std::vector<glm::vec4> elementsOf(const Value& value);
[[nodiscard]] Value listOf(Kind kind, const std::vector<glm::vec4>& elements);

/// How many elements a list of any kind has; 0 for what is no list.
[[nodiscard]] std::size_t listSize(const Value& value);
[[nodiscard]] bool isList(Kind kind);

} // namespace texplorer
