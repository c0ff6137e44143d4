#pragma once

#include "core/emit/code.h"
#include "core/scene/scene.h"

namespace texplorer::emit {

/// The body of a C function that draws a scene once, in a context with OpenGL's initial state: textures,
/// camera, light, and each pass with its models. It is C99 with <GL/gl.h>, <GL/glext.h> and <GL/glu.h>. What
/// doesn't fit into a text, the texels of images and meshes of many vertices, is declared as extern arrays;
/// `seconds` is what animated scenes turn with.
[[nodiscard]] std::vector<Line> callsOf(const Scene& scene);

/// Meshes of more vertices are declared and not written out.
inline constexpr std::size_t mostWrittenVertices = 64;

/// "#include <GL/gl.h>" and the others that the calls need, ready for a compiler.
[[nodiscard]] std::string_view includes();

} // namespace texplorer::emit
