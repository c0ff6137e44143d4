#include "texplorer/scene/storage/unsaved_scene.h"

#include <algorithm>
#include <charconv>
#include <optional>

namespace texplorer {
namespace {

constexpr std::string_view firstLine = N_("Texplorer, unsaved scene, version 2");
constexpr std::string_view firstLineWithoutHash = N_("Texplorer, unsaved scene, version 1");

std::string escaped(std::string_view path) {
    constexpr char digits[] = "0123456789ABCDEF";
    std::string text;
    for (const char letter : path) {
        const auto code = static_cast<unsigned char>(letter);
        if (code >= 0x20 && code != 0x7F && code != '%') {
            text += letter;
            continue;
        }
        text += '%';
        text += digits[code >> 4];
        text += digits[code & 15];
    }
    return text;
}

std::optional<std::string> unescaped(std::string_view text) {
    std::string path;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            path += text[i];
            continue;
        }
        unsigned char code = 0;
        const char* begin = text.data() + i + 1;
        const char* end = text.data() + std::min(text.size(), i + 3);
        const auto [stopped, error] = std::from_chars(begin, end, code, 16);
        if (error != std::errc() || stopped != begin + 2 || code == 0)
            return std::nullopt;
        path += static_cast<char>(code);
        i += 2;
    }
    return path;
}

/// Takes a line off the front; nothing where there is no end of a line.
std::optional<std::string_view> takeLine(std::string_view& text) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos)
        return std::nullopt;
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end + 1);
    return line;
}

Result<std::filesystem::path> takePath(std::string_view& text, const char* what) {
    const std::optional<std::string_view> line = takeLine(text);
    const std::optional<std::string> path = line ? unescaped(*line) : std::nullopt;
    if (!path || (!path->empty() && !std::filesystem::path(*path).is_absolute()))
        return fail(ErrorCode::Malformed, Sentence("expected the absolute path of {0}", what));
    return std::filesystem::path(*path);
}

} // namespace

std::string writeUnsaved(const UnsavedScene& draft) {
    std::string text(firstLine);
    for (const std::string& line :
         {escaped(draft.file.native()), escaped(draft.folder.native()), draft.fileHash})
        text.append("\n").append(line);
    return text.append("\n").append(writeScene(draft.scene));
}

Result<UnsavedScene> parseUnsaved(std::string_view text) {
    const std::optional<std::string_view> first = takeLine(text);
    if (first != firstLine && first != firstLineWithoutHash)
        return fail(ErrorCode::Malformed,
                    Sentence("expected an unsaved scene, which begins with \"{0}\"", firstLine));
    const Result<std::filesystem::path> file = takePath(text, N_("the scene file"));
    if (!file)
        return fail(file.error());
    const Result<std::filesystem::path> folder = takePath(text, N_("the folder of its images"));
    if (!folder)
        return fail(folder.error());
    std::string hash;
    if (first == firstLine) {
        const std::optional<std::string_view> line = takeLine(text);
        if (!line)
            return fail(ErrorCode::Malformed, "expected the hash of the scene file");
        hash = *line;
    }
    Result<Scene> scene = parseScene(text);
    if (!scene)
        return fail(scene.error());
    return UnsavedScene{*file, *folder, std::move(*scene), std::move(hash)};
}

} // namespace texplorer
