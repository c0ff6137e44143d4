#pragma once

#include <string>
#include <string_view>

namespace texplorer {

enum class LineBreaks : bool { Escape, Keep };

/// Makes untrusted text (file names, their comments, strings of a scene, names of drivers) safe for a
/// terminal, a window or a page. Control characters (C0, DEL, C1), line and paragraph separators, and
/// Unicode's directional marks, embeddings, overrides and isolates become \u001b, as in JSON; invalid UTF-8
/// becomes U+FFFD. Keep leaves \n and \t: for a text of several lines whose untrusted parts were made
/// printable before. JSON stays equivalent JSON.
[[nodiscard]] std::string printable(std::string_view text, LineBreaks lines = LineBreaks::Escape);

} // namespace texplorer
