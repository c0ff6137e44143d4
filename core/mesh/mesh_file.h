#pragma once

// OBJ files of which scenes are made, and whose vertices models may show without having them in the scene
// (MeshData::file).

#include "texplorer/mesh/obj_file.h"

#include <cstddef>
#include <filesystem>
#include <vector>

namespace texplorer {

/// What an OBJ file and its libraries have. The parts are moved and scaled together so that the corners of
/// the box around them are at a distance of 2 from the origin.
struct MeshFile {
    ObjFile obj;
    std::vector<std::filesystem::path> libraries; ///< of materials: those that were read
};

/// The most bytes of an OBJ file: about as many as a part of maxFileVertices takes, with all its numbers.
inline constexpr std::size_t maxObjBytes = std::size_t{256} << 20;

/// A file has at most as many parts as a scene has models.
inline constexpr std::size_t maxMeshParts = 16;

/// Whether a file's name ends with .obj, in any case.
[[nodiscard]] bool isObjName(const std::filesystem::path& file);

/// Decodes an OBJ file, and reads its libraries, which lie relative to its `path`. Errors: those of
/// decodeObj(); `where` is empty.
[[nodiscard]] Result<MeshFile> meshFileIn(ByteView file, const std::filesystem::path& path);

/// Of all lists.
[[nodiscard]] std::size_t byteCount(const MeshFile& file);

/// The mesh of a model that names a file: that of its part, as the model's primitive; without vertices if the
/// file is nullptr or has no such part.
[[nodiscard]] MeshData meshOf(const MeshData& model, const MeshFile* file);

} // namespace texplorer
