// Texture objects and units, call by call, as the OpenGL 2.1 specification has them (3.8.12 to 3.8.14). That
// OpenGL does the same is tests/render/texture_names_test.cpp's affair.

#include "texplorer/reference/texture_calls.h"

#include <gtest/gtest.h>

#include <vector>

namespace texplorer::objects::texture_calls_test {
namespace {

TextureNames after(const std::vector<Call>& calls) {
    TextureNames names;
    for (const Call& call : calls)
        apply(names, call);
    return names;
}

TEST(TextureCalls, AGeneratedNameIsNoObjectUntilItIsBound) {
    TextureNames names;
    EXPECT_EQ(apply(names, GenTexture{}).name, 1U);
    EXPECT_EQ(apply(names, GenTexture{}).name, 2U);
    EXPECT_EQ(apply(names, IsTexture{1}).isTexture, false);
    EXPECT_FALSE(names.names.at(1));
    apply(names, BindTexture{1});
    EXPECT_EQ(apply(names, IsTexture{1}).isTexture, true);
    EXPECT_EQ(apply(names, IsTexture{2}).isTexture, false);
    EXPECT_EQ(apply(names, IsTexture{0}).isTexture, false) << "0 is the object that has no name";
    EXPECT_EQ(apply(names, IsTexture{9}).isTexture, false);
}

TEST(TextureCalls, ANewObjectHasTheInitialValues) {
    const TextureNames names = after({BindTexture{5}});
    const TextureObject& object = names.objectOf(0);
    EXPECT_EQ(object.state.minFilter, MinFilter::NearestMipmapLinear);
    EXPECT_EQ(object.state.magFilter, MagFilter::Linear);
    EXPECT_EQ(object.state.wrapS, Wrap::Repeat);
    EXPECT_FALSE(object.picture);
}

TEST(TextureCalls, BindingBringsBackTheObjectsStateAndLeavesTheUnitsAlone) {
    const TextureNames names =
        after({BindTexture{1}, setParameter(MagFilter::Nearest), GiveImage{2}, SetEnvMode{EnvMode::Decal},
               BindTexture{2}, setWrapS(Wrap::Clamp), EnableTexture{}, BindTexture{1}});
    EXPECT_EQ(names.objectOf(0).state.magFilter, MagFilter::Nearest);
    EXPECT_EQ(names.objectOf(0).state.wrapS, Wrap::Repeat) << "that was object 2's";
    EXPECT_EQ(names.objectOf(0).picture, 2);
    EXPECT_EQ(names.units[0].envMode, EnvMode::Decal);
    EXPECT_TRUE(names.units[0].enabled);
    EXPECT_EQ(names.units[1], UnitState{}) << "each unit has its own";
}

TEST(TextureCalls, NameZeroIsAnObjectToo) {
    const TextureNames names = after({setParameter(MinFilter::Nearest), BindTexture{1}, BindTexture{0}});
    EXPECT_EQ(names.objectOf(0).state.minFilter, MinFilter::Nearest);
}

TEST(TextureCalls, DeletingABoundObjectBindsZero) {
    const TextureNames names =
        after({BindTexture{1}, ActiveTexture{1}, BindTexture{1}, ActiveTexture{0}, DeleteTexture{1}});
    EXPECT_EQ(names.units[0].bound, 0U);
    EXPECT_EQ(names.units[1].bound, 0U);
    EXPECT_FALSE(names.names.contains(1));
    TextureNames again = names;
    EXPECT_EQ(apply(again, GenTexture{}).name, 1U) << "the name is free";
    EXPECT_EQ(after({DeleteTexture{0}, DeleteTexture{7}}), TextureNames{}) << "both are passed over";
}

TEST(TextureCalls, AnIncompleteTextureDrawsAsIfOff) {
    std::vector<Call> calls{BindTexture{1}};
    EXPECT_EQ(sampledBy(after(calls), 0), Sampled::Off);
    calls.emplace_back(EnableTexture{});
    EXPECT_EQ(sampledBy(after(calls), 0), Sampled::NoImage);
    calls.emplace_back(GiveImage{0});
    EXPECT_EQ(sampledBy(after(calls), 0), Sampled::NoMipmaps) << "the filter that every object begins with";
    calls.emplace_back(setParameter(MinFilter::Linear));
    EXPECT_EQ(sampledBy(after(calls), 0), Sampled::Textured);
    EXPECT_EQ(sampledBy(after(calls), 1), Sampled::Off);
}

// MODULATE: 0.5 * 0.4; DECAL and REPLACE of RGB: the texel.
TEST(TextureCalls, TheUnitsEnvironmentAppliesTheObject) {
    std::vector<Call> calls{BindTexture{1}, EnableTexture{}, GiveImage{0}};
    const glm::vec4 fragment(0.5F, 0.5F, 1, 1);
    const glm::vec4 texel(0.4F, 0.8F, 0, 1);
    EXPECT_EQ(colorAfter(after(calls), 0, fragment, texel), fragment);
    calls.emplace_back(setParameter(MinFilter::Nearest));
    EXPECT_EQ(colorAfter(after(calls), 0, fragment, texel), glm::vec4(0.2F, 0.4F, 0, 1));
    calls.emplace_back(SetEnvMode{EnvMode::Decal});
    EXPECT_EQ(colorAfter(after(calls), 0, fragment, texel), texel);
}

TEST(TextureCalls, AreWrittenAsC) {
    EXPECT_EQ(codeOf(GenTexture{}, {.name = 3, .isTexture = {}}), "glGenTextures(1, &name);  // 3");
    EXPECT_EQ(codeOf(BindTexture{1}), "glBindTexture(GL_TEXTURE_2D, 1);");
    EXPECT_EQ(codeOf(IsTexture{1}, {.name = {}, .isTexture = false}), "glIsTexture(1);  // GL_FALSE");
    EXPECT_EQ(codeOf(DeleteTexture{2}), "glDeleteTextures(1, &name2);");
    EXPECT_EQ(codeOf(ActiveTexture{1}), "glActiveTexture(GL_TEXTURE1);");
    EXPECT_EQ(codeOf(EnableTexture{false}), "glDisable(GL_TEXTURE_2D);");
    EXPECT_EQ(codeOf(EnableTexture{true}), "glEnable(GL_TEXTURE_2D);");
    EXPECT_EQ(codeOf(SetEnvMode{EnvMode::Decal}),
              "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);");
    EXPECT_EQ(codeOf(setParameter(MagFilter::Nearest)),
              "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);");
    EXPECT_EQ(codeOf(GiveImage{1}),
              "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 64, 64, 0, GL_RGB, GL_UNSIGNED_BYTE, image1);");
}

} // namespace
} // namespace texplorer::objects::texture_calls_test
