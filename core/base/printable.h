#pragma once

#include <string>
#include <string_view>

namespace texplorer {

enum class LineBreaks : bool { Escape, Keep };

/// Text for a terminal, a window or a page: what came from outside (a file's name, a comment within it, a
/// string of a scene, a driver's name) can't steer what shows it. Control characters (C0, DEL, C1), the
/// separators of lines and paragraphs, and Unicode's marks, embeddings, overrides and isolates of direction
/// become \u001b, as JSON spells them; bytes that are no UTF-8 become U+FFFD. Keep leaves \n and \t as they
/// are: for a text of several lines, whose parts from outside are made printable one by one. JSON stays the
/// same JSON.
[[nodiscard]] std::string printable(std::string_view text, LineBreaks lines = LineBreaks::Escape);

} // namespace texplorer
