// The equation next to the environment's mode, as in the tables of section 3.8.13.

#include "app/ui/model/explaining.h"
#include "tests/ui/workbench.h"

namespace texplorer::ui::environment_line_test {
namespace {

using namespace test;

class EnvironmentLine : public Workbench {
protected:
    [[nodiscard]] bool says(std::string_view line) const { return has("environment:" + std::string(line)); }
};

TEST_F(EnvironmentLine, IsThatOfTheModeAndTheBaseFormat) {
    EXPECT_TRUE(says("Cv = Cp × Cs"));
    EXPECT_TRUE(says("Av = Ap × As"));
    texture().internalFormat = InternalFormat::Rgb;
    unit().envMode = EnvMode::Replace;
    frames(2);
    EXPECT_TRUE(says("Cv = Cs"));
    EXPECT_TRUE(says("Av = Ap")) << "RGB has no alpha";
    unit().envMode = EnvMode::Blend;
    texture().internalFormat = InternalFormat::Intensity;
    frames(2);
    EXPECT_TRUE(says("Cv = Cp × (1 − Cs) + Cc × Cs"));
    EXPECT_TRUE(says("Av = Ap × (1 − As) + Ac × As"));
    unit().envMode = EnvMode::Decal;
    texture().internalFormat = InternalFormat::Luminance;
    frames(2);
    EXPECT_TRUE(says("Cv = undefined; here Cp"));
    unit().envMode = EnvMode::Combine;
    unit().combine.rgb = CombineRgb::Add;
    frames(2);
    EXPECT_TRUE(says("Cv = Cs + Cp"));
}

TEST_F(EnvironmentLine, IsThatOfThePreviewedMode) {
    moveTo(place("passes[0].units[0].envMode=GL_ADD"));
    frames(1);
    EXPECT_TRUE(says("Cv = Cp + Cs"));
    moveTo(place("view"));
    frames(1);
    EXPECT_TRUE(says("Cv = Cp × Cs"));
}

TEST_F(EnvironmentLine, IsOfTheProbedPixelWhereThereIsOne) {
    EXPECT_FALSE(has("environment:probed"));
    session->look.explaining.pixel = {layout.picture.width / 2, layout.picture.height / 2};
    frames(3);
    ASSERT_TRUE(explanationOf(*session));
    EXPECT_EQ(has("environment:probed"), probedUnit(*session) != nullptr);
}

TEST_F(EnvironmentLine, StandsWithoutATexture) {
    scene().textures.clear();
    unit().enabled = false;
    frames(2);
    expectSoundFrame();
    click("parameters:Unit");
    expectSoundFrame();
    EXPECT_TRUE(has("environment:Cv"));
}

} // namespace
} // namespace texplorer::ui::environment_line_test
