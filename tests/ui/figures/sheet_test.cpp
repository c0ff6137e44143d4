#include "app/ui/model/preview.h"
#include "app/ui/widgets/keys.h"
#include "tests/ui/workbench.h"

#include <fmt/core.h>

namespace texplorer::ui::sheet_test {
namespace {

using namespace test;

class Sheet : public Workbench {
protected:
    Sheet() {
        start(defaultScene(), 1920, 1600);
        session->window.settings.workspace.seams.below = 0.7F; // no cell has to be scrolled to
        open();
    }

    void open() {
        session->window.wantedTab = Tab::Figures;
        session->window.figure = Figure::Sheet;
        frames(3);
    }
    [[nodiscard]] std::size_t steps() const { return session->document.history.position(); }
    void write(std::string_view field, std::string_view values) {
        click(field);
        key('A', {ctrl});
        type(values);
        key(key::enter);
        frames(2);
    }
    void choosePair(std::string_view name) {
        click("sheet:pair");
        frames(2);
        click(name);
        frames(2);
    }
};

TEST_F(Sheet, BeginsWithTheFilterLaboratory) {
    for (const char* filter :
         {"GL_NEAREST", "GL_LINEAR", "GL_NEAREST_MIPMAP_NEAREST", "GL_LINEAR_MIPMAP_NEAREST",
          "GL_NEAREST_MIPMAP_LINEAR", "GL_LINEAR_MIPMAP_LINEAR"})
        for (const char* anisotropy : {"1", "2", "4", "8", "16"})
            EXPECT_TRUE(has(fmt::format("sheet cell:{},{}", anisotropy, filter)));
    EXPECT_TRUE(has("sheet:own"));
}

TEST_F(Sheet, AClickTakesBothValuesInOneStep) {
    const Scene before = scene();
    const std::size_t step = steps();
    click("sheet cell:2,GL_NEAREST");
    EXPECT_EQ(texture().minFilter, MinFilter::Nearest);
    EXPECT_EQ(texture().maxAnisotropy, 2);
    EXPECT_EQ(steps(), step + 1);
    undo(*session);
    EXPECT_EQ(scene(), before);
}

TEST_F(Sheet, TheViewShowsTheCellUnderThePointer) {
    moveTo(place("sheet cell:2,GL_LINEAR"));
    frames(2);
    EXPECT_EQ(shownScene(*session).textures[0].minFilter, MinFilter::Linear);
    EXPECT_EQ(shownScene(*session).textures[0].maxAnisotropy, 2);
    EXPECT_EQ(texture().maxAnisotropy, 1);
    moveTo(place("view"));
    frames(2);
    EXPECT_FALSE(session->window.preview);
}

TEST_F(Sheet, HasOtherPairs) {
    choosePair("sheet pair:environments");
    EXPECT_TRUE(has("sheet cell:GL_DECAL,GL_INTENSITY"));
    choosePair("sheet pair:wraps");
    click("sheet cell:GL_REPEAT,GL_CLAMP_TO_EDGE");
    EXPECT_EQ(texture().wrapS, Wrap::ClampToEdge) << "s goes across";
    EXPECT_EQ(texture().wrapT, Wrap::Repeat);
    click("sheet:swap");
    frames(2);
    click("sheet cell:GL_REPEAT,GL_CLAMP_TO_EDGE");
    EXPECT_EQ(texture().wrapS, Wrap::Repeat);
    EXPECT_EQ(texture().wrapT, Wrap::ClampToEdge);
}

TEST_F(Sheet, TakesAnyParameterAndItsValues) {
    click("sheet:Rows");
    frames(2);
    type("bias");
    frames(2);
    click("sheet offer:textures[0].lodBias");
    frames(2);
    EXPECT_TRUE(has("sheet cell:-2,GL_LINEAR")) << "a few around the current one";
    write("sheet values:Rows", "0..1/3");
    EXPECT_TRUE(has("sheet cell:0.5,GL_LINEAR"));
    EXPECT_FALSE(has("sheet cell:-2,GL_LINEAR"));
    click("sheet cell:0.5,GL_LINEAR");
    EXPECT_EQ(texture().lodBias, 0.5F);
}

TEST_F(Sheet, SaysWhatItCantShow) {
    write("sheet values:Rows", "0..4/5");
    EXPECT_TRUE(has("sheet:problem")) << "anisotropy begins with 1";
    write("sheet values:Rows", "1..16/16");
    EXPECT_FALSE(has("sheet:problem"));
    EXPECT_TRUE(has("sheet:too many"));
    EXPECT_TRUE(has("sheet cell:8,GL_NEAREST"));
    EXPECT_FALSE(has("sheet cell:9,GL_NEAREST"));
}

TEST_F(Sheet, StandsWithoutATexture) {
    scene().textures.clear();
    unit().enabled = false;
    frames(2);
    EXPECT_TRUE(has("sheet:problem")) << "there is no texture";
    expectSoundFrame();
}

TEST_F(Sheet, StandsInEverySize) {
    for (const float scale : {0.75F, 1.0F, 2.5F}) {
        start(defaultScene(), 1024, 700, scale);
        moveTab(session->window.settings.workspace, Tab::Figures, Dock::Right);
        open();
        expectSoundFrame();
    }
}

} // namespace
} // namespace texplorer::ui::sheet_test
