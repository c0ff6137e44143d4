#pragma once

// Reads scenes from JSON files, from PNG files of texshot, which contain their scene as a text, and from OBJ
// files.

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"
#include "texplorer/mesh/mesh_file.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace texplorer {

/// The keyword of the complete scene in a PNG.
inline constexpr const char* sceneKeyword = N_("Texplorer scene");

/// The maximum size of a file that begins like this: larger for a PNG, which also has pixels.
[[nodiscard]] std::size_t maxSceneFileBytes(ByteView start);

/// Returns the JSON of a scene file: the bytes themselves, or the text in a PNG, up to the limit of scene
/// files. Errors: NotFound for a PNG without scene; Malformed, TooLarge. `where` is empty.
[[nodiscard]] Result<std::string> sceneTextIn(ByteView file);

/// The JSON of a scene, and what else an OBJ file has.
struct SceneContent {
    std::string text;
    std::vector<Sentence> notes{};            ///< what was left out
    std::shared_ptr<const MeshFile> meshes{}; ///< of an OBJ file
};

/// Returns the scene of an OBJ file of this name. Errors: TooLarge for a scene that could not be read again,
/// or whose vertices have to stay in a file that has no name.
[[nodiscard]] Result<SceneContent> sceneOfObj(MeshFile file, const std::string& name);

/// Returns the content of a scene file on disk, which is named in `where`; of an OBJ file the scene of its
/// models.
[[nodiscard]] Result<SceneContent> readSceneFile(const std::filesystem::path& file);

/// Whether a file is a PNG with a scene text, valid or not, among its first chunks. Reads little more than
/// the heads of the chunks. False if it cannot be read.
[[nodiscard]] bool isPictureWithScene(const std::filesystem::path& file, std::size_t maxChunks = 100'000);

} // namespace texplorer
