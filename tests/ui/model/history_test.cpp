// Undo and redo as the window offers them, with the names of the edits; the history itself is core's.

#include "app/ui/widgets/keys.h"
#include "tests/ui/edits.h"
#include "tests/ui/workbench.h"

namespace texplorer::ui::history_test {
namespace {

using namespace test;

class EditMenu : public Workbench {
protected:
    void item(std::string_view menu, std::string_view name) {
        click("menu:" + std::string(menu));
        click("menu:" + std::string(name));
    }
};

TEST_F(EditMenu, NamesWhatItUndoesAndRedoes) {
    choose("textures[0].wrapS", "GL_CLAMP");
    item("Edit", "Undo Wrap s: Clamp (legacy)");
    EXPECT_EQ(texture().wrapS, Wrap::Repeat);
    item("Edit", "Redo Wrap s: Clamp (legacy)");
    EXPECT_EQ(texture().wrapS, Wrap::Clamp);
}

TEST_F(EditMenu, ResetsATextureToGlsInitialValuesButKeepsItsImage) {
    texture().pattern = Pattern::Brick;
    texture().wrapS = Wrap::Clamp;
    item("Edit", "Texture parameters");
    EXPECT_EQ(texture().pattern, Pattern::Brick);
    EXPECT_EQ(texture().wrapS, Wrap::Repeat);
    EXPECT_EQ(texture().minFilter, MinFilter::NearestMipmapLinear);
}

TEST_F(EditMenu, ResetsAUnitButKeepsItsBinding) {
    unit().envMode = EnvMode::Add;
    unit().matrix.resize(3);
    item("Edit", "Texture unit");
    EXPECT_EQ(unit(), (Unit{.enabled = true}));
}

TEST_F(EditMenu, ResetsEverythingAndUndoesIt) {
    const Scene before = scene();
    item("Edit", "Everything but models and view");
    EXPECT_EQ(scene().material, Material{});
    EXPECT_EQ(scene().light, Light{});
    EXPECT_EQ(scene().models, before.models);
    EXPECT_EQ(scene().view, before.view);
    key('Z', {ctrl});
    EXPECT_EQ(scene(), before);
}

TEST_F(EditMenu, ViewShowsShapes) {
    item("View", "Show Cube");
    EXPECT_TRUE(scene().models[0].visible);
    EXPECT_FALSE(scene().models[1].visible);
}

TEST_F(EditMenu, ArrowsAndEnterWorkInAnOpenList) {
    scrollTo("textures[0].internalFormat");
    click("textures[0].internalFormat");
    key(key::down);
    key(key::space);
    EXPECT_NE(texture().internalFormat, InternalFormat::Rgba);
    EXPECT_TRUE(session->look.playback.playing) << "Space was the list's";
}

TEST_F(EditMenu, TheListsFollowWhatUndoShows) {
    item("View", "Show Sphere");
    EXPECT_EQ(session->look.selection.model, 1);
    scene().models[0].visible = true;
    scene().models[1].visible = false;
    recordEdit(*session, "Visible");
    EXPECT_EQ(session->look.selection.model, 1) << "hiding a model does not move the selection off it";
    key('Z', {ctrl});
    EXPECT_EQ(session->look.selection.model, 1);
    key('Y', {ctrl});
    EXPECT_EQ(session->look.selection.model, 0);
}

TEST_F(EditMenu, HelpOpensAndCloses) {
    key(key::f1);
    EXPECT_TRUE(has("help:close"));
    key(key::space);
    EXPECT_TRUE(session->look.playback.playing) << "the keys are the dialog's";
    click("help:close");
    EXPECT_FALSE(has("help:close"));
}

} // namespace
} // namespace texplorer::ui::history_test
