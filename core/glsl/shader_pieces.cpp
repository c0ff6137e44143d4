#include "texplorer/glsl/shader_pieces.h"

#include <algorithm>
#include <cassert>

namespace texplorer::glsl {

namespace {

constexpr std::string_view marker = "//@ ";
constexpr std::size_t maxFileBytes = std::size_t{1} << 20;

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Calls `each` for what stands between two separators, the rest last.
void split(std::string_view text, char separator, auto each) {
    for (std::size_t at = 0;;) {
        const std::size_t end = text.find(separator, at);
        each(text.substr(at, end - at));
        if (end == std::string_view::npos)
            return;
        at = end + 1;
    }
}

} // namespace

Result<ShaderPieces> ShaderPieces::parse(std::span<const ShaderFile> files) {
    for (const ShaderFile& wanted : embeddedShaderFiles()) {
        const bool isNeeded = wanted.name != "sampling.glsl"; // which only OpenGL ES reads
        if (isNeeded && std::ranges::find(files, wanted.name, &ShaderFile::name) == files.end())
            return fail(ErrorCode::NotFound, "the shaders need this file, which is missing",
                        inFile(wanted.name));
    }
    ShaderPieces pieces;
    for (const ShaderFile& file : files) {
        if (file.text.size() > maxFileBytes)
            return fail(
                ErrorCode::TooLarge,
                Sentence("a shader's file has at most {0} bytes, not {1}", maxFileBytes, file.text.size()),
                inFile(file.name));
        Names& names = pieces.files_[file.name];
        std::vector<std::string> keys; // of the piece that is being read
        ShaderPiece piece;
        std::string twice;
        const auto finish = [&] {
            for (const std::string& key : keys) {
                if (!names.emplace(key, piece).second && twice.empty())
                    twice = key;
            }
        };
        int number = 0;
        split(file.text, '\n', [&](std::string_view line) {
            ++number;
            if (line.ends_with('\r'))
                line.remove_suffix(1);
            if (!line.starts_with(marker)) {
                piece.lines.emplace_back(line);
                return;
            }
            finish();
            keys.clear();
            piece = {{}, number + 1};
            split(line.substr(marker.size()), '|',
                  [&](std::string_view key) { keys.emplace_back(trimmed(key)); });
        });
        if (!piece.lines.empty() && piece.lines.back().empty())
            piece.lines.pop_back(); // after the last line's end
        finish();
        if (!twice.empty())
            return fail(ErrorCode::Malformed, Sentence("the piece \"{0}\" is defined twice", twice),
                        inFile(file.name));
    }
    return pieces;
}

const ShaderPieces& ShaderPieces::embedded() {
    static const ShaderPieces pieces = [] {
        Result<ShaderPieces> parsed = parse(embeddedShaderFiles());
        assert(parsed);
        return parsed ? std::move(*parsed) : ShaderPieces();
    }();
    return pieces;
}

const ShaderPiece* ShaderPieces::find(std::string_view file, std::string_view name) const {
    const auto names = files_.find(file);
    if (names == files_.end())
        return nullptr;
    const auto found = names->second.find(name);
    return found == names->second.end() ? nullptr : &found->second;
}

} // namespace texplorer::glsl
