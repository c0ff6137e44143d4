#pragma once

#include "core/base/file_watch.h"
#include "core/glsl/shader_pieces.h"

#include <filesystem>
#include <functional>
#include <optional>

namespace texplorer::render {

/// The shaders' files of a folder. Errors: the first that can't be read or is no such file.
[[nodiscard]] Result<glsl::ShaderPieces> readShaderFolder(const std::filesystem::path& folder);

/// The shaders' files in a folder, read again when one of them has changed.
class ShaderFolder {
public:
    /// `wake` is called on another thread when `refresh` has something to do.
    explicit ShaderFolder(std::filesystem::path folder, std::function<void()> wake = {});

    /// Reads what has changed. True where `pieces` are other ones than before.
    bool refresh();

    /// Of the files as they are; else the last ones that could be read, or none, and `problem` says why.
    [[nodiscard]] const std::optional<glsl::ShaderPieces>& pieces() const { return pieces_; }
    [[nodiscard]] const std::string& problem() const { return problem_; }

private:
    std::filesystem::path folder_;
    FileWatch watch_;
    bool isRead_ = false;
    std::optional<glsl::ShaderPieces> pieces_;
    std::string problem_;
};

} // namespace texplorer::render
