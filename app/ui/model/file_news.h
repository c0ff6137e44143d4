#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace texplorer::ui {

// What those say of themselves who draw many pictures for a file beside the window.

/// How far a file is.
struct FileProgress {
    std::filesystem::path file;
    std::size_t done = 0; ///< pictures
    std::size_t all = 0;
};

/// A sentence for the user.
struct FileNews {
    std::string text;
    bool isGood = false; ///< it is written, with all its pictures
};

} // namespace texplorer::ui
