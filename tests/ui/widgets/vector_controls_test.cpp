#include "tests/ui/drawn_texts.h"
#include "tests/ui/workbench.h"

namespace texplorer::ui::vector_controls_test {
namespace {

using namespace test;

class VectorControls : public Workbench {};

TEST_F(VectorControls, HaveLettersBesideTheirColoursWhereTheNumberLeavesRoom) {
    click("parameters:Light");
    for (const char* letter : {"letter:x", "letter:y", "letter:z"})
        EXPECT_TRUE(has(letter)) << letter;
    EXPECT_FALSE(has("letter:s"));
    start(defaultScene(), 1024, 700);
    scene().light.position = {-999.99F, -999.99F, -999.99F, 1};
    scene().light.projector.target = {-999.99F, -999.99F, -999.99F};
    click("parameters:Light");
    EXPECT_FALSE(has("letter:y"));
}

TEST_F(VectorControls, NameTheCoordinateThatARowOfAMatrixMakes) {
    unit().matrix = {{.op = MatrixOp::Multiply}};
    open("Texture matrix");
    for (const char* letter : {"letter:s", "letter:t", "letter:r", "letter:q"})
        EXPECT_TRUE(has(letter)) << letter;
}

TEST_F(VectorControls, HaveTheirUnitNextToTheLabel) {
    unit().matrix = {{.op = MatrixOp::Rotate}};
    open("Texture matrix");
    scrollTo("passes[0].units[0].matrix[0].rate[1]");
    EXPECT_TRUE(has("passes[0].units[0].matrix[0].rate#unit"));
    EXPECT_FALSE(has("passes[0].units[0].matrix[0].amount#unit")) << "it has none";
    EXPECT_FALSE(has("passes[0].units[0].matrix[0].angleRate#unit")) << "it is in the field";
}

TEST_F(VectorControls, OfAMatrixStepAreNamedForWhatTheyAre) {
    unit().matrix = {{.op = MatrixOp::Rotate, .amount = {0, 0, 1}}};
    open("Texture matrix");
    EXPECT_THAT(drawnTexts(), testing::Contains("Axis"));
    unit().matrix = {{.op = MatrixOp::Translate}};
    frames(2);
    EXPECT_THAT(drawnTexts(), testing::Contains("Offset"));
    unit().matrix = {{.op = MatrixOp::Scale, .amount = {1, 2, 1}}};
    frames(2);
    EXPECT_THAT(drawnTexts(), testing::Contains("Factors"));
    EXPECT_THAT(drawnTexts(), testing::Not(testing::Contains("Amount")));
}

TEST_F(VectorControls, HaveTheirUnitInTheLanguageOfTheWindow) {
    unit().matrix = {{.op = MatrixOp::Rotate, .angleRate = 30}};
    speak(Language::Russian);
    open("Texture matrix");
    scrollTo("passes[0].units[0].matrix[0].angleRate");
    EXPECT_THAT(drawnTexts(), testing::Contains(testing::HasSubstr(" /с")));
    EXPECT_THAT(drawnTexts(), testing::Contains("30.0°/с"));
}

} // namespace
} // namespace texplorer::ui::vector_controls_test
