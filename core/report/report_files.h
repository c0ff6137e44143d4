#pragma once

// A report's page as files of one folder, which a browser opens from a file: URL.

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/report/page.h"

#include <string>
#include <string_view>
#include <vector>

namespace texplorer::report {

struct File {
    std::string name; ///< within the folder; a picture's has slashes if Picture::file has
    Bytes bytes;
};

/// index.html with its style sheet and scripts, the page's texts as report-data.js, and of each picture with
/// bytes its PNG and its pixels. Error: OutOfRange for a file's name that leads out of the folder, is no
/// UTF-8, or is that of another file.
[[nodiscard]] Result<std::vector<File>> filesOf(const Page& page);

/// Whether a file's name stays in the folder that it is in, and shows as it is written: no control
/// characters.
[[nodiscard]] bool staysInside(std::string_view file);

/// The names of those of them that every page has.
[[nodiscard]] std::vector<std::string> pageFileNames();

/// What lets the page read a picture's pixels: a browser shows a page the images beside it and doesn't let it
/// read them. It is loaded when the case is looked at. For who writes pictures one by one, as they come: with
/// Picture::pixels the page asks for it. `file` is as Picture::file, the new one's name is `file` with ".js".
[[nodiscard]] File pixelsOf(std::string_view file, ByteView png);

} // namespace texplorer::report
