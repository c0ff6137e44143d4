#pragma once

namespace texplorer {

/// Marks a single word that users read. Texts for translation are collected from the sources and are
/// recognised by a space or a capital letter; a single lower-case word is not, so it is marked.
[[nodiscard]] constexpr const char* word(const char* english) {
    return english;
}

} // namespace texplorer
