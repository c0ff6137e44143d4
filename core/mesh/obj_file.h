#pragma once

// Meshes in Wavefront OBJ files: vertices, texture coordinates, normals, polygons, and the colours and images
// of their materials.

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"
#include "texplorer/base/sentence.h"
#include "texplorer/mesh/mesh_data.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace texplorer {

struct ObjMaterial {
    std::string name;
    glm::vec4 color{1}; ///< diffuse colour and opacity: Kd and d
    /// map_Kd, with / between folders, relative to the OBJ file: in a library it is relative to the library's
    /// folder. Empty: none.
    std::string image;
};

/// The polygons of an object, or group, with one material.
struct ObjPart {
    std::string name; ///< of the object or group; may be empty
    int material = 0; ///< index into ObjFile::materials
    MeshData mesh;    ///< triangles with indices, normals, and texture coordinates if the file has some
};

struct ObjFile {
    std::vector<ObjPart> parts;         ///< not empty; none has more than maxFileVertices or maxFileIndices
    std::vector<ObjMaterial> materials; ///< those of the parts
    std::vector<Sentence> notes;        ///< what of the file was left out
};

/// Returns the text of a material library by the name that the file gives it, or nothing.
using ReadMaterials = std::function<std::optional<std::string>(const std::string& name)>;

/// Reads the polygons of an OBJ file. A polygon becomes a fan of triangles. Where a polygon has no normals,
/// each of its vertices has the mean of the triangles' normals at its position, by their areas. More than
/// `maxParts` parts are merged by material. Lines, points, curves and smoothing groups are left out. Errors:
/// those of checkedObjLines(); Malformed for a polygon of vertices that there are not, or no polygon;
/// TooLarge for more than `maxParts` materials, or a part that is too large.
[[nodiscard]] Result<ObjFile> decodeObj(ByteView file, const ReadMaterials& materials, std::size_t maxParts);

} // namespace texplorer
