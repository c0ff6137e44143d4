#pragma once

// A scene of the models in a Wavefront OBJ file.

#include "texplorer/mesh/obj_file.h"
#include "texplorer/scene/scene.h"

#include <string>

namespace texplorer {

/// Whether a scene of it can have its vertices: the limits of a mesh hold for all of its parts together.
[[nodiscard]] bool isSmall(const ObjFile& file);

/// The models: one for each part, one pass for each image of a material, with the light and the view of
/// defaultScene(). A part without an image shows the checkerboard, so that its texture coordinates are seen.
/// Parts with further images than passes are drawn with the last one. The models of a file that is not small
/// have their meshes in the file of this `name`.
[[nodiscard]] Scene sceneOf(const ObjFile& file, const std::string& name);

} // namespace texplorer
