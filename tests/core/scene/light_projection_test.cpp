#include "texplorer/diagnosis/diagnosis.h"
#include "texplorer/scene/light_projection.h"

#include <gtest/gtest.h>

namespace texplorer::light_projection_test {
namespace {

/// Nothing but what is known to have no effect.
void expectSound(const Scene& scene) {
    for (const Finding& finding : diagnose(scene, {}))
        EXPECT_GE(finding.severity, Severity::Note) << finding.path << ": " << finding.sentence;
}

TEST(ProjectFromLight, GeneratesEyeCoordinatesAndEndsWithTheLightsView) {
    Scene scene = defaultScene();
    Unit& unit = scene.passes[0].units[0];
    unit.matrix = {{.op = MatrixOp::Translate, .amount = {0.5F, 0, 0}}};
    unit.texGenR.eyePlane = {1, 2, 3, 4};
    unit.texGenS.mode = TexGenMode::SphereMap;
    ASSERT_TRUE(projectFromLight(unit));
    EXPECT_EQ(unit.matrix.size(), 2U);
    EXPECT_EQ(unit.matrix.back().op, MatrixOp::Projector);
    EXPECT_EQ(unit.texGenR.eyePlane, glm::vec4(0, 0, 1, 0));
    EXPECT_EQ(unit.texGenQ.eyePlane, glm::vec4(0, 0, 0, 1));
    EXPECT_EQ(unit.texGenS.mode, TexGenMode::EyeLinear);
    expectSound(scene);
    const Unit once = unit;
    ASSERT_TRUE(projectFromLight(unit));
    EXPECT_EQ(unit, once);
    unit.matrix.assign(maxMatrixSteps, {});
    EXPECT_FALSE(projectFromLight(unit)) << "there is no room";
}

TEST(CastShadows, AddsATextureOfWhatTheLightSees) {
    Scene scene = defaultScene();
    ASSERT_TRUE(castShadows(scene, 0, 1));
    ASSERT_EQ(scene.textures.size(), 2U);
    const Unit& unit = scene.passes[0].units[1];
    EXPECT_TRUE(unit.enabled);
    EXPECT_EQ(unit.texture, 1);
    EXPECT_EQ(scene.textures[1].source, SourceKind::LightDepth);
    EXPECT_EQ(scene.textures[1].compareMode, CompareMode::RToTexture);
    expectSound(scene);
    const Scene full = [&] {
        Scene many = scene;
        many.textures.resize(maxTextures);
        return many;
    }();
    Scene same = full;
    EXPECT_FALSE(castShadows(same, 0, 0));
    EXPECT_EQ(same, full);
}

} // namespace
} // namespace texplorer::light_projection_test
