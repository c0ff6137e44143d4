#include "app/lettering/font_lettering.h"
#include "app/ui/files/sheet_file.h"
#include "app/ui/services/sheet_pictures.h"
#include "tests/support/temp_dir.h"
#include "texplorer/codec/png/png.h"
#include "texplorer/codec/png/png_text.h"
#include "texplorer/files/file_io.h"
#include "texplorer/image/convert.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/storage/scene_file.h"

#include <gmock/gmock.h>

#include <stop_token>

namespace texplorer::ui::sheet_file_test {
namespace {

using testing::HasSubstr;

SheetOrder order() {
    SheetOrder asked;
    asked.picture = {defaultScene(), {}, 0, 48, 36};
    asked.rows = {"textures[0].magFilter", {"GL_NEAREST", "GL_LINEAR"}};
    asked.columns = {"passes[0].units[0].envMode", {"GL_REPLACE", "GL_MODULATE", "GL_ADD"}};
    asked.content.title = "Some scene";
    asked.content.cell = {48, 36};
    asked.content.down = {"Mag filter", asked.rows.values};
    asked.content.across = sheet::AxisLabels{"Mode", asked.columns.values};
    return asked;
}

Image readSheet(const std::filesystem::path& file) {
    const Result<TextureImage> read = decodePng(readFile(file).value());
    return std::get<Image>(read.value().surface(0, 0));
}

/// What lies in a place that is counted from the upper left.
Image cutOut(const Image& sheet, const PixelRect& rect) {
    Image cut = Image::uninitialised(PixelFormat::Rgb8, rect.width, rect.height);
    for (int y = 0; y < rect.height; ++y) {
        for (int x = 0; x < rect.width; ++x)
            std::ranges::copy(sheet.at(rect.x + x, sheet.height - rect.y - rect.height + y),
                              cut.at(x, y).begin());
    }
    return cut;
}

TEST(SheetFile, HaveTheReferencesPicturesWhereTheLayoutPutsThem) {
    const test::TempDir folder;
    FileWriting writing(When::AtOnce);
    const SheetOrder asked = order();
    const std::filesystem::path file = folder / "sheet.png";
    writing.write(fileOrder(asked, file).value());
    const std::optional<FileNews> news = writing.takeNews();
    ASSERT_TRUE(news);
    EXPECT_EQ(news->text, "Written: " + file.string());
    EXPECT_TRUE(news->isGood);
    EXPECT_FALSE(writing.takeNews());

    const sheet::Layout layout = sheet::layoutOf(asked.content, **openLettering()).value();
    const Image sheet = readSheet(file);
    EXPECT_EQ(glm::ivec2(sheet.width, sheet.height), layout.size);
    ASSERT_EQ(layout.cells.size(), 6U);
    for (std::size_t cell = 0; cell < 6; ++cell) {
        Scene scene = defaultScene();
        scene.textures[0].magFilter = cell < 3 ? MagFilter::Nearest : MagFilter::Linear;
        scene.passes[0].units[0].envMode =
            std::array{EnvMode::Replace, EnvMode::Modulate, EnvMode::Add}[cell % 3];
        const Image drawn = reference::drawReference({scene, {}, 0, 48, 36}).value().image;
        EXPECT_EQ(cutOut(sheet, layout.cells[cell]), withoutAlpha(drawn)) << cell;
    }
}

TEST(SheetFile, SayHowTheyWereDrawn) {
    const test::TempDir folder;
    FileWriting writing(When::AtOnce);
    writing.write(fileOrder(order(), folder / "sheet.png").value());
    const Bytes bytes = readFile(folder / "sheet.png").value();
    const auto text = [&](std::string_view keyword) {
        return findPngText(bytes, keyword, 1 << 20).value().value_or("");
    };
    EXPECT_EQ(text("Texplorer renderer"), "reference");
    EXPECT_EQ(text("Texplorer size"), "48x36");
    EXPECT_EQ(text("Texplorer axes"), "textures[0].magFilter=GL_NEAREST,GL_LINEAR\n"
                                      "passes[0].units[0].envMode=GL_REPLACE,GL_MODULATE,GL_ADD");
    EXPECT_EQ(parseScene(text(sceneKeyword)).value(), defaultScene());
}

TEST(SheetFile, WhatCantBeDrawnSaysWhyInItsPlace) {
    const test::TempDir folder;
    FileWriting writing(When::AtOnce);
    SheetOrder asked = order();
    asked.columns = {"passes[0].units[0].texture", {"0", "-1"}}; // the unit is enabled
    asked.content.across = sheet::AxisLabels{"Texture", asked.columns.values};
    writing.write(fileOrder(asked, folder / "sheet.png").value());
    EXPECT_THAT(writing.takeNews()->text,
                testing::EndsWith(". 2 of 4 pictures can't be drawn. Each shows the reason."));
    EXPECT_TRUE(std::filesystem::exists(folder / "sheet.png"));
    asked.columns.values = {"-1"};
    asked.content.across->values = asked.columns.values;
    writing.write(fileOrder(asked, folder / "none.png").value());
    EXPECT_THAT(
        writing.takeNews()->text,
        HasSubstr(
            "The sheet can't be written: none of its pictures can be drawn: passes[0].units[0].texture: "));
    EXPECT_FALSE(std::filesystem::exists(folder / "none.png"));
}

TEST(SheetFile, WhatIsTooLargeIsRefusedBeforeAnyWork) {
    SheetOrder asked = order();
    asked.content.cell = {9000, 9000};
    const Result<FileOrder> refused = fileOrder(asked, "sheet.png");
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message, HasSubstr("expected a sheet of at most 16384 × 16384 pixels"));
}

TEST(SheetFile, IsCountedInPicturesAndEndsWithTheNextOne) {
    const FileOrder asked = fileOrder(order(), "sheet.png").value();
    EXPECT_EQ(asked.pictures, 6U);
    std::stop_source stop;
    std::vector<float> shares;
    const Result<MadeFile> made =
        asked.make({.levels = {.stop = stop.get_token()}, .report = [&](float share) {
                        shares.push_back(share);
                        if (shares.size() == 4)
                            stop.request_stop();
                    }});
    EXPECT_FALSE(made);
    EXPECT_THAT(shares,
                testing::ElementsAre(0, testing::FloatEq(1.0F / 6), testing::FloatEq(2.0F / 6), 0.5F));
}

} // namespace
} // namespace texplorer::ui::sheet_file_test
