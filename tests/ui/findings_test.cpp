// What the diagnosis says, in the window: the sign beside the control, the status bar, the way there and the
// fix.

#include "tests/ui/workbench.h"

namespace texplorer::ui::test {
namespace {

class Findings : public Workbench {};

TEST_F(Findings, TheDefaultSceneHasNone) {
    EXPECT_FALSE(has("finding"));
    EXPECT_FALSE(has("textures[0].minFilter#problem"));
}

TEST_F(Findings, AWarningIsShownAndMendedByOneClick) {
    choose("textures[0].mipmaps", "none");
    EXPECT_TRUE(has("textures[0].minFilter#problem"));
    EXPECT_FALSE(has("textures[0].wrapS#problem"));
    click("apply fix");
    EXPECT_EQ(texture().mipmaps, MipPolicy::Generated);
    EXPECT_FALSE(has("finding"));
    EXPECT_FALSE(has("textures[0].minFilter#problem"));
    key('Z', {ctrl});
    EXPECT_EQ(texture().mipmaps, MipPolicy::None);
    EXPECT_TRUE(has("finding"));
}

TEST_F(Findings, WhatADriverLacksIsNoMatterWhereOnlyTheReferenceDraws) {
    texture().border = 1; // Mesa takes it away
    frames(2);
    EXPECT_TRUE(has("textures[0].border#problem"));
    showOne(session->views, RendererKind::Reference);
    frames(2);
    EXPECT_FALSE(has("textures[0].border#problem"));
    showComparison(session->views, {RendererKind::Fixed, RendererKind::Reference});
    frames(2);
    EXPECT_TRUE(has("textures[0].border#problem"));
}

TEST_F(Findings, AClickOnTheSentenceLeadsToTheControl) {
    Unit& third = scene().passes[0].units[2];
    third.enabled = true;
    third.matrix = {{MatrixOp::Scale, {1, 0, 1}}};
    frames(2);
    EXPECT_FALSE(has("passes[0].units[2].matrix[0].amount[1]"));
    click("finding");
    EXPECT_EQ(session->selection.unit, 2);
    frames(2);
    const ImVec2 control = place("passes[0].units[2].matrix[0].amount[1]"); // fails where it is out of sight
    EXPECT_LT(control.x, static_cast<float>(layout.parameters.right()));
    EXPECT_TRUE(has("passes[0].units[2].matrix[0].amount#problem"));
    EXPECT_EQ(session->shownParam, "passes[0].units[2].matrix[0].amount");
    click("apply fix");
    EXPECT_EQ(third.matrix[0].amount, glm::vec3(1));
}

TEST_F(Findings, ABadVertexLeadsToItsModel) {
    TexCoords& list = scene().models[1].texCoords[0];
    list.assign(vertexCount(Shape::Sphere, 32, 16), glm::vec4(0, 0, 0, 1));
    list[7].w = 0;
    frames(2);
    click("finding");
    EXPECT_EQ(session->selection.model, 1);
}

TEST_F(Findings, WhatHasNoEffectIsDimEverywhere) {
    EXPECT_TRUE(has("passes[0].units[0].envColor#inert"));
    choose("passes[0].units[0].envMode", "GL_BLEND");
    EXPECT_FALSE(has("passes[0].units[0].envColor#inert"));
    EXPECT_FALSE(has("textures[0].maxLevel#inert"));
    choose("textures[0].minFilter", "GL_NEAREST");
    EXPECT_TRUE(has("textures[0].maxLevel#inert"));
    EXPECT_FALSE(has("finding")) << "a hint is no warning";
}

} // namespace
} // namespace texplorer::ui::test
