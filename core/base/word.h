#pragma once

namespace texplorer {

/// A single word that readers see, where it stands in the sources as a name or a key could. The window's
/// translations are collected from the sources, which tell a text by its spaces or its capital letter.
[[nodiscard]] constexpr const char* word(const char* english) {
    return english;
}

} // namespace texplorer
