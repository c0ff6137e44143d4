#pragma once

#include <string>
#include <vector>

namespace texplorer {

/// A text within a picture's file.
struct PictureText {
    std::string keyword; ///< PNG: 1 to 79 letters of ASCII, single spaces between them
    std::string text;    ///< UTF-8

    bool operator==(const PictureText&) const = default;
};

/// What a writer may be told; each takes what concerns it.
struct WriteOptions {
    bool small = false;                  ///< PNG: smaller rather than faster
    bool runLengthCoded = false;         ///< TGA
    std::vector<PictureText> texts = {}; ///< PNG, in front of the pixels
};

} // namespace texplorer
