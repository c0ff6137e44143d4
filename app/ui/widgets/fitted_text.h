#pragma once

#include "texplorer/base/sentence.h"

#include <imgui.h>

#include <string>
#include <string_view>

namespace texplorer::ui {

/// The part of a translated text that fits, with "…" instead of the rest.
[[nodiscard]] std::string fitted(const Sentence& words, float room);

/// A line of text in the remaining room of the panel or column; a long text ends after a clause or a word,
/// with "…". Returns true if it was cut: a tooltip should then show all of it.
bool fittedText(const Sentence& words, ImU32 ink);

/// Where to cut a text if `fits` bytes have room: after the last clause, else after the last word, if at
/// least half of the bytes are kept. A short label is cut at `fits`.
[[nodiscard]] std::size_t sensibleEnd(std::string_view text, std::size_t fits);

} // namespace texplorer::ui
