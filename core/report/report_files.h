#pragma once

// Writes a report's page as files of one folder, which works in a browser with file: URLs.

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"
#include "texplorer/report/page.h"

#include <string>
#include <string_view>
#include <vector>

namespace texplorer::report {

struct File {
    std::string name; ///< relative to the folder; with slashes if Picture::file has them
    Bytes bytes;
};

/// Makes index.html with its style sheet and scripts, the page's texts as report-data.js, and for each
/// picture with bytes its PNG and its pixels. Error: OutOfRange for a file name that leads out of the folder,
/// is not UTF-8, or is used twice.
[[nodiscard]] Result<std::vector<File>> filesOf(const Page& page);

/// Whether a file name stays in its folder and contains no control characters.
[[nodiscard]] bool staysInside(std::string_view file);

/// The names of the files that every page has.
[[nodiscard]] std::vector<std::string> pageFileNames();

/// Makes the file that lets the page read a picture's pixels: browsers do not let pages read the pixels of
/// local images. It is loaded when the case is shown. For programs that write pictures one by one: with
/// Picture::pixels, the page loads it. `file` is as in Picture::file, the new file's name is `file` with
/// ".js".
[[nodiscard]] File pixelsOf(std::string_view file, ByteView png);

} // namespace texplorer::report
