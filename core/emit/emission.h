#pragma once

#include "core/emit/code_writer.h"
#include "core/emit/model_data.h"
#include "core/scene/scene.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::emit {

/// A name that glGenTextures gives: OpenGL binds a texture object to one target for good.
struct TextureObject {
    std::size_t texture; ///< of the scene's
    Target target;

    bool operator==(const TextureObject&) const = default;
};

/// One object for each texture, in their order; then those that show one on another target, too.
[[nodiscard]] std::vector<TextureObject> textureObjectsOf(const Scene& scene);

/// What is written, and what the parts of it have to know of each other.
struct Emission {
    explicit Emission(const Scene& drawn);

    const Scene& scene;
    CodeWriter writer;
    std::vector<TextureObject> objects;
    std::vector<ModelForm> models; ///< how each is drawn
    bool needsNormals;             ///< some pass is lit or reflects

    int activeUnit = 0;
    std::array<std::optional<Target>, maxUnits> shown{};
    std::array<bool, maxUnits> hasMatrix{};

    /// What variables of a pass begin with; nothing where there is only one.
    [[nodiscard]] std::string passVariable(std::size_t pass) const;
};

void writeTextures(Emission& emission);
void writeImages(Emission& emission, const Holder& holder, std::size_t texture);
void writeProjection(Emission& emission);
void writeLight(Emission& emission);
void writeCamera(Emission& emission);
/// The scene's: all of it.
void writeMaterial(Emission& emission);
/// A model's: what differs from the one that was written before.
void writeMaterial(Emission& emission, std::size_t model);
void writeUnits(Emission& emission, std::size_t pass);
/// The arrays of models that are drawn from arrays.
void writeModelData(Emission& emission, std::size_t model);
void writeModel(Emission& emission, std::size_t pass, std::size_t model);

} // namespace texplorer::emit
