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

/// The scene with the cell's values, set by hand.
Image drawn(MagFilter filter, EnvMode mode) {
    Scene scene = defaultScene();
    scene.textures[0].magFilter = filter;
    scene.passes[0].units[0].envMode = mode;
    return reference::drawReference({scene, {}, 0, 48, 36}).value().image;
}

TEST(SheetPictures, AreThoseOfEveryPairRowByRow) {
    SheetPictures pictures(When::AtOnce);
    const SheetPictures::Cells& cells = pictures.cells(question());
    ASSERT_EQ(cells.size(), 6U);
    EXPECT_EQ(*cells[0].image, drawn(MagFilter::Nearest, EnvMode::Replace));
    EXPECT_EQ(*cells[2].image, drawn(MagFilter::Nearest, EnvMode::Add));
    EXPECT_EQ(*cells[3].image, drawn(MagFilter::Linear, EnvMode::Replace));
    EXPECT_EQ(*cells[5].image, drawn(MagFilter::Linear, EnvMode::Add));
    EXPECT_FALSE(pictures.isDrawing());
}

TEST(SheetPictures, AreDrawnAgainWhenTheSceneChanges) {
    SheetPictures pictures(When::AtOnce);
    SheetPictures::Question asked = question();
    const std::shared_ptr<const Image> before = pictures.cells(asked).front().image;
    EXPECT_EQ(pictures.cells(asked).front().image, before) << "not where nothing has changed";
    asked.picture.scene.view.azimuth += 30;
    EXPECT_NE(*pictures.cells(asked).front().image, *before);
}

TEST(SheetPictures, SayWhichValueTheSceneRefuses) {
    SheetPictures pictures(When::AtOnce);
    SheetPictures::Question asked = question();
    asked.columns = {"passes[0].units[0].texture", {"0", "-1"}}; // the unit is enabled
    const SheetPictures::Cells& cells = pictures.cells(asked);
    EXPECT_TRUE(cells[0].image);
    EXPECT_EQ(cells[0].problem, "");
    EXPECT_FALSE(cells[1].image);
    EXPECT_THAT(cells[1].problem, testing::StartsWith("passes[0].units[0].texture: "));
}

TEST(SheetPictures, ComeOneByOneAndFollowTheNewestQuestion) {
    SheetPictures pictures(When::WhenReady);
    for (int i = 0; i < 40; ++i)
        (void)pictures.cells(question(i));
    pictures.wait();
    const SheetPictures::Cells& cells = pictures.cells(question(39));
    ASSERT_EQ(cells.size(), 6U);
    for (const SheetPictures::Cell& cell : cells) {
        EXPECT_TRUE(cell.image);
        EXPECT_EQ(cell.question, 40U) << "none is left behind";
    }
    EXPECT_FALSE(pictures.isDrawing());
}

TEST(SheetPictures, OfOtherValuesAreForgotten) {
    SheetPictures pictures(When::WhenReady);
    (void)pictures.cells(question());
    pictures.wait();
    SheetPictures::Question other = question();
    std::swap(other.rows, other.columns);
    const SheetPictures::Cells at = pictures.cells(other);
    EXPECT_EQ(at.size(), 6U);
    pictures.wait();
    EXPECT_EQ(*pictures.cells(other)[1].image, drawn(MagFilter::Linear, EnvMode::Replace));
    pictures.rest();
    pictures.wait();
    EXPECT_FALSE(pictures.isDrawing());
}

} // namespace
} // namespace texplorer::ui::sheet_pictures_test
