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
    unit().combine.rgb = CombineRgb::Add;
    using Lines = std::vector<const char*>;
    for (const auto& [mode, format, lines] :
         {std::tuple(EnvMode::Replace, InternalFormat::Rgb,
                     Lines{"Cv = Cs", "Av = Ap"}), // no alpha of its own
          std::tuple(EnvMode::Blend, InternalFormat::Intensity,
                     Lines{"Cv = Cp × (1 − Cs) + Cc × Cs", "Av = Ap × (1 − As) + Ac × As"}),
          std::tuple(EnvMode::Decal, InternalFormat::Luminance, Lines{"Cv = undefined; here Cp"}),
          std::tuple(EnvMode::Combine, InternalFormat::Luminance, Lines{"Cv = Cs + Cp"})}) {
        unit().envMode = mode;
        texture().internalFormat = format;
        frames(2);
        for (const char* line : lines)
            EXPECT_TRUE(says(line)) << line;
    }
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
