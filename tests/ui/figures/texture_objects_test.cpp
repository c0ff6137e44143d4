#include "tests/ui/figures/figure_bench.h"

#include <algorithm>

namespace texplorer::ui::texture_objects_test {
namespace {

using namespace test;
using objects::Sampled;

class TextureObjects : public FigureBench {
protected:
    TextureObjects()
        : FigureBench(Figure::Objects) {}

    [[nodiscard]] TextureObjectsState& state() { return figures().objects; }
    [[nodiscard]] const objects::TextureNames& names() { return state().names; }
    void clickAll(std::initializer_list<const char*> items) {
        for (const char* each : items)
            click(each);
    }
};

TEST_F(TextureObjects, AGeneratedNameIsMadeAnObjectByBinding) {
    const Scene before = scene();
    click("objects:gen");
    EXPECT_TRUE(has("objects:name only 1"));
    EXPECT_TRUE(has("objects:lit name 1"));
    click("objects:is 1");
    EXPECT_TRUE(has("objects:last glIsTexture(1);  // GL_FALSE"));
    click("objects:bind 1");
    EXPECT_FALSE(has("objects:name only 1"));
    EXPECT_TRUE(has("objects:bound 0 1"));
    click("objects:is 1");
    EXPECT_TRUE(has("objects:last glIsTexture(1);  // GL_TRUE"));
    EXPECT_EQ(scene(), before) << "it has a context of its own";
}

TEST_F(TextureObjects, ParametersGoToTheObjectAndTheEnvironmentToTheUnit) {
    clickAll({"objects:gen", "objects:gen", "objects:bind 1", "objects:mag=GL_NEAREST"});
    EXPECT_TRUE(has("objects:lit mag 1"));
    clickAll({"objects:min=GL_LINEAR", "objects:image 1", "objects:env 0=GL_DECAL", "objects:enable 0"});
    EXPECT_EQ(sampledBy(names(), 0), Sampled::Textured);
    click("objects:bind 2");
    EXPECT_EQ(sampledBy(names(), 0), Sampled::NoImage);
    EXPECT_EQ(names().units[0].envMode, EnvMode::Decal);
    EXPECT_EQ(names().objectOf(0).state.magFilter, MagFilter::Linear);
    click("objects:image 2");
    EXPECT_EQ(sampledBy(names(), 0), Sampled::NoMipmaps);
    click("objects:bind 1");
    EXPECT_EQ(names().objectOf(0).state.magFilter, MagFilter::Nearest);
    EXPECT_EQ(names().objectOf(0).picture, 1);
}

TEST_F(TextureObjects, CallsMeanTheActiveUnit) {
    clickAll({"objects:gen", "objects:unit 1", "objects:bind 1"});
    EXPECT_EQ(names().units[0].bound, 0U);
    EXPECT_EQ(names().units[1].bound, 1U);
    EXPECT_TRUE(has("objects:last glBindTexture(GL_TEXTURE_2D, 1);"));
    click("objects:env 0=GL_REPLACE"); // of an inactive unit
    EXPECT_EQ(names().units[0].envMode, EnvMode::Modulate);
}

TEST_F(TextureObjects, DeletingABoundObjectBindsZero) {
    clickAll({"objects:gen", "objects:bind 1", "objects:delete 1"});
    EXPECT_FALSE(names().names.contains(1));
    EXPECT_TRUE(has("objects:bound 0 0"));
    EXPECT_FALSE(has("objects:bind 1"));
}

TEST_F(TextureObjects, FourNamesAreAllThatHaveRoom) {
    for (int i = 0; i < 6; ++i)
        click("objects:gen");
    EXPECT_EQ(names().names.size(), 5U);
}

TEST_F(TextureObjects, PlaysTexbind) {
    for (std::size_t i = 0; i < texbindCalls().size(); ++i)
        click("objects:texbind");
    EXPECT_EQ(state().log.size(), texbindCalls().size());
    EXPECT_EQ(names().units[0].bound, 2U);
    EXPECT_EQ(names().units[0].envMode, EnvMode::Decal);
    EXPECT_EQ(sampledBy(names(), 0), Sampled::Textured);
    EXPECT_EQ(std::ranges::count_if(texbindCalls(),
                                    [](const ToldCall& each) {
                                        return std::holds_alternative<objects::SetEnvMode>(each.call);
                                    }),
              1);
    click("objects:bind 1"); // a call by the user ends it
    EXPECT_EQ(state().played, 0U);
    EXPECT_EQ(names().units[0].envMode, EnvMode::Decal);
    click("objects:texbind"); // starts again
    EXPECT_EQ(state().log.size(), 1U);
    click("objects:reset");
    EXPECT_EQ(names(), objects::TextureNames{});
    EXPECT_TRUE(state().log.empty());
}

} // namespace
} // namespace texplorer::ui::texture_objects_test
