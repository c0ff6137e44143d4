#pragma once

#include "texplorer/base/sentence.h"
#include "texplorer/files/file_watch.h"
#include "texplorer/glsl/shader_pieces.h"

#include <filesystem>
#include <functional>
#include <optional>

namespace texplorer::render {

/// Reads the shader files of a folder. The error is about the first file that cannot be read or is not valid.
[[nodiscard]] Result<glsl::ShaderPieces> readShaderFolder(const std::filesystem::path& folder);

/// The shader files of a folder, read again when one of them changes.
class ShaderFolder {
public:
    /// `wake` is called on another thread when files have changed and `refresh` should be called.
    explicit ShaderFolder(std::filesystem::path folder, std::function<void()> wake = {});

    /// Reads changed files. Returns true if `pieces` has changed.
    bool refresh();

    /// The current files; or the last ones that could be read, or none, with the reason in `problem`.
    [[nodiscard]] const std::optional<glsl::ShaderPieces>& pieces() const { return pieces_; }
    [[nodiscard]] const Sentence& problem() const { return problem_; }

private:
    std::filesystem::path folder_;
    FileWatch watch_;
    bool isRead_ = false;
    std::optional<glsl::ShaderPieces> pieces_;
    Sentence problem_;
};

} // namespace texplorer::render
