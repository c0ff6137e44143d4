#pragma once

#include "core/base/result.h"

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::glsl {

/// One of the files of shaders/.
struct ShaderFile {
    std::string name; ///< "lighting.glsl"
    std::string text;
};

/// The files as they were when the program was built.
[[nodiscard]] const std::vector<ShaderFile>& embeddedShaderFiles();

/// A part of a file, of which sources are put together.
struct ShaderPiece {
    std::vector<std::string> lines;
    int firstLine = 1; ///< in its file, counted from 1
};

/// The pieces of all files. A line "//@ name | another name" begins one; what stands before the first is for
/// the reader of the file.
class ShaderPieces {
public:
    /// Refused: a file that is missing, one of more than a megabyte, a name that is given twice in a file.
    [[nodiscard]] static Result<ShaderPieces> parse(std::span<const ShaderFile> files);

    /// Those of the embedded files.
    [[nodiscard]] static const ShaderPieces& embedded();

    /// nullptr where there is none.
    [[nodiscard]] const ShaderPiece* find(std::string_view file, std::string_view name) const;

private:
    using Names = std::map<std::string, ShaderPiece, std::less<>>;
    std::map<std::string, Names, std::less<>> files_;
};

} // namespace texplorer::glsl
