#pragma once

// Words that have to fit into a room.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::sheet {

/// How wide a line is, in whatever `room` is in.
using MeasureText = std::function<int(std::string_view)>;

/// The text, or as much of its beginning and of its end as fits, with "…" between them. Never empty unless
/// the text is: where nothing fits, "…" alone. No character of UTF-8 is cut.
[[nodiscard]] std::string shortenedMiddle(std::string_view text, int room, const MeasureText& measure);

/// At most `most` lines, broken behind a space and behind one of "_,;-/"; what doesn't fit into its line, as
/// the rest of the text in the last one, is shortened in the middle.
[[nodiscard]] std::vector<std::string> labelLines(std::string_view text, int room, std::size_t most,
                                                  const MeasureText& measure);

} // namespace texplorer::sheet
