// Matrices against products that were worked out by hand.

#include "texplorer/scene/animation.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace texplorer::animation_test {
namespace {

/// Rows from top to bottom, as one writes a matrix on paper; glm stores columns.
struct OnPaper {
    float rows[4][4];
};

void expectMatrix(const glm::mat4& matrix, const OnPaper& paper) {
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c)
            EXPECT_FLOAT_EQ(matrix[c][r], paper.rows[r][c]) << "row " << r << ", column " << c;
}

MatrixStep translate(glm::vec3 amount, glm::vec3 rate = {}) {
    return {MatrixOp::Translate, amount, rate, 0, 0};
}
MatrixStep scale(glm::vec3 amount, glm::vec3 rate = {}) {
    return {MatrixOp::Scale, amount, rate, 0, 0};
}
MatrixStep rotate(glm::vec3 axis, float angle, float angleRate = 0) {
    return {MatrixOp::Rotate, axis, {}, angle, angleRate};
}

/// 1 to 16, as glMultMatrixf takes them.
MatrixStep numbers(MatrixOp op) {
    return {.op = op, .matrix = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16}};
}

struct MatrixCase {
    const char* name;
    std::vector<MatrixStep> steps;
    double time;
    OnPaper expected;
};

class TextureMatrix : public testing::TestWithParam<MatrixCase> {};

