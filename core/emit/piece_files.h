#pragma once

#include <string>
#include <vector>

namespace texplorer::emit {

/// A file of assets/programs: what programs have where they ask for it, the same for all scenes.
struct PieceFile {
    std::string name; ///< "halve.c"
    std::string text;
};

// The files as they were when Texplorer was built.

/// Functions in C; each begins with #include of those that it calls.
[[nodiscard]] const std::vector<PieceFile>& cFunctionFiles();
/// What finds out what key frames say.
[[nodiscard]] const std::vector<PieceFile>& keyFrameFiles();

} // namespace texplorer::emit
