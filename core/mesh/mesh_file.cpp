#include "texplorer/mesh/mesh_file.h"

#include "texplorer/files/file_io.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cctype>
#include <limits>
#include <system_error>
#include <utility>

namespace texplorer {

namespace {

constexpr std::size_t maxMaterialBytes = std::size_t{4} << 20;

void moveToMiddle(ObjFile& file) {
    constexpr double radius = 2;
    glm::vec3 low(std::numeric_limits<float>::max());
    glm::vec3 high(std::numeric_limits<float>::lowest());
    for (const ObjPart& part : file.parts) {
        for (const glm::vec3& position : part.mesh.positions) {
            low = glm::min(low, position);
            high = glm::max(high, position);
        }
    }
    const glm::dvec3 middle = (glm::dvec3(low) + glm::dvec3(high)) / 2.0;
    const double half = glm::length(glm::dvec3(high) - middle);
    const double scale = half > 0 ? radius / half : 1;
    for (ObjPart& part : file.parts)
        for (glm::vec3& position : part.mesh.positions.edit())
            position = glm::vec3((glm::dvec3(position) - middle) * scale);
}

} // namespace

bool isObjName(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char each) { return static_cast<char>(std::tolower(each)); });
    return extension == ".obj";
}

Result<MeshFile> meshFileIn(ByteView file, const std::filesystem::path& path) {
    if (file.size() > maxObjBytes)
        return fail(ErrorCode::TooLarge, Sentence("at most {0} bytes are read, the file has at least {1}",
                                                  maxObjBytes, file.size()));
    MeshFile made;
    const auto materials = [&](const std::string& name) -> std::optional<std::string> {
        const std::filesystem::path library = path.parent_path() / name;
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(library, ignored)) // a pipe would be waited for
            return std::nullopt;
        Result<std::string> text = readText(library, maxMaterialBytes);
        if (!text)
            return std::nullopt;
        made.libraries.push_back(library);
        return *std::move(text);
    };
    Result<ObjFile> decoded = decodeObj(file, materials, maxMeshParts);
    if (!decoded)
        return fail(decoded.error());
    made.obj = *std::move(decoded);
    moveToMiddle(made.obj);
    return made;
}

std::size_t byteCount(const MeshFile& file) {
    std::size_t bytes = 0;
    for (const ObjPart& part : file.obj.parts)
        bytes += (part.mesh.positions.size() + part.mesh.normals.size()) * sizeof(glm::vec3) +
                 part.mesh.texCoords.size() * sizeof(glm::vec4) + part.mesh.indices.size() * sizeof(int);
    return bytes;
}

MeshData meshOf(const MeshData& model, const MeshFile* file) {
    const auto part = static_cast<std::size_t>(model.part); // a negative one is none
    MeshData mesh = file && part < file->obj.parts.size() ? file->obj.parts[part].mesh : MeshData{};
    mesh.primitive = model.primitive;
    mesh.file = model.file;
    mesh.part = model.part;
    return mesh;
}

} // namespace texplorer
