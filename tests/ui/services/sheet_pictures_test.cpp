#include "app/ui/services/sheet_pictures.h"

#include <gmock/gmock.h>

namespace texplorer::ui::sheet_pictures_test {
namespace {

SheetPictures::Question question(double time = 0) {
    SheetPictures::Question asked;
    asked.picture = {defaultScene(), {}, time, 48, 36};
    asked.rows = {"textures[0].magFilter", {"GL_NEAREST", "GL_LINEAR"}};
    asked.columns = {"passes[0].units[0].envMode", {"GL_REPLACE", "GL_MODULATE", "GL_ADD"}};
    return asked;
}

SheetPictures::Cells cellsOf(SheetPictures& pictures, const SheetPictures::Question& asked) {
    (void)pictures.ask(asked);
    return pictures.cells(asked.rows, asked.columns);
}

/// The scene with the cell's values, set by hand.
Image drawn(MagFilter filter, EnvMode mode) {
    Scene scene = defaultScene();
    scene.textures[0].magFilter = filter;
    scene.passes[0].units[0].envMode = mode;
    return reference::drawReference({scene, {}, 0, 48, 36}).value().image;
}

TEST(SheetPictures, AreThoseOfEveryPairRowByRow) {
    SheetPictures pictures(When::AtOnce);
    const SheetPictures::Cells cells = cellsOf(pictures, question());
    ASSERT_EQ(cells.size(), 6U);
    EXPECT_EQ(*cells[0].image, drawn(MagFilter::Nearest, EnvMode::Replace));
    EXPECT_EQ(*cells[2].image, drawn(MagFilter::Nearest, EnvMode::Add));
    EXPECT_EQ(*cells[3].image, drawn(MagFilter::Linear, EnvMode::Replace));
    EXPECT_EQ(*cells[5].image, drawn(MagFilter::Linear, EnvMode::Add));
}

TEST(SheetPictures, AreDrawnAgainWhenTheSceneChanges) {
    SheetPictures pictures(When::AtOnce);
    SheetPictures::Question asked = question();
    const std::shared_ptr<const Image> before = cellsOf(pictures, asked).front().image;
    EXPECT_EQ(cellsOf(pictures, asked).front().image, before) << "not where nothing has changed";
    asked.picture.scene.view.azimuth += 30;
    EXPECT_NE(*cellsOf(pictures, asked).front().image, *before);
}

TEST(SheetPictures, SayWhichValueTheSceneRefuses) {
    SheetPictures pictures(When::AtOnce);
    SheetPictures::Question asked = question();
    asked.columns = {"passes[0].units[0].texture", {"0", "-1"}}; // the unit is enabled
    const SheetPictures::Cells cells = cellsOf(pictures, asked);
    EXPECT_TRUE(cells[0].image);
    EXPECT_EQ(cells[0].problem, "");
    EXPECT_FALSE(cells[1].image);
    EXPECT_THAT(cells[1].problem, testing::StartsWith("passes[0].units[0].texture: "));
}

TEST(SheetPictures, ComeOneByOneAndFollowTheNewestQuestion) {
    SheetPictures pictures(When::WhenReady);
    for (int i = 0; i < 40; ++i)
        (void)pictures.ask(question(i));
    pictures.wait();
    const SheetPictures::Cells cells = cellsOf(pictures, question(39));
    ASSERT_EQ(cells.size(), 6U);
    for (const SheetPictures::Cell& cell : cells) {
        EXPECT_TRUE(cell.image);
        EXPECT_EQ(cell.question, 40U) << "none is left behind";
    }
}

TEST(SheetPictures, OfOtherValuesAreForgotten) {
    SheetPictures pictures(When::WhenReady);
    (void)pictures.ask(question());
    pictures.wait();
    SheetPictures::Question other = question();
    std::swap(other.rows, other.columns);
    EXPECT_EQ(cellsOf(pictures, other).size(), 6U);
    pictures.wait();
    EXPECT_EQ(*cellsOf(pictures, other)[1].image, drawn(MagFilter::Linear, EnvMode::Replace));
    pictures.rest();
    EXPECT_FALSE(pictures.cells(other.rows, other.columns)[1].image);
}

} // namespace
} // namespace texplorer::ui::sheet_pictures_test
