// OBJ files. An input is the file; its last half is also the library of materials.

#include "tests/fuzz/broken.h"
#include "texplorer/mesh/obj_file.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/storage/obj_scene.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

using namespace texplorer;

namespace {

void check(const MeshData& mesh) {
    const std::size_t count = mesh.positions.size();
    const bool fits = count <= maxFileVertices && mesh.indices.size() <= maxFileIndices &&
                      mesh.normals.size() == count &&
                      (mesh.texCoords.empty() || mesh.texCoords.size() == count);
    if (!fits || mesh.indices.empty() || mesh.indices.size() % 3 != 0)
        fuzz::broken("a mesh has lists of wrong lengths");
    if (std::ranges::any_of(mesh.indices,
                            [&](int index) { return index < 0 || std::cmp_greater_equal(index, count); }))
        fuzz::broken("an index names no vertex");
    if (std::ranges::any_of(mesh.normals, [](const glm::vec3& normal) {
            return !std::isfinite(normal.x) || !std::isfinite(normal.y) || !std::isfinite(normal.z);
        }))
        fuzz::broken("a normal is not finite");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const ByteView input = std::as_bytes(std::span(data, size));
    const std::string library(reinterpret_cast<const char*>(data) + size / 2, size - size / 2);
    constexpr std::size_t maxParts = 4;
    const Result<ObjFile> file = decodeObj(
        input, [&](const std::string&) { return std::optional(library); }, maxParts);
    if (!file) {
        if (file.error().message.empty())
            fuzz::broken("a refused file says nothing");
        return 0;
    }
    if (file->parts.empty() || file->parts.size() > maxParts)
        fuzz::broken("the number of parts is wrong");
    for (const ObjPart& part : file->parts)
        check(part.mesh);
    if (!parseScene(writeScene(sceneOf(*file, "a.obj"))))
        fuzz::broken("the scene can't be read again");
    return 0;
}
