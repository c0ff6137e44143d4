#pragma once

// A scene of the models in a Wavefront OBJ file.

#include "texplorer/base/result.h"
#include "texplorer/mesh/obj_file.h"
#include "texplorer/scene/scene.h"

#include <filesystem>
#include <vector>

namespace texplorer {

/// Whether a file's name ends with .obj, in any case.
[[nodiscard]] bool isObjName(const std::filesystem::path& file);

/// The models, moved and scaled to the middle of the picture: one for each part, one pass for each image of a
/// material, with the light and the view of defaultScene(). A part without an image shows the checkerboard,
/// so that its texture coordinates are seen. Parts with further images than passes are drawn with the last
/// one.
[[nodiscard]] Scene sceneOf(const ObjFile& file);

struct ObjScene {
    Scene scene;
    std::vector<Sentence> notes;                  ///< what of the files was left out
    std::vector<std::filesystem::path> libraries; ///< of materials: those that were read
};

/// Decodes an OBJ file that lies in `folder`, and reads its material libraries. Errors: those of decodeObj().
[[nodiscard]] Result<ObjScene> objSceneIn(ByteView file, const std::filesystem::path& folder);

} // namespace texplorer
