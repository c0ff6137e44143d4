#pragma once

#include "app/render/pipeline.h"
#include "texplorer/scene/texture_matrix.h"

#include <array>
#include <vector>

namespace texplorer::render {

/// The GL_TEXTURE matrix stacks of the fixed-function pipeline, used as the scene says: see
/// texplorer/scene/texture_matrix.h. Every function leaves GL_MODELVIEW as the current matrix.
class TextureStacks {
public:
    /// `units`: how many the driver has.
    explicit TextureStacks(int units);

    void beginFrame();
    void beginPass(const Scene& scene, std::size_t pass, const BoundTextures& textures, double time);
    void beginModel(const Scene& scene, std::size_t pass, std::size_t model, double time);
    void endModel();
    void endPass();

private:
    /// What a matrix begins with before the scene's steps, because of a texture.
    struct Start {
        bool comparesLine = false;
        bool flips = false;

        bool operator==(const Start&) const = default;
    };
    struct Pushed {
        std::size_t unit;
        Start start; ///< of the matrix that was pushed
    };

    static Start startOf(const BoundTexture& texture, Target target);
    static void load(const Start& start);
    void multiply(const PlacedSteps& steps, std::size_t unit, double time, const Light& light);
    void push(std::size_t unit, std::vector<Pushed>& pushed);
    void pop(std::vector<Pushed>& pushed);

    std::size_t units_;
    std::array<Start, maxUnits> starts_{}; ///< of the matrices on top
    std::vector<Pushed> byPass_;
    std::vector<Pushed> byModel_;
    bool modelsHaveSteps_ = false; ///< some model of the current pass does
};

} // namespace texplorer::render
