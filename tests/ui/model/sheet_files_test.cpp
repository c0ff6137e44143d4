#include "app/lettering/font_lettering.h"
#include "app/ui/model/sheet_files.h"
#include "app/ui/model/sheet_pictures.h"
#include "core/base/file_io.h"
#include "core/codec/png/png.h"
#include "core/codec/png/png_text.h"
#include "core/image/convert.h"
#include "core/link/scene_file.h"
#include "core/scene/params/json.h"
#include "tests/support/temp_dir.h"

#include <gmock/gmock.h>

#include <latch>
#include <span>

namespace texplorer::ui::sheet_files_test {
namespace {

using testing::HasSubstr;

SheetFiles::Order order(const std::filesystem::path& file) {
    SheetFiles::Order asked;
    asked.picture = {defaultScene(), {}, 0, 48, 36};
    asked.rows = {"textures[0].magFilter", {"GL_NEAREST", "GL_LINEAR"}};
    asked.columns = {"passes[0].units[0].envMode", {"GL_REPLACE", "GL_MODULATE", "GL_ADD"}};
    asked.content.title = "Some scene";
    asked.content.cell = {48, 36};
    asked.content.down = {"Mag filter", asked.rows.values};
    asked.content.across = sheet::AxisLabels{"Mode", asked.columns.values};
    asked.file = file;
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

TEST(SheetFiles, HaveTheReferencesPicturesWhereTheLayoutPutsThem) {
    const test::TempDir folder;
    SheetFiles files(When::AtOnce);
    const SheetFiles::Order asked = order(folder / "sheet.png");
    ASSERT_TRUE(files.write(asked));
    const std::optional<FileNews> news = files.takeNews();
    ASSERT_TRUE(news);
    EXPECT_EQ(news->text, "Written: " + asked.file.string());
    EXPECT_TRUE(news->isGood);
    EXPECT_FALSE(files.takeNews());

    const sheet::Layout layout = sheet::layoutOf(asked.content, **openLettering()).value();
    const Image sheet = readSheet(asked.file);
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

TEST(SheetFiles, SayHowTheyWereDrawn) {
    const test::TempDir folder;
    SheetFiles files(When::AtOnce);
    ASSERT_TRUE(files.write(order(folder / "sheet.png")));
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

TEST(SheetFiles, WhatCantBeDrawnSaysWhyInItsPlace) {
    const test::TempDir folder;
    SheetFiles files(When::AtOnce);
    SheetFiles::Order asked = order(folder / "sheet.png");
    asked.columns = {"passes[0].units[0].texture", {"0", "-1"}}; // the unit is enabled
    asked.content.across = sheet::AxisLabels{"Texture", asked.columns.values};
    ASSERT_TRUE(files.write(asked));
    EXPECT_THAT(files.takeNews()->text, testing::EndsWith(". 2 of 4 pictures can't be drawn, and say why."));
    EXPECT_TRUE(std::filesystem::exists(asked.file));
    asked.columns.values = {"-1"};
    asked.content.across->values = asked.columns.values;
    asked.file = folder / "none.png";
    ASSERT_TRUE(files.write(asked));
    EXPECT_THAT(files.takeNews()->text,
                HasSubstr("none of its pictures can be drawn: passes[0].units[0].texture: "));
    EXPECT_FALSE(std::filesystem::exists(asked.file));
}

TEST(SheetFiles, AnUnwritableFileIsOneSentence) {
    const test::TempDir folder;
    SheetFiles files(When::AtOnce);
    ASSERT_TRUE(files.write(order(folder / "missing" / "sheet.png")));
    const std::optional<FileNews> news = files.takeNews();
    EXPECT_THAT(news->text,
                testing::AllOf(testing::StartsWith("The sheet can't be written: "), HasSubstr("missing")));
    EXPECT_FALSE(news->isGood);
}

TEST(SheetFiles, WhatIsTooLargeIsRefusedBeforeAnyWork) {
    SheetFiles files(When::AtOnce);
    SheetFiles::Order asked = order("sheet.png");
    asked.content.cell = {9000, 9000};
    const Result<void> written = files.write(asked);
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().message, HasSubstr("expected a sheet of at most 16384 x 16384 pixels"));
    EXPECT_FALSE(files.takeNews());
}

TEST(SheetFiles, AreGivenUpWithoutATrace) {
    const test::TempDir folder;
    const std::filesystem::path file = folder / "sheet.png";
    ASSERT_TRUE(writeFileAtomically(file, std::as_bytes(std::span("before", 6))));
    std::latch begun(1);
    std::latch goOn(1);
    bool first = true; // of the thread that works alone
    SheetFiles files(When::WhenReady, [&] {
        if (std::exchange(first, false)) {
            begun.count_down();
            goOn.wait();
        }
    });
    ASSERT_TRUE(files.write(order(file)));
    begun.wait();
    const std::optional<FileProgress> progress = files.progress();
    ASSERT_TRUE(progress);
    EXPECT_EQ(progress->all, 6U);
    EXPECT_EQ(progress->file, file);
    files.cancel();
    EXPECT_FALSE(files.progress());
    goOn.count_down();
    ASSERT_TRUE(files.write(order(folder / "next.png")));
    files.wait();
    EXPECT_THAT(files.takeNews()->text, HasSubstr("next.png"));
    EXPECT_EQ(readText(file).value(), "before");
}

} // namespace
} // namespace texplorer::ui::sheet_files_test
