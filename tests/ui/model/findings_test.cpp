// The findings of the diagnosis in the window: the mark next to the control, the status bar, the link to the
// control and the fix.

#include "tests/ui/workbench.h"

namespace texplorer::ui::findings_test {
namespace {

using namespace test;

class Findings : public Workbench {};

TEST_F(Findings, TheDefaultSceneHasNone) {
    EXPECT_FALSE(has("finding"));
    EXPECT_FALSE(has("textures[0].minFilter#problem"));
}

TEST_F(Findings, AWarningIsShownAndMendedByOneClick) {
    choose("textures[0].mipmaps", "none");
    EXPECT_TRUE(has("textures[0].minFilter#problem"));
    EXPECT_FALSE(has("textures[0].wrapS#problem"));
    click("fix:Generate mipmaps");
    EXPECT_EQ(texture().mipmaps, MipPolicy::Generated);
    EXPECT_FALSE(has("finding"));
    EXPECT_FALSE(has("textures[0].minFilter#problem"));
    key('Z', {ctrl});
    EXPECT_EQ(texture().mipmaps, MipPolicy::None);
    EXPECT_TRUE(has("finding"));
}

TEST_F(Findings, EachWayToMendItIsOneClick) {
    choose("textures[0].mipmaps", "none");
    click("fix:End at level 0");
    EXPECT_EQ(texture().maxLevel, 0);
    EXPECT_FALSE(has("finding"));
    key('Z', {ctrl});
    click("fix:Set GL_LINEAR");
    EXPECT_EQ(texture().minFilter, MinFilter::Linear);
    EXPECT_FALSE(has("finding"));
    EXPECT_EQ(texture().maxLevel, 1000);
}

TEST_F(Findings, TheSignBesideTheControlMendsToo) {
    choose("textures[0].mipmaps", "none");
    scrollTo("textures[0].minFilter");
    click("textures[0].minFilter#problem");
    click("textures[0].minFilter#fix:End at level 0");
    EXPECT_EQ(texture().maxLevel, 0);
    EXPECT_FALSE(has("textures[0].minFilter#problem"));
    EXPECT_FALSE(has("textures[0].minFilter#fix:End at level 0")) << "the list is shut again";
}

TEST_F(Findings, ASmallWindowOffersTheFirstWayAndTheOthersAtTheControl) {
    start(defaultScene(), 640, 400);
    texture().mipmaps = MipPolicy::None;
    frames(3);
    EXPECT_TRUE(has("fix:Generate mipmaps"));
    EXPECT_FALSE(has("fix:Set GL_LINEAR"));
    EXPECT_TRUE(has("finding"));
}

TEST_F(Findings, WhatADriverLacksIsNoMatterWhereOnlyTheReferenceDraws) {
    states.parameters.tab = ParameterTab::Texture;
    texture().border = 1; // Mesa removes it
    frames(2);
    EXPECT_TRUE(has("textures[0].border#problem"));
    showOne(session->view, RendererKind::Reference);
    frames(2);
    EXPECT_FALSE(has("textures[0].border#problem"));
    showComparison(session->view, {RendererKind::Fixed, RendererKind::Reference});
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
    EXPECT_EQ(session->look.selection.unit, 2);
    frames(2);
    const ImVec2 control = place("passes[0].units[2].matrix[0].amount[1]"); // fails if it is not visible
    EXPECT_LT(control.x, static_cast<float>(layout.parameters.right()));
    EXPECT_TRUE(has("passes[0].units[2].matrix[0].amount#problem"));
    EXPECT_EQ(session->look.shownParam, "passes[0].units[2].matrix[0].amount");
    click("fix:Scale by 1"); // which makes another scene
    EXPECT_EQ(scene().passes[0].units[2].matrix[0].amount, glm::vec3(1));
}

TEST_F(Findings, ABadVertexLeadsToItsModel) {
    TexCoords& list = scene().models[1].texCoords[0].edit();
    list.assign(vertexCount({Shape::Sphere, 32, 16}), glm::vec4(0, 0, 0, 1));
    list[7].w = 0;
    frames(2);
    click("finding");
    EXPECT_EQ(session->look.selection.model, 1);
}

TEST_F(Findings, AVertexWithoutGlTexCoordIsSelectedInItsList) {
    scene().passes[0].units[1].enabled = true;
    Model& model = scene().models[1];
    model.shape = Shape::Mesh;
    model.mesh = {.primitive = Primitive::Triangles,
                  .positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                  .indices = {2, 3, 0, 0, 1, 2}};
    model.noTexCoord[1] = {0, 3}; // 3 is sent first
    states.details.vertices.part = VertexPart::Position;
    session->settings.workspace.maximised = Maximised::None;
    frames(2);
    click("finding");
    frames(2);
    EXPECT_EQ(session->look.selection.model, 1);
    EXPECT_EQ(session->look.selection.unit, 1);
    EXPECT_EQ(session->look.selection.vertex, std::optional<std::size_t>(3));
    static_cast<void>(place("glTexCoord:3")); // fails if it is not visible
    click("show Position");                   // the list is the user's again
    EXPECT_FALSE(has("glTexCoord:3"));
}

TEST_F(Findings, WhatHasNoEffectIsDimEverywhere) {
    EXPECT_TRUE(has("passes[0].units[0].envColor#inert"));
    choose("passes[0].units[0].envMode", "GL_BLEND");
    EXPECT_FALSE(has("passes[0].units[0].envColor#inert"));
    states.parameters.tab = ParameterTab::Texture;
    frames(2);
    EXPECT_FALSE(has("textures[0].maxLevel#inert"));
    choose("textures[0].minFilter", "GL_NEAREST");
    EXPECT_TRUE(has("textures[0].maxLevel#inert"));
    EXPECT_FALSE(has("finding")) << "a hint is no warning";
}

TEST_F(Findings, LightAndMaterialAreDimUnderATextureThatReplacesThem) {
    open("Light");
    open("Material");
    const std::initializer_list<const char*> hidden{"material.color", "material.specular",
                                                    "material.shininess", "light.diffuse"};
    for (const char* path : hidden)
        EXPECT_FALSE(has(path + std::string("#inert"))) << path;
    unit().envMode = EnvMode::Replace;
    frames(2);
    for (const char* path : hidden) {
        scrollTo(path);
        EXPECT_TRUE(has(path + std::string("#inert"))) << path;
    }
    EXPECT_FALSE(has("light.colorControl#inert")) << "it brings the highlight back";
}

TEST_F(Findings, CoordinatesThatNoUnitReadsAreDim) {
    putListRight();
    EXPECT_FALSE(has("coordinates#inert"));
    click("unit:2");
    EXPECT_TRUE(has("coordinates#inert"));
    scene().passes[0].units[2].enabled = true;
    frames(2);
    EXPECT_FALSE(has("coordinates#inert"));
    scene().models[0].visible = false;
    frames(2);
    EXPECT_TRUE(has("coordinates#inert"));
}

TEST_F(Findings, AHiddenModelIsDimButForItsSwitch) {
    open("Model");
    scene().models[0].visible = false;
    frames(2);
    scrollTo("models[0].size");
    EXPECT_TRUE(has("models[0].size#inert"));
    EXPECT_FALSE(has("models[0].visible#inert"));
}

} // namespace
} // namespace texplorer::ui::findings_test
