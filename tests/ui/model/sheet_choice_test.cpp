#include "app/ui/files/sheet_file.h"
#include "app/ui/model/session.h"
#include "app/ui/model/sheet_choice.h"

#include <gmock/gmock.h>

namespace texplorer::ui::sheet_choice_test {
namespace {

using testing::HasSubstr;

class SheetChoiceTest : public testing::Test {
protected:
    void choose(SheetAxis rows, SheetAxis columns) {
        session.sheet.own = SheetAxes{std::move(rows), std::move(columns)};
    }

    ServicesAtOnce services;
    Session session{services.lend()};
};

TEST_F(SheetChoiceTest, EveryPairIsOfTwoParametersOfTheScene) {
    for (std::size_t pair = 0; pair < sheetPairs().size(); ++pair) {
        session.sheet.pair = pair;
        const auto axes = sweptAxes(session);
        ASSERT_TRUE(axes) << sheetPairs()[pair].name;
        session.sheet.swapped = !session.sheet.swapped;
        EXPECT_EQ(sweptAxes(session).value()[0], axes.value()[1]);
    }
}

TEST_F(SheetChoiceTest, AParameterThatIsPickedBringsTheSheetToTheFront) {
    varyOnSheet(session, "textures[0].wrapS", 0);
    varyOnSheet(session, "textures[0].wrapT", 1);
    EXPECT_EQ(axesOf(session), (SheetAxes{SheetAxis{"textures[0].wrapS"}, SheetAxis{"textures[0].wrapT"}}));
    EXPECT_EQ(session.window.wantedTab, Tab::Figures);
    EXPECT_EQ(session.window.figure, Figure::Sheet);
    session.sheet.own->at(0).values = "GL_CLAMP";
    varyOnSheet(session, "textures[0].wrapS", 0);
    EXPECT_EQ(axesOf(session)[0].values, "GL_CLAMP") << "it is there already";
    varyOnSheet(session, "textures[0].wrapS", 1);
    EXPECT_EQ(axesOf(session),
              (SheetAxes{SheetAxis{"textures[0].wrapT"}, SheetAxis{"textures[0].wrapS", "GL_CLAMP"}}));
}

TEST_F(SheetChoiceTest, WhatIsNoSheetIsOneSentence) {
    choose({"textures[7].wrapS"}, {"textures[0].wrapT"});
    EXPECT_THAT(describe(sheetOrder(session).error()), HasSubstr("textures[7]"));
    choose({"textures[0].wrapT"}, {"textures[0].wrapT"});
    EXPECT_THAT(describe(sheetOrder(session).error()), HasSubstr("same parameter"));
    choose({"textures[0].lodBias", "0..1/100"}, {"textures[0].maxAnisotropy", "1..16/64"});
    EXPECT_THAT(describe(sheetOrder(session).error()),
                HasSubstr("at most 4096 pictures on a sheet, found 100 × 64"));
    choose({"textures[0].lodBias", "0..1/1000000"}, {"textures[0].wrapT"});
    EXPECT_FALSE(sheetOrder(session));
    choose({"textures[0].lodBias", "0..1/5"}, {"textures[0].wrapT"});
    session.sheet.width = 16000;
    EXPECT_THAT(describe(sheetExtent(session).error()), HasSubstr("smaller pictures or fewer values"));
    EXPECT_THAT(describe(saveSheet(session, "sheet.png").error()),
                HasSubstr("smaller pictures or fewer values"));
    session.sheet.width = 64;
    EXPECT_THAT(describe(saveSheet(session, "sheet.json").error()), HasSubstr("found \"sheet.json\""));
}

TEST_F(SheetChoiceTest, TheOrderIsOfTheSceneAsItIs) {
    choose({"textures[0].lodBias", "0..1/3"}, {"textures[0].wrapT", "GL_REPEAT,GL_CLAMP"});
    session.document.scene.view.azimuth = 12;
    session.look.playback.time = 1.5;
    session.document.suggested = "/somewhere/earth.texplorer.json";
    session.sheet.labels = sheet::LabelKind::Words;
    const SheetOrder order = sheetOrder(session).value();
    EXPECT_EQ(order.picture.scene, session.document.scene);
    EXPECT_EQ(order.picture.time, 1.5);
    EXPECT_EQ(order.content.title, "earth");
    EXPECT_EQ(order.content.cell, glm::ivec2(320, 200));
    EXPECT_THAT(order.content.down.values, testing::ElementsAre("0 levels", "0.5 levels", "1 levels"));
    EXPECT_THAT(order.content.across->values, testing::ElementsAre("Repeat", "Clamp (legacy)"));
    EXPECT_EQ(sheetFileName(session.document), "earth-sheet.png");
}

} // namespace
} // namespace texplorer::ui::sheet_choice_test
