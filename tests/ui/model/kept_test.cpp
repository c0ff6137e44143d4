// A and B: what was kept, and what is now. By the menu, the row and the keys.

#include "app/ui/files/replaced_document.h"
#include "app/ui/model/kept.h"
#include "app/ui/model/preview.h"
#include "tests/ui/edits.h"
#include "tests/ui/workbench.h"

#include <gmock/gmock.h>

namespace texplorer::ui::kept_test {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::Field;
using testing::IsEmpty;

class Kept : public Workbench {
protected:
    void edit() {
        texture().wrapS = Wrap::Clamp;
        recordEdit(*session, "Wrap s");
        sealEdit(*session);
        frames(1);
    }
    void item(std::string_view name) {
        click("menu:A/B");
        click("a-b:" + std::string(name));
    }
    [[nodiscard]] const std::shared_ptr<const Scene>& kept() const { return session->document.kept.scene; }
};

TEST_F(Kept, TheMenuKeepsTheSceneAndUndoLeavesItAlone) {
    edit();
    item("keep");
    ASSERT_TRUE(kept());
    EXPECT_EQ(*kept(), scene());
    key('Z', {ctrl});
    EXPECT_EQ(texture().wrapS, Wrap::Repeat);
    EXPECT_EQ(kept()->textures[0].wrapS, Wrap::Clamp);
}

TEST_F(Kept, WithoutItNothingFlips) {
    key('T');
    key('T', {shift});
    item("flip");
    EXPECT_FALSE(isKeptShown(*session));
    EXPECT_EQ(session->view.arrangement, Arrangement::One);
    EXPECT_THAT(changesSinceKept(*session), IsEmpty());
}

TEST_F(Kept, AKeyFlipsTheViewAndAnEditFlipsItBack) {
    key('K');
    edit();
    EXPECT_EQ(&shownScene(*session), &scene());
    key('T');
    EXPECT_TRUE(isKeptShown(*session));
    EXPECT_EQ(shownScene(*session), *kept());
    EXPECT_TRUE(has("side:A"));
    key('T');
    EXPECT_EQ(&shownScene(*session), &scene());
    key('T');
    choose("textures[0].wrapT", "GL_CLAMP");
    frames(1);
    EXPECT_FALSE(isKeptShown(*session)) << "one sees what one edits";
    EXPECT_EQ(&shownScene(*session), &scene());
}

TEST_F(Kept, IsSeenByThePresentCamera) {
    key('K');
    edit();
    key('T');
    drag(place("view"), {60, 0});
    EXPECT_TRUE(isKeptShown(*session)) << "to look around is no edit of what one compares";
    EXPECT_EQ(shownScene(*session).view, scene().view);
    EXPECT_NE(shownScene(*session).view, kept()->view);
    EXPECT_EQ(shownScene(*session).textures, kept()->textures);
    EXPECT_THAT(changesSinceKept(*session), ElementsAre(Field(&SceneChange::path, "textures[0].wrapS")));
}

TEST_F(Kept, GoesWithItsDocument) {
    key('K');
    key('T', {shift});
    EXPECT_EQ(session->view.arrangement, Arrangement::Kept);
    replaceDocument(*session, {defaultScene(), ImageSource{}});
    frames(1);
    EXPECT_FALSE(kept());
    EXPECT_EQ(session->view.arrangement, Arrangement::One);
}

TEST_F(Kept, TheRowHasWhatFits) {
    EXPECT_TRUE(has("a-b row:keep"));
    EXPECT_FALSE(has("a-b row:flip"));
    click("a-b row:keep");
    ASSERT_TRUE(has("a-b row:flip"));
    edit();
    click("a-b row:flip");
    EXPECT_TRUE(isKeptShown(*session));
    click("a-b row:split");
    EXPECT_FALSE(isKeptShown(*session));
    EXPECT_TRUE(isKeptBeside(*session));
}

TEST_F(Kept, TheViewSplitsBothAcrossOnePicture) {
    texture().pattern = Pattern::ColorLine;
    scene().passes[0].lighting = false;
    recordEdit(*session, "a");
    key('K');
    texture().pattern = Pattern::Checker;
    recordEdit(*session, "b");
    const Image now = picture();
    key('T', {shift});
    static_cast<void>(picture());
    const Image both = picture();
    EXPECT_TRUE(has("side:A"));
    EXPECT_TRUE(has("side:Now"));
    EXPECT_TRUE(has("A and now"));
    EXPECT_TRUE(has("share over")) << "the numbers of both";
    // Left of the seam there are colours, which the board on its right has none of.
    const auto colors = [&](const Image& image, int from, int to) {
        int count = 0;
        for (int y = layout.picture.y + 60; y < layout.picture.bottom() - 60; ++y) {
            for (int x = from; x < to; ++x) {
                const auto pixel = image.at(x, image.height - 1 - y);
                const auto [least, most] = std::minmax({pixel[0], pixel[1], pixel[2]});
                count += std::to_integer<int>(most) - std::to_integer<int>(least) > 100;
            }
        }
        return count;
    };
    const int middle = layout.picture.x + layout.picture.width / 2;
    EXPECT_EQ(colors(now, layout.picture.x, layout.picture.right()), 0);
    EXPECT_GT(colors(both, layout.picture.x, middle - 4), 1000);
    EXPECT_LT(colors(both, middle + 4, layout.picture.right()), 300)
        << "but for a ring around the worst pixel";
    drag(place("picture seam"), {100, 0});
    EXPECT_GT(session->view.split, 0.55F);
    key('2');
    EXPECT_TRUE(isKeptBeside(*session)) << "another renderer draws both";
    EXPECT_EQ(session->view.renderer, RendererKind::Shader);
    static_cast<void>(picture());
    EXPECT_GT(colors(picture(), layout.picture.x, middle - 4), 1000);
    key('3');
    static_cast<void>(picture());
    EXPECT_GT(colors(picture(), layout.picture.x, middle - 4), 1000);
    key('4');
    EXPECT_TRUE(comparesRenderers(session->view));
}

TEST_F(Kept, TheListSaysWhatDiffersAndTakesItOver) {
    session->window.wantedTab = Tab::Kept;
    frames(2);
    click("a-b tab:keep");
    EXPECT_TRUE(has("a-b tab:same"));
    edit();
    scene().textures.resize(2);
    recordEdit(*session, "New texture");
    sealEdit(*session);
    frames(2);
    EXPECT_TRUE(has("change:textures[0].wrapS"));
    EXPECT_TRUE(has("change:textures"));
    click("take:textures[0].wrapS");
    EXPECT_EQ(texture().wrapS, Wrap::Repeat);
    EXPECT_EQ(scene().textures.size(), 2U);
    EXPECT_EQ(session->document.history.undoName(), "Wrap s of A");
    EXPECT_FALSE(has("change:textures[0].wrapS"));
    click("take:textures");
    EXPECT_EQ(scene().textures.size(), 1U);
    key('Z', {ctrl});
    key('Z', {ctrl});
    EXPECT_EQ(texture().wrapS, Wrap::Clamp);
    click("a-b tab:take all");
    EXPECT_EQ(scene(), *kept());
    EXPECT_EQ(session->document.history.undoName(), "All of A");
}

TEST_F(Kept, WhatComesBackIsSelectedAsItWas) {
    scene().models.resize(3, scene().models[0]);
    scene().passes.resize(2, scene().passes[0]);
    recordEdit(*session, "More");
    session->look.selection = {.model = 2, .vertex = 5, .group = {}, .pass = 1, .unit = 3};
    keepAsA(*session);
    scene().models.resize(1);
    scene().passes.resize(1);
    recordEdit(*session, "Less");
    frames(1);
    EXPECT_EQ(session->look.selection.model, 0);
    takeFromKept(*session, {"models", "Models", "", "", true});
    frames();
    EXPECT_EQ(session->look.selection.model, 2);
    EXPECT_EQ(session->look.selection.vertex, 5U);
    EXPECT_EQ(session->look.selection.pass, 0);
    takeAllFromKept(*session);
    frames();
    EXPECT_EQ(session->look.selection.pass, 1);
    EXPECT_EQ(session->look.selection.unit, 3);
}

TEST_F(Kept, TakingOverBringsTheSelectionIntoTheScene) {
    keepAsA(*session);
    const auto models = static_cast<int>(scene().models.size());
    scene().models.resize(9, scene().models[0]);
    recordEdit(*session, "More");
    session->look.selection.model = 8;
    session->document.kept.selection.model = 8;
    takeFromKept(*session, {"models", "Models", "", "", true});
    frames();
    EXPECT_LT(session->look.selection.model, models);
}

TEST_F(Kept, WhatDoesNotFitIsRefusedWithASentence) {
    key('K');
    scene().textures.resize(2);
    unit().texture = 1;
    recordEdit(*session, "a");
    const Scene before = scene();
    session->window.wantedTab = Tab::Kept;
    frames(3);
    click("take:textures");
    EXPECT_EQ(scene(), before);
    EXPECT_NE(session->look.notice.text, "");
}

TEST_F(Kept, IsForgottenByTheMenu) {
    key('K');
    edit();
    key('T');
    item("forget");
    EXPECT_FALSE(kept());
    EXPECT_FALSE(isKeptShown(*session));
}

} // namespace
} // namespace texplorer::ui::kept_test
