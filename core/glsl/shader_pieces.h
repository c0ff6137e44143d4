#pragma once

#include "texplorer/base/result.h"

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::glsl {

/// A file of shaders/.
struct ShaderFile {
    std::string name; ///< "lighting.glsl"
    std::string text;
};

/// The files as embedded in the program.
[[nodiscard]] const std::vector<ShaderFile>& embeddedShaderFiles();

/// A part of a file; sources are assembled from pieces.
struct ShaderPiece {
    std::vector<std::string> lines;
    int firstLine = 1; ///< in its file, counted from 1
};

/// The pieces of all files. A line "//@ name | another name" begins a piece; text before the first is a
/// comment.
class ShaderPieces {
public:
    /// Errors: a missing file, a file of more than a megabyte, a name that occurs twice in a file.
    [[nodiscard]] static Result<ShaderPieces> parse(std::span<const ShaderFile> files);

    /// The pieces of the embedded files.
    [[nodiscard]] static const ShaderPieces& embedded();

    /// Returns nullptr if there is none.
    [[nodiscard]] const ShaderPiece* find(std::string_view file, std::string_view name) const;

private:
    using Names = std::map<std::string, ShaderPiece, std::less<>>;
    std::map<std::string, Names, std::less<>> files_;
};

} // namespace texplorer::glsl
