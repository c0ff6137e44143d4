#pragma once

#include <string>
#include <vector>

namespace texplorer::emit {

/// A file of pieces/: a function that programs have where they call it, the same for all scenes.
struct PieceFile {
    std::string name; ///< "halve.c"
    std::string text;
};

/// The files as they were when Texplorer was built.
[[nodiscard]] const std::vector<PieceFile>& pieceFiles();

} // namespace texplorer::emit