TEST_P(TextureMatrix, IsTheProductOnPaper) {
    expectMatrix(textureMatrix(GetParam().steps, GetParam().time, Light{}), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    Steps, TextureMatrix,
    testing::Values(
        MatrixCase{"None", {}, 7, {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}},
        MatrixCase{"Translate",
                   {translate({0.25F, -0.5F, 2})},
                   0,
                   {{{1, 0, 0, 0.25F}, {0, 1, 0, -0.5F}, {0, 0, 1, 2}, {0, 0, 0, 1}}}},
        MatrixCase{"TranslateAtTwoSeconds",
                   {translate({0.25F, 0, 0}, {0.5F, -1, 0})},
                   2,
                   {{{1, 0, 0, 1.25F}, {0, 1, 0, -2}, {0, 0, 1, 0}, {0, 0, 0, 1}}}},
        MatrixCase{"ScaleAtThreeSeconds",
                   {scale({2, 1, 1}, {1, 0, 0})},
                   3,
                   {{{5, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}},
        MatrixCase{"QuarterTurn",
                   {rotate({0, 0, 1}, 90)},
                   0,
                   {{{0, -1, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}},
        MatrixCase{"AxisNeedsNoUnitLength",
                   {rotate({0, 0, 5}, 0, 30)},
                   3,
                   {{{0, -1, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}},
        // sin 30 = 1/2, cos 30 = sqrt(3)/2
        MatrixCase{"ThirtyDegreesAboutX",
                   {rotate({1, 0, 0}, 30)},
                   0,
                   {{{1, 0, 0, 0}, {0, 0.8660254F, -0.5F, 0}, {0, 0.5F, 0.8660254F, 0}, {0, 0, 0, 1}}}},
        MatrixCase{"OnlyAngleOfRotateCounts",
                   {{MatrixOp::Translate, {1, 0, 0}, {}, 90, 90}},
                   1,
                   {{{1, 0, 0, 1}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}},
        MatrixCase{"NoAxisNoTurn",
                   {rotate({0, 0, 0}, 90)},
                   0,
                   {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}},
        // T S: a coordinate is scaled first, then moved. S T would move by 2.
        MatrixCase{"TranslateThenScale",
                   {translate({1, 0, 0}), scale({2, 2, 1})},
                   0,
                   {{{2, 0, 0, 1}, {0, 2, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}},
        MatrixCase{"ScaleThenTranslate",
                   {scale({2, 2, 1}), translate({1, 0, 0})},
                   0,
                   {{{2, 0, 0, 2}, {0, 2, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}},
        // About the middle of the image: (s, t) -> (1 - t, s).
        MatrixCase{"TurnAboutTheMiddle",
                   {translate({0.5F, 0.5F, 0}), rotate({0, 0, 1}, 90), translate({-0.5F, -0.5F, 0})},
                   0,
                   {{{0, -1, 0, 1}, {1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}},
        // The same by a pivot.
        MatrixCase{"TurnAboutAPivot",
                   {{.op = MatrixOp::Rotate, .amount = {0, 0, 1}, .angle = 90, .pivot = {0.5F, 0.5F, 0}}},
                   0,
                   {{{0, -1, 0, 1}, {1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}},
        // x -> 2 (x - 0.5) + 0.5, y -> 3 (y + 1) - 1, z -> 4 (z - 2) + 2
        MatrixCase{"ScaleAboutAPivot",
                   {{.op = MatrixOp::Scale, .amount = {2, 3, 4}, .pivot = {0.5F, -1, 2}}},
                   0,
                   {{{2, 0, 0, -0.5F}, {0, 3, 0, 2}, {0, 0, 4, -6}, {0, 0, 0, 1}}}},
        MatrixCase{"TranslateHasNoPivot",
                   {{.op = MatrixOp::Translate, .amount = {1, 0, 0}, .pivot = {5, 6, 7}}},
                   0,
                   {{{1, 0, 0, 1}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}},
        // Four numbers are a column.
        MatrixCase{"Multiply",
                   {numbers(MatrixOp::Multiply)},
                   0,
                   {{{1, 5, 9, 13}, {2, 6, 10, 14}, {3, 7, 11, 15}, {4, 8, 12, 16}}}},
        // Each row and so many of the last one.
        MatrixCase{"TranslateThenMultiply",
                   {translate({1, 2, 3}), numbers(MatrixOp::Multiply)},
                   0,
                   {{{5, 13, 21, 29}, {10, 22, 34, 46}, {15, 31, 47, 63}, {4, 8, 12, 16}}}},
        MatrixCase{"Load",
                   {translate({1, 2, 3}), scale({7, 8, 9}), numbers(MatrixOp::Load)},
                   0,
                   {{{1, 5, 9, 13}, {2, 6, 10, 14}, {3, 7, 11, 15}, {4, 8, 12, 16}}}},
        // The last column and the first one.
        MatrixCase{"LoadThenTranslate",
                   {scale({7, 8, 9}), numbers(MatrixOp::Load), translate({1, 0, 0})},
                   0,
                   {{{1, 5, 9, 14}, {2, 6, 10, 16}, {3, 7, 11, 18}, {4, 8, 12, 20}}}},
        MatrixCase{
            "NumbersDoNotMove",
            {{.op = MatrixOp::Load, .amount = {1, 2, 3}, .rate = {4, 5, 6}, .angle = 7, .angleRate = 8}},
            9,
            {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}},
        // 10 000 000 turns and a quarter: an angle in float would be off by degrees.
        MatrixCase{"LongTime",
                   {rotate({0, 0, 1}, 0, 360)},
                   10000000.25,
                   {{{0, -1, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(ModelMatrix, ScalesThenTurnsAboutXThenYThenZThenMoves) {
    Model model;
    model.size = 2;
    model.rotation = {90, 90, 0};
    model.position = {5, 6, 7};
    // Rx 90: (x, y, z) -> (x, -z, y). Ry 90: (x, y, z) -> (z, y, -x). Together (x, y, z) -> (y, -z, -x).
    expectMatrix(modelMatrix(model, 0), {{{0, 2, 0, 5}, {0, 0, -2, 6}, {-2, 0, 0, 7}, {0, 0, 0, 1}}});
}

struct OrderCase {
    RotationOrder order;
    OnPaper expected;
};
class RotationOrders : public testing::TestWithParam<OrderCase> {};

// Quarter turns: about x (x, y, z) -> (x, -z, y), about y (z, y, -x), about z (-y, x, z).
TEST_P(RotationOrders, AreProductsOnPaper) {
    Model model;
    model.rotation = {90, 90, 90};
    model.rotationOrder = GetParam().order;
    expectMatrix(modelMatrix(model, 0), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    All, RotationOrders,
    testing::Values(
        // x first: (x, -z, y), then y: (y, -z, -x), then z
        OrderCase{RotationOrder::Zyx, {{{0, 0, 1, 0}, {0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 0, 1}}}},
        // y first: (z, y, -x), then x: (z, x, y), then z
        OrderCase{RotationOrder::Zxy, {{{-1, 0, 0, 0}, {0, 0, 1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1}}}},
        // x first: (x, -z, y), then z: (z, x, y), then y
        OrderCase{RotationOrder::Yzx, {{{0, 1, 0, 0}, {1, 0, 0, 0}, {0, 0, -1, 0}, {0, 0, 0, 1}}}},
        // z first: (-y, x, z), then x: (-y, -z, x), then y
        OrderCase{RotationOrder::Yxz, {{{1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1}}}},
        // y first: (z, y, -x), then z: (-y, z, -x), then x
        OrderCase{RotationOrder::Xzy, {{{0, -1, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}},
        // z first: (-y, x, z), then y: (z, x, y), then x
        OrderCase{RotationOrder::Xyz, {{{0, 0, 1, 0}, {0, -1, 0, 0}, {1, 0, 0, 0}, {0, 0, 0, 1}}}}),
    [](const auto& test) { return std::string(rowOf(test.param.order).name); });

TEST(OrdersOfRotation, HaveAProductEach) {
    // One that two orders share would tell nothing.
    std::set<std::array<int, 3>> images;
    Model model;
    model.rotation = {90, 90, 90};
    for (const EnumRow& row : rotationOrderRows) {
        model.rotationOrder = static_cast<RotationOrder>(row.value);
        const glm::vec4 image = modelMatrix(model, 0) * glm::vec4(1, 2, 3, 1);
        images.insert({static_cast<int>(image.x), static_cast<int>(image.y), static_cast<int>(image.z)});
    }
    EXPECT_EQ(images.size(), rotationOrderRows.size());
}

// Before it turns: what was its x axis is twice as long, and points along y.
TEST(ModelMatrix, ScalesEachAxisOfTheModel) {
    Model model;
    model.size = 0.5F;
    model.scale = {2, 3, 4};
    model.rotation = {0, 0, 90};
    model.position = {5, 6, 7};
    expectMatrix(modelMatrix(model, 0), {{{0, -1.5F, 0, 5}, {1, 0, 0, 6}, {0, 0, 2, 7}, {0, 0, 0, 1}}});
}

TEST(ModelViewMatrix, OfAModelBeforeTheEyeIsItsOwn) {
    View view;
    view.distance = 6;
    view.azimuth = 90; // from (6, 0, 0): (x, y, z) -> (-z, y, x - 6)
    Model model;
    model.position = {1, 2, 3};
    model.spin = {0, 0, 30};
    expectMatrix(modelViewMatrix(view, model, 3),
                 {{{0, 0, -1, -3}, {1, 0, 0, 2}, {0, -1, 0, -5}, {0, 0, 0, 1}}});
    model.attachment = Attachment::Eye;
    expectMatrix(modelViewMatrix(view, model, 3),
                 {{{0, -1, 0, 1}, {1, 0, 0, 2}, {0, 0, 1, 3}, {0, 0, 0, 1}}});
}

TEST(ModelMatrix, SpinGrowsWithTime) {
    Model model;
    model.rotation = {0, 0, 30};
    model.spin = {0, 0, 20};
    // 30 + 3 * 20 = 90 degrees about z
    expectMatrix(modelMatrix(model, 3), {{{0, -1, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}});
}

TEST(ViewMatrix, LooksAlongMinusZFromItsDistance) {
    View view;
    view.distance = 6;
    view.target = {1, 2, 3};
    expectMatrix(viewMatrix(view), {{{1, 0, 0, -1}, {0, 1, 0, -2}, {0, 0, 1, -9}, {0, 0, 0, 1}}});
}

// The camera turns clockwise, so that the world turns the other way: what was above is to the left.
TEST(ViewMatrix, RollsAboutTheLineOfSight) {
    View view;
    view.distance = 6;
    view.roll = 90;
    expectMatrix(viewMatrix(view), {{{0, -1, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, -6}, {0, 0, 0, 1}}});
    // After it has gone up: (x, y, z) -> (x, -z, y), and then (z, x, y)
    view.elevation = 90;
    expectMatrix(viewMatrix(view), {{{0, 0, 1, 0}, {1, 0, 0, 0}, {0, 1, 0, -6}, {0, 0, 0, 1}}});
}

struct Orbit {
    const char* name;
    float azimuth;
    float elevation;
    glm::vec3 eye; ///< where the camera stands, 2 away from the origin
};

class Orbits : public testing::TestWithParam<Orbit> {};

TEST_P(Orbits, PutTheCameraThereWithTheTargetInFront) {
    View view;
    view.distance = 2;
    view.azimuth = GetParam().azimuth;
    view.elevation = GetParam().elevation;
    const glm::mat4 matrix = viewMatrix(view);
    const glm::vec4 eye = matrix * glm::vec4(GetParam().eye, 1);
    const glm::vec4 target = matrix * glm::vec4(0, 0, 0, 1);
    const glm::vec4 up = matrix * glm::vec4(0, 1, 0, 0);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(eye[i], 0, 1e-6F);
        EXPECT_NEAR(target[i], i == 2 ? -2 : 0, 1e-6F);
    }
    EXPECT_NEAR(up.x, 0, 1e-6F) << "the horizon must stay level";
    EXPECT_GE(up.y, 0);
}

INSTANTIATE_TEST_SUITE_P(Camera, Orbits,
                         testing::Values(Orbit{"Front", 0, 0, {0, 0, 2}}, Orbit{"Right", 90, 0, {2, 0, 0}},
                                         Orbit{"Back", 180, 0, {0, 0, -2}}, Orbit{"Left", -90, 0, {-2, 0, 0}},
                                         Orbit{"Above", 0, 30, {0, 1, 1.7320508F}},
                                         Orbit{"BelowRight", 90, -30, {1.7320508F, -1, 0}}),
                         [](const auto& test) { return std::string(test.param.name); });

glm::vec3 project(const View& view, float aspect, glm::vec3 eyePoint) {
    const glm::vec4 clip = projectionMatrix(view, aspect) * glm::vec4(eyePoint, 1);
    return glm::vec3(clip) / clip.w;
}

TEST(ProjectionMatrix, BothProjectionsShowTheSameHeightAtTheTarget) {
    View view;
    view.fieldOfView = 90; // half the height is as long as the distance
    view.distance = 3;
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
        view.projection = projection;
        const glm::vec3 corner = project(view, 2, {6, 3, -3});
        EXPECT_NEAR(corner.x, 1, 1e-6F);
        EXPECT_NEAR(corner.y, 1, 1e-6F);
        EXPECT_LT(std::abs(corner.z), 1);
    }
}

TEST(ProjectionMatrix, FarThingsShrinkInPerspectiveAlone) {
    View view;
    view.fieldOfView = 90;
    view.distance = 3;
    EXPECT_NEAR(project(view, 1, {3, 0, -6}).x, 0.5F, 1e-6F);
    view.projection = Projection::Orthographic;
    EXPECT_NEAR(project(view, 1, {3, 0, -6}).x, 1, 1e-6F);
}

TEST(IsAnimated, CountsWhatOneSees) {
    Scene scene = defaultScene();
    EXPECT_FALSE(isAnimated(scene));

    Scene spinning = scene;
    spinning.models[1].spin.y = 10;
    EXPECT_TRUE(isAnimated(spinning));
    spinning.models[1].visible = false;
    EXPECT_FALSE(isAnimated(spinning));

    Scene moving = scene;
    moving.passes[0].units[0].matrix = {rotate({0, 0, 1}, 0, 10)};
    EXPECT_TRUE(isAnimated(moving));
    moving.passes[0].units[0].matrix[0].op = MatrixOp::Translate; // which has no angle
    EXPECT_FALSE(isAnimated(moving));
    moving.passes[0].units[0].matrix[0].rate = {0.1F, 0, 0};
    EXPECT_TRUE(isAnimated(moving));
    for (const MatrixOp op : {MatrixOp::Multiply, MatrixOp::Load}) {
        moving.passes[0].units[0].matrix[0].op = op; // which have no rate
        EXPECT_FALSE(isAnimated(moving));
    }
    moving.passes[0].units[0].matrix[0].op = MatrixOp::Scale;
    EXPECT_TRUE(isAnimated(moving));
    moving.passes[0].units[0].enabled = false;
    EXPECT_FALSE(isAnimated(moving));
}

TEST(IsAnimated, CountsTheModelsThatAPassNames) {
    Scene scene = defaultScene();
    scene.models[1].spin.y = 10;
    scene.passes[0].models = {0};
    EXPECT_FALSE(isAnimated(scene));
    scene.passes[0].models = {0, 1};
    EXPECT_TRUE(isAnimated(scene));
    scene.passes[0].enabled = false;
    EXPECT_FALSE(isAnimated(scene));

    scene.passes[0].enabled = true;
    scene.passes[0].models = {0};
    scene.passes[0].units[0].matrix = {rotate({0, 0, 1}, 0, 10)};
    EXPECT_TRUE(isAnimated(scene));
    scene.models[0].visible = false; // so that nothing shows the texture
    EXPECT_FALSE(isAnimated(scene));
}

} // namespace
} // namespace texplorer::animation_test
