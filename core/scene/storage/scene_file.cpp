#include "texplorer/scene/storage/scene_file.h"

#include "texplorer/codec/png/png_chunks.h"
#include "texplorer/codec/png/png_text.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/storage/obj_scene.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <string_view>
#include <utility>

namespace texplorer {
namespace {

/// Fills the buffer; false: the file ends before.
bool readAll(std::istream& file, std::span<std::byte> to) {
    file.read(reinterpret_cast<char*>(to.data()), static_cast<std::streamsize>(to.size()));
    return file.gcount() == static_cast<std::streamsize>(to.size());
}

} // namespace

std::size_t maxSceneFileBytes(ByteView start) {
    return hasPngSignature(start) ? defaultMaxFileBytes : maxSceneBytes;
}

Result<std::string> sceneTextIn(ByteView file) {
    if (!hasPngSignature(file))
        return std::string(reinterpret_cast<const char*>(file.data()), file.size());
    Result<std::optional<std::string>> text = findPngText(file, sceneKeyword, maxSceneBytes);
    if (!text)
        return fail(text.error());
    if (*text)
        return **std::move(text);
    return fail(
        ErrorCode::NotFound,
        Sentence("expected a scene, found a PNG without a scene: it has no text \"{0}\"", sceneKeyword));
}

Result<SceneContent> sceneOfObj(MeshFile file, const std::string& name) {
    if (name.empty() && !isSmall(file.obj))
        return fail(
            ErrorCode::TooLarge,
            Sentence("a scene has at most {0} vertices and {1} indices of its own: expected a file that "
                     "it can name",
                     maxMeshVertices, maxMeshIndices));
    std::string text = writeScene(sceneOf(file.obj, name));
    if (text.size() > maxSceneBytes)
        return fail(ErrorCode::TooLarge, Sentence("as a scene it takes {0} bytes; at most {1} are read",
                                                  text.size(), maxSceneBytes));
    std::vector<Sentence> notes = std::exchange(file.obj.notes, {});
    return SceneContent{std::move(text), std::move(notes), std::make_shared<const MeshFile>(std::move(file))};
}

Result<SceneContent> readSceneFile(const std::filesystem::path& file) {
    const bool isObj = isObjName(file);
    const Result<Bytes> start = readFileStart(file, pngSignature.size());
    if (!start)
        return fail(start.error());
    const Result<Bytes> bytes = readFile(file, isObj ? maxObjBytes : maxSceneFileBytes(*start));
    if (!bytes)
        return fail(bytes.error());
    Result<SceneContent> read =
        isObj ? meshFileIn(*bytes, file).and_then([&](MeshFile&& meshes) {
            return sceneOfObj(std::move(meshes), file.filename().string());
        })
              : sceneTextIn(*bytes).map([](std::string&& text) { return SceneContent{std::move(text)}; });
    return read ? std::move(read) : fail(within(inFile(file.string()), read.error()));
}

bool isPictureWithScene(const std::filesystem::path& path, std::size_t maxChunks) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) // a pipe would be waited for
        return false;
    std::ifstream file(path, std::ios::binary);
    std::array<std::byte, pngSignature.size()> signature{};
    if (!readAll(file, signature) || !hasPngSignature(signature))
        return false;
    const std::string_view keyword(sceneKeyword);
    std::array<std::byte, 8> head{}; // length and type
    for (std::size_t looked = 0; looked < maxChunks && readAll(file, head); ++looked) {
        PngChunk chunk;
        chunk.length = bigEndian32(head, 0);
        chunk.type.assign(reinterpret_cast<const char*>(head.data()) + 4, 4);
        std::streamoff left = std::streamoff{chunk.length} + 4; // and its checksum
        if (isTextChunk(chunk) && chunk.length > keyword.size()) {
            std::string start(keyword.size() + 1, '\xFF'); // a keyword ends with 0
            file.read(start.data(), static_cast<std::streamsize>(start.size()));
            if (start.starts_with(keyword) && start.back() == '\0')
                return true;
            left -= static_cast<std::streamoff>(start.size());
        }
        file.seekg(left, std::ios::cur);
    }
    return false;
}

} // namespace texplorer
