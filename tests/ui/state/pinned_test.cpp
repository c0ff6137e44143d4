#include "app/ui/state/pinned.h"

#include <gmock/gmock.h>

namespace texplorer::ui::pinned_test {
namespace {

TEST(Pins, AreForParametersOfAnyTextureUnitOrModel) {
    EXPECT_EQ(patternOf("textures[12].wrapR"), "textures[].wrapR");
    EXPECT_EQ(patternOf("passes[0].units[3].texGenS.mode"), "passes[].units[].texGenS.mode");
    EXPECT_EQ(patternOf("light.ambient"), "light.ambient");
    EXPECT_EQ(patternOf(""), "");
    EXPECT_EQ(patternOf("textures[1"), "textures[") << "what is no path is none afterwards either";
}

TEST(Pins, ComeAndGo) {
    Settings settings;
    togglePin(settings, "textures[0].wrapR");
    togglePin(settings, "light.ambient");
    EXPECT_THAT(settings.pinned, testing::ElementsAre("textures[].wrapR", "light.ambient"));
    EXPECT_TRUE(isPinned(settings, "textures[7].wrapR"));
    EXPECT_FALSE(isPinned(settings, "textures[7].wrapS"));
    togglePin(settings, "textures[3].wrapR");
    EXPECT_THAT(settings.pinned, testing::ElementsAre("light.ambient"));
}

TEST(Pins, KnowWhatEssentialsHasAnyway) {
    EXPECT_TRUE(isEssential("textures[2].minFilter"));
    EXPECT_TRUE(isEssential("passes[1].units[3].envMode"));
    EXPECT_TRUE(isEssential("material.color"));
    EXPECT_FALSE(isEssential("models[0].material.color")) << "a model's own is another";
    EXPECT_FALSE(isEssential("textures[2].wrapR"));
}

} // namespace
} // namespace texplorer::ui::pinned_test
