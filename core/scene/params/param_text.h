#pragma once

// Parts of messages about parameters. Untrusted text is quoted, shortened and made printable.

#include "texplorer/scene/params/params.h"

#include <glm/vec4.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer {

/// The fewest digits that read back as the same float: "0.1", "1000", "1e-05". Independent of the locale.
[[nodiscard]] std::string formatNumber(float number);

/// Formats several numbers, with a separator.
[[nodiscard]] std::string formatNumbers(std::span<const float> numbers, std::string_view separator = ",");

/// The text in double quotes, shortened to about 40 bytes, printable (texplorer/text/printable.h).
[[nodiscard]] std::string inQuotes(std::string_view text);

/// The same without quotes, for a name in a path.
[[nodiscard]] std::string shortened(std::string_view text);

/// `did you mean "minFilter"?`, or else `expected one of a, b, c`.
[[nodiscard]] Sentence suggestName(std::string_view text, const std::vector<std::string_view>& names);

/// How many numbers per vertex an element of a list has: up to `max`; the last ones beyond `min` can be left
/// out if they equal those of `rest`.
struct ElementNumbers {
    std::size_t min;
    std::size_t max;
    glm::vec4 rest{0, 0, 0, 1};

    /// How many components of this element must be written.
    [[nodiscard]] std::size_t needed(glm::vec4 element) const;
};

/// Empty if the kind is not a list of vectors.
[[nodiscard]] std::optional<ElementNumbers> elementNumbers(Kind kind);

/// Converts such a list to its elements, and back.
[[nodiscard]] std::vector<glm::vec4> elementsOf(const Value& value);
[[nodiscard]] Value listOf(Kind kind, const std::vector<glm::vec4>& elements);

/// The number of elements of a list of any kind; 0 for other values.
[[nodiscard]] std::size_t listSize(const Value& value);
[[nodiscard]] bool isList(Kind kind);

} // namespace texplorer
