#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/params/value_mix.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

namespace texplorer::value_mix_test {
namespace {

constexpr float largest = std::numeric_limits<float>::max();

const ParamRow& row(const StructTable& table, std::string_view key) {
    return *findParam(table, key);
}

TEST(Mixed, GoesComponentByComponent) {
    const ParamRow& color = row(viewTable(), "background");
    EXPECT_EQ(mixed(color, glm::vec4(0, 1, 0.5F, 1), glm::vec4(1, 0, 0.5F, 0), 0.25),
              Value(glm::vec4(0.25F, 0.75F, 0.5F, 0.75F)));
    const ParamRow& target = row(viewTable(), "target");
    EXPECT_EQ(mixed(target, glm::vec3(0, 10, -4), glm::vec3(1, 20, 4), 0.5), Value(glm::vec3(0.5F, 15, 0)));
    const ParamRow& matrix = row(matrixStepTable(), "matrix");
    EXPECT_EQ(mixed(matrix, glm::mat4(1), glm::mat4(3), 0.5), Value(glm::mat4(2)));
    const ParamRow& coords = row(modelTable(), "texCoords0");
    EXPECT_EQ(
        mixed(coords, TexCoords{{0, 0, 0, 1}, {1, 1, 0, 1}}, TexCoords{{1, 0, 0, 1}, {1, 3, 0, 1}}, 0.5),
        Value(TexCoords{{0.5F, 0, 0, 1}, {1, 2, 0, 1}}));
}

TEST(Mixed, RoundsWholeNumbers) {
    const ParamRow& slices = row(modelTable(), "slices");
    EXPECT_EQ(mixed(slices, 10, 20, 0.5), Value(15));
    EXPECT_EQ(mixed(slices, 10, 13, 0.5), Value(12)) << "11.5";
    EXPECT_EQ(mixed(slices, 10, 20, 0.94), Value(19));
}

TEST(Mixed, IsTheValueItselfAtBothEnds) {
    const ParamRow& angle = row(viewTable(), "azimuth");
    for (const float number : {0.1F, -0.0F, 1e-40F, 123.456F, -360.0F}) {
        const auto at = [&](double share) { return std::get<float>(mixed(angle, number, 0.3F, share)); };
        EXPECT_EQ(std::bit_cast<std::uint32_t>(at(0)), std::bit_cast<std::uint32_t>(number));
        EXPECT_EQ(at(1), 0.3F);
        EXPECT_EQ(std::get<float>(mixed(angle, number, number, 0.37)), number) << "nowhere else";
    }
}

TEST(Mixed, StaysBetweenItsEndsHoweverFarTheyAre) {
    const ParamRow& coords = row(modelTable(), "texCoords0");
    for (const double share : {1e-9, 0.3, 0.5, 0.999999}) {
        const Value value =
            mixed(coords, TexCoords{glm::vec4(-largest)}, TexCoords{glm::vec4(largest)}, share);
        const float s = std::get<SharedList<glm::vec4>>(value).front().s;
        EXPECT_TRUE(s >= -largest && s <= largest) << s;
    }
}

TEST(Mixed, StaysWhatItWasWhereNothingLiesBetween) {
    EXPECT_EQ(mixed(row(textureTable(), "wrapS"), EnumValue{0x2901}, EnumValue{0x812F}, 0.99),
              Value(EnumValue{0x2901}));
    EXPECT_EQ(mixed(row(passTable(), "blend"), false, true, 0.99), Value(false));
    EXPECT_EQ(mixed(row(passTable(), "blend"), false, true, 1), Value(true));
    EXPECT_EQ(mixed(row(unitTable(), "texture"), 0, 4, 0.5), Value(0)) << "not texture 2";
    EXPECT_EQ(mixed(row(passTable(), "models"), std::vector{0}, std::vector{2}, 0.5), Value(std::vector{0}));
    EXPECT_EQ(mixed(row(textureTable(), "file"), std::string("a"), std::string("b"), 0.5),
              Value(std::string("a")));
    const TexCoords one(1);
    EXPECT_EQ(mixed(row(modelTable(), "texCoords0"), one, TexCoords(2), 0.5), Value(one));
}

} // namespace
} // namespace texplorer::value_mix_test
