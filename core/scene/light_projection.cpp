#include "texplorer/scene/light_projection.h"

#include <utility>

namespace texplorer {

namespace {

/// What is taken off r, so that no surface lies in its own shadow.
constexpr float shadowBias = 0.006F;

} // namespace

bool projectFromLight(Unit& unit) {
    const bool isView = !unit.matrix.empty() && unit.matrix.back().op == MatrixOp::Projector;
    if (!isView && unit.matrix.size() >= maxMatrixSteps)
        return false;
    if (!isView)
        unit.matrix.push_back({.op = MatrixOp::Projector});
    int axis = 0;
    for (TexGen* each : {&unit.texGenS, &unit.texGenT, &unit.texGenR, &unit.texGenQ}) {
        each->enabled = true;
        each->mode = TexGenMode::EyeLinear;
        each->eyePlane = glm::vec4(0);
        each->eyePlane[axis++] = 1;
    }
    return true;
}

bool castShadows(Scene& scene, std::size_t pass, std::size_t unit) {
    Unit shadowed = scene.passes[pass].units[unit];
    shadowed.enabled = true;
    shadowed.target = Target::Texture2D;
    shadowed.envMode = EnvMode::Modulate;
    shadowed.texture = static_cast<int>(scene.textures.size());
    shadowed.matrixStart = MatrixStart::Identity;
    shadowed.matrix = {{.op = MatrixOp::Translate, .amount = {0, 0, -shadowBias}}};
    if (scene.textures.size() >= maxTextures || !projectFromLight(shadowed))
        return false;
    Texture depths;
    depths.source = SourceKind::LightDepth;
    depths.depthSize = 1024;
    depths.internalFormat = InternalFormat::DepthComponent24;
    depths.minFilter = MinFilter::Linear;
    depths.compareMode = CompareMode::RToTexture;
    depths.wrapS = depths.wrapT = Wrap::ClampToBorder; // beyond what the light sees all is lit
    depths.borderColor = glm::vec4(1);
    scene.textures.push_back(std::move(depths));
    scene.passes[pass].units[unit] = std::move(shadowed);
    return true;
}

} // namespace texplorer
