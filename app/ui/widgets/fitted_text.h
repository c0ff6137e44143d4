#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

namespace texplorer::ui {

/// What of a text, translated, has this room, with "…" in the place of what has not.
[[nodiscard]] std::string fitted(std::string_view words, float room);

/// A line of text in the room that the panel or column has left; what is too long ends after a clause or a
/// word, with "…". True where it had to be cut: then a tooltip should have it all.
bool fittedText(std::string_view words, ImU32 ink);

/// Where to cut a text of which `fits` bytes have room: after the last clause, else after the last word,
/// where that keeps at least half of them. A label, which is short, is cut where its room ends.
[[nodiscard]] std::size_t sensibleEnd(std::string_view text, std::size_t fits);

} // namespace texplorer::ui
