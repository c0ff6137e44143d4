#pragma once

#include "tests/random/soak.h"
#include "texplorer/base/result.h"

#include <filesystem>
#include <string>

namespace texplorer::random {

struct SceneSoak {
    unsigned seed = 1;
    std::filesystem::path keep;    ///< where the scenes that failed are kept, with the files that they name
    std::filesystem::path shaders; ///< of the shader renderer; empty: the built-in ones
};

/// Random scenes, in batches with Mesa's shortcuts and without in turn. Each that fails is kept as JSON.
/// Throws std::exception where the files can't be written.
[[nodiscard]] Subject randomScenes(const SceneSoak& soak);

struct SceneFiles {
    std::string folder;
    unsigned seed = 1;
    int count = 100;
    bool tame = false; ///< what llvmpipe survives: without numbers at their limits and anisotropy
};

/// Random scenes that name no images, as folder/scene-0.json and so on.
[[nodiscard]] Result<void> writeScenes(const SceneFiles& files);

} // namespace texplorer::random
