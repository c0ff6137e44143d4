// Section 2.11.4 of the OpenGL 2.1 specification, worked out by hand. Against OpenGL:
// tests/render/tex_gen_test.cpp and reference_test.cpp.

#include "tests/core/reference/textures.h"
#include "texplorer/reference/shading/tex_gen.h"

namespace texplorer::reference::tex_gen_test {
namespace {

using namespace test;

constexpr glm::vec4 given{0.1F, 0.2F, 0.3F, 1};
// Straight ahead at a distance of 2, with a normal that leans by 45 degrees upwards: the eye's ray (0, 0, -1)
// is mirrored to (0, 1, 0).
const GenerationInputs inputs{
    .object = {1, 2, 3, 1}, .eye = {0, 0, -2, 1}, .normal = {0, std::sqrt(0.5F), std::sqrt(0.5F)}};

Unit generating(TexGenMode mode) {
    Unit unit;
    int i = 0;
    for (TexGen* state : {&unit.texGenS, &unit.texGenT, &unit.texGenR, &unit.texGenQ}) {
        ++i;
        const auto n = static_cast<float>(i);
        *state = {.enabled = true, .mode = mode, .objectPlane = {n, 0, 0, 1}, .eyePlane = {0, 0, n, 1}};
    }
    return unit;
}

struct Case {
    const char* name;
    TexGenMode mode;
    glm::vec4 expected;
};
class TexGenRule : public testing::TestWithParam<Case> {};
TEST_P(TexGenRule, GivesTheNumberOfTheFormula) {
    EXPECT_TRUE(isNear(generateCoordinates(generating(GetParam().mode), given, inputs), GetParam().expected));
}
INSTANTIATE_TEST_SUITE_P(
    All, TexGenRule,
    testing::Values(Case{"Object", TexGenMode::ObjectLinear, {2, 3, 4, 5}},
                    Case{"Eye", TexGenMode::EyeLinear, {-1, -3, -5, -7}},
                    // What has no such mode stays at GL_EYE_LINEAR: -5 for r, -7 for q.
                    Case{"Normal", TexGenMode::NormalMap, {0, 0.70710678F, 0.70710678F, -7}},
                    Case{"Reflection", TexGenMode::ReflectionMap, {0, 1, 0, -7}},
                    // m = 2 sqrt(0 + 1 + 1)
                    Case{"Sphere", TexGenMode::SphereMap, {0.5F, 0.85355339F, -5, -7}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(TexGen, LeavesAloneWhatIsNotGenerated) {
    Unit unit = generating(TexGenMode::ObjectLinear);
    unit.texGenT.enabled = unit.texGenQ.enabled = false;
    EXPECT_TRUE(isNear(generateCoordinates(unit, given, inputs), {2, 0.2F, 4, 1}));
}

TEST(TexGen, HasAResultWhereThereIsNoDirection) {
    const Unit unit = generating(TexGenMode::SphereMap);
    EXPECT_TRUE(isNear(generateCoordinates(unit, given, {.eye = {0, 0, 0, 1}, .normal = {0, 0, 1}}),
                       {0.5F, 0.5F, 1, 1}));
    // Reflected straight away from the viewer: m = 0.
    EXPECT_TRUE(isNear(generateCoordinates(unit, given, {.eye = {0, 0, -1, 1}, .normal = {1, 0, 0}}),
                       {0.5F, 0.5F, -2, -3}));
}

} // namespace
} // namespace texplorer::reference::tex_gen_test
