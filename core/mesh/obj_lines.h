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
};

/// Whether the first line that says something is one of an OBJ file.
[[nodiscard]] bool beginsAsObj(ByteView file);

/// Errors: Malformed for a byte that no text has, a number that is none or not finite, and a polygon of fewer
/// than three vertices; `where` is empty, the sentence names the line.
[[nodiscard]] Result<ObjLines> checkedObjLines(ByteView file);

} // namespace texplorer
