#include "app/ui/model/preview.h"
#include "tests/ui/edits.h"
#include "tests/ui/figures/figure_bench.h"

namespace texplorer::ui::environment_table_test {
namespace {

using namespace test;

class EnvironmentTable : public FigureBench {
protected:
    EnvironmentTable()
        : FigureBench(Figure::Environments) {}

    [[nodiscard]] EnvironmentTableState& table() { return figures().environments; }
};

TEST_F(EnvironmentTable, HasACellForEachModeAndFormat) {
    for (const EnvMode mode : reference::tableModes)
        for (const BaseFormat format : reference::tableFormats)
            EXPECT_TRUE(has(fmt::format("cell:{},{}", rowOf(mode).name, rowOf(format).name)));
    EXPECT_TRUE(has("cell:own"));
}

TEST_F(EnvironmentTable, AClickTakesModeAndFormatInOneStep) {
    const Scene before = scene();
    const std::size_t step = steps();
    click("cell:GL_ADD,GL_LUMINANCE");
    EXPECT_EQ(unit().envMode, EnvMode::Add);
    EXPECT_EQ(texture().internalFormat, InternalFormat::Luminance);
    EXPECT_EQ(steps(), step + 1);
    take(*session, Undo{});
    EXPECT_EQ(scene(), before);
}

TEST_F(EnvironmentTable, AFormatOfFewBitsStaysInItsRow) {
    texture().internalFormat = InternalFormat::Rgba4;
    frames(2);
    click("cell:GL_REPLACE,GL_RGBA");
    EXPECT_EQ(unit().envMode, EnvMode::Replace);
    EXPECT_EQ(texture().internalFormat, InternalFormat::Rgba4);
}

TEST_F(EnvironmentTable, OfBlocksItTakesTheModeAlone) {
    texture().compression = Compression::Cached; // DXT1, whose base format is that of its blocks
    frames(3);
    const InternalFormat before = texture().internalFormat;
    click("cell:GL_REPLACE,GL_LUMINANCE");
    EXPECT_EQ(unit().envMode, EnvMode::Replace);
    EXPECT_EQ(texture().internalFormat, before);
}

TEST_F(EnvironmentTable, TheViewShowsTheCellUnderThePointer) {
    const std::size_t step = steps();
    moveTo(place("cell:GL_REPLACE,GL_RGB"));
    frames(2);
    EXPECT_EQ(shownScene(*session).passes[0].units[0].envMode, EnvMode::Replace);
    EXPECT_EQ(shownScene(*session).textures[0].internalFormat, InternalFormat::Rgb);
    EXPECT_NE(unit().envMode, EnvMode::Replace);
    moveTo(place("view"));
    frames(2);
    EXPECT_FALSE(session->look.preview);
    EXPECT_EQ(steps(), step);
}

TEST_F(EnvironmentTable, ColoursCanBeSetAndGivenBack) {
    EXPECT_FALSE(has("table:reset"));
    const Scene before = scene();
    const auto& editor = places.items.at("table color:Ct");
    drag({editor.left + 8, (editor.top + editor.bottom) / 2}, {-40, 0}); // its red
    frames(2);
    ASSERT_TRUE(table().texel);
    EXPECT_FALSE(table().fragment);
    EXPECT_EQ(scene(), before) << "they are of the table alone";
    click("table:reset");
    frames(2);
    EXPECT_FALSE(table().texel);
    EXPECT_FALSE(has("table:reset"));
}

TEST_F(EnvironmentTable, SaysInNumbersOrInSymbols) {
    ASSERT_TRUE(has("table text:In numbers"));
    click("table text:In numbers");
    EXPECT_EQ(table().shows, CellText::Numbers);
    click("table picture:Gradient");
    EXPECT_TRUE(table().gradient);
    toggleMaximised(session->settings.workspace, Maximised::Below);
    frames(3);
    EXPECT_FALSE(has("table text:In numbers")) << "there is room for both";
}

TEST_F(EnvironmentTable, ShowsPicturesAloneWhereCellsAreNarrow) {
    EXPECT_FALSE(has("table text:Pictures")) << "they are next to the text";
    session->settings.workspace.textureSpace = false;
    moveTab(session->settings.workspace, Tab::Figures, Dock::Right);
    frames(3);
    click("table text:Pictures");
    EXPECT_EQ(table().shows, CellText::Pictures);
    frames(2);
    expectSoundFrame();
}

TEST_F(EnvironmentTable, StandsWithoutATexture) {
    scene().textures.clear();
    unit().enabled = false;
    frames(3);
    click("cell:GL_ADD,GL_RGB");
    EXPECT_EQ(unit().envMode, EnvMode::Add);
    expectSoundFrame();
}

} // namespace
} // namespace texplorer::ui::environment_table_test
