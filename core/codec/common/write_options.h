#pragma once

#include <string>
#include <vector>

namespace texplorer {

/// A text in a picture's file.
struct PictureText {
    std::string keyword; ///< PNG: 1 to 79 ASCII letters with single spaces
    std::string text;    ///< UTF-8

    bool operator==(const PictureText&) const = default;
};

/// The options of the encoders; each uses those of its format.
struct WriteOptions {
    bool small = false;                  ///< PNG: smaller rather than faster
    bool runLengthCoded = false;         ///< TGA
    std::vector<PictureText> texts = {}; ///< PNG: written before the pixels
};

} // namespace texplorer
