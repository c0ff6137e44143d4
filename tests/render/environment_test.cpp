// The texture environment on the driver, against the specification's tables.

#include "tests/support/environment_cases.h"
#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"

#include <gmock/gmock.h>

namespace texplorer::environment_test {
namespace {

using namespace test;

constexpr Texel texel{153, 51, 204, 102}; // EnvironmentCase::texel, in 255ths

class Environment : public RenderTest, public testing::WithParamInterface<EnvironmentCase> {};

TEST_P(Environment, GivesTheNumberOfTheTable) {
    images.put("image", plainImage(1, 1, texel));
    Scene scene = texturedScene();
    scene.material.color = EnvironmentCase::fragment;
    scene.textures[0].internalFormat = internalFormat(GetParam().format);
    scene.passes[0].units[0].envMode = GetParam().mode;
    scene.passes[0].units[0].envColor = EnvironmentCase::environment;
    const glm::vec4 found = onlyColor(scene);
    EXPECT_THAT(problems, testing::IsEmpty());
    if (GetParam().expected) {
        EXPECT_TRUE(isColor(found, *GetParam().expected));
    }
}

INSTANTIATE_TEST_SUITE_P(Tables, Environment, testing::ValuesIn(environmentCases),
                         [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer::environment_test
