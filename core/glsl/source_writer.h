#pragma once

#include "texplorer/base/result.h"
#include "texplorer/glsl/shader_pieces.h"
#include "texplorer/glsl/stage_source.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::glsl {

/// A word of a piece, and what takes its place.
struct Substitution {
    std::string_view word;
    std::string text;
};

/// Puts one stage together. A piece that is missing makes all further ones void.
class SourceWriter {
public:
    explicit SourceWriter(const ShaderPieces& pieces)
        : pieces_(pieces) {}

    /// `file` without its suffix: "lighting".
    void add(std::string_view file, const std::string& name,
             const std::vector<Substitution>& substitutions = {});

    /// Puts what another writer has written behind this.
    void append(SourceWriter&& other);

    [[nodiscard]] bool mentions(std::string_view word) const {
        return source_.text.find(word) != std::string::npos;
    }

    [[nodiscard]] Result<StageSource> finish() &&;

private:
    const ShaderPieces& pieces_;
    StageSource source_;
    std::optional<Error> error_;
};

} // namespace texplorer::glsl
