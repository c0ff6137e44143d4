#pragma once

// The lines of a Wavefront OBJ file, checked.

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"

#include <string>
#include <vector>

namespace texplorer {

/// The lines of vertices, polygons, objects, groups and materials, without comments, continuations and a byte
/// order mark; other lines are left out.
struct ObjLines {
    std::string text;
    std::vector<int> polygonLines;      ///< the number in the file, from 1, of each polygon's line
    std::vector<std::string> libraries; ///< the names after mtllib, each once
    std::size_t triangles = 0;          ///< that the polygons fall into
    std::size_t names = 0;              ///< lines that name an object, a group or a material
    std::size_t numbers = 0;            ///< lines of positions, texture coordinates and normals
};

// What a file may have: a fan of triangles needs 18 times the bytes of its line, and each part has copies of
// its names.
inline constexpr std::size_t maxObjLineBytes = std::size_t{1} << 20;
inline constexpr std::size_t maxObjNameBytes = 1024;
inline constexpr std::size_t maxObjNames = 65536;
inline constexpr std::size_t maxObjTriangles = 6'000'000;
inline constexpr std::size_t maxObjNumbers = 12'000'000;

/// Whether the first line that says something is one of an OBJ file.
[[nodiscard]] bool beginsAsObj(ByteView file);

/// Errors: Malformed for a byte that no text has, a number that is none or not finite, and a polygon of fewer
/// than three vertices; TooLarge beyond the limits above; `where` is empty, the sentence names the line.
[[nodiscard]] Result<ObjLines> checkedObjLines(ByteView file);

} // namespace texplorer
