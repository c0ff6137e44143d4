#include "app/render/shader_folder.h"

#include "texplorer/files/file_io.h"

#include <utility>

namespace texplorer::render {

namespace {
constexpr std::size_t maxFileBytes = std::size_t{1} << 20;
}

ShaderFolder::ShaderFolder(std::filesystem::path folder, std::function<void()> wake)
    : folder_(std::move(folder))
    , watch_(std::move(wake)) {
    std::vector<std::filesystem::path> files;
    for (const glsl::ShaderFile& file : glsl::embeddedShaderFiles())
        files.push_back(folder_ / file.name);
    watch_.watch(std::move(files));
}

bool ShaderFolder::refresh() {
    if (watch_.changed().empty() && std::exchange(isRead_, true))
        return false;
    isRead_ = true;
    Result<glsl::ShaderPieces> pieces = readShaderFolder(folder_);
    problem_ = pieces ? Sentence() : describe(pieces.error());
    if (pieces)
        pieces_ = std::move(*pieces);
    return pieces.has_value();
}

Result<glsl::ShaderPieces> readShaderFolder(const std::filesystem::path& folder) {
    std::vector<glsl::ShaderFile> files;
    for (const glsl::ShaderFile& wanted : glsl::embeddedShaderFiles()) {
        Result<std::string> text = readText(folder / wanted.name, maxFileBytes);
        if (!text)
            return fail(text.error());
        files.push_back({wanted.name, std::move(*text)});
    }
    return glsl::ShaderPieces::parse(files);
}

} // namespace texplorer::render
