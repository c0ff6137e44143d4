// The toolbar of the texture space, and the controls behind "…".

#include "app/ui/state/chosen_vertices.h"
#include "app/ui/texture_space/plane_keys.h"
#include "app/ui/widgets/keys.h"
#include "tests/ui/texture_space/plane_bench.h"

#include <mutex>

namespace texplorer::ui::plane_tools_test {
namespace {

using namespace test;

class PlaneTools : public PlaneBench {
protected:
    PlaneTools()
        : PlaneBench(Shape::Quad) {}

    void openTools() {
        click("plane tools");
        frames(2);
    }
    /// Within a white and a black square of checker.c's picture, away from outlines.
    ImVec2 white() { return at(1.5F / 8, 2.5F / 8); }
    ImVec2 black() { return at(0.5F / 8, 2.5F / 8); }
};

TEST_F(PlaneTools, StayInOneLine) {
    for (const float width : {300.0F, 350.0F, 420.0F, 600.0F}) {
        session->settings.workspace.seams.details = width;
        frames(4);
        const WidgetPlaces::Item& fit = places.items.at("fit plane");
        const WidgetPlaces::Item& canvas = places.items.at("texture space");
        for (const char* name :
             {"channel:R", "channel:L", "snap", "box select", "mirror s", "mirror t", "plane tools"}) {
            const auto found = places.items.find(std::string_view(name));
            if (found == places.items.end())
                continue;
            EXPECT_EQ(found->second.top, fit.top) << name << " at " << width;
            EXPECT_LE(found->second.right, fit.left) << name << " at " << width;
            EXPECT_GE(found->second.left, canvas.left) << name << " at " << width;
        }
        EXPECT_LE(fit.right, canvas.right + 1);
        EXPECT_LE(fit.bottom, canvas.top);
        EXPECT_TRUE(has("plane tools"));
    }
    EXPECT_TRUE(has("mirror t")) << "with so much room";
}

// 255 times 2^-1 is 127.5; with the range 0.25 to 0.75 it is white again, and 0 stays black.
TEST_F(PlaneTools, ExposureAndRangeChangeWhatIsShown) {
    EXPECT_EQ(shown(white()), 255);
    const Scene before = scene();
    state().look.exposure = -1;
    EXPECT_NEAR(shown(white()), 127.5, 0.6);
    EXPECT_EQ(shown(black()), 0);
    state().look.low = 0.25F;
    state().look.high = 0.75F;
    EXPECT_NEAR(shown(white()), 127.5, 0.6) << "(0.5 - 0.25) / 0.5";
    state().look.exposure = 0;
    EXPECT_EQ(shown(white()), 255);
    EXPECT_EQ(scene(), before) << "nothing of the scene changes";
}

TEST_F(PlaneTools, AChannelIsShownAsGrey) {
    texture().internalFormat = InternalFormat::Rgba;
    texture().preparation = {{.op = ImageOp::Scale, .factor = {1, 0.5F, 0.25F, 1}}};
    (void)picture();
    EXPECT_NEAR(shown(white(), 1), 127.5, 1);
    click("channel:G");
    for (const int component : {0, 1, 2})
        EXPECT_NEAR(shown(white(), component), 127.5, 1) << component;
    click("channel:B");
    EXPECT_NEAR(shown(white()), 63.75, 1);
    click("channel:A");
    EXPECT_EQ(shown(black()), 255) << "opaque";
    // 0.2126 * 255 + 0.7152 * 127.5 + 0.0722 * 63.75
    click("channel:L");
    EXPECT_NEAR(shown(white()), 150, 1.5);
    EXPECT_NE(noted("legend:level 0 · Luminance"), "");
    click("channel:L");
    EXPECT_EQ(state().look.channel, Channel::All) << "pressed again, all are shown";
}

// The last level of a half-white picture: grey everywhere.
TEST_F(PlaneTools, ShowsTheLevelThatIsChosen) {
    texture().mipmaps = MipPolicy::Generated;
    state().look.level = 6;
    frames(3);
    EXPECT_NEAR(shown(white()), 127.5, 1);
    EXPECT_NEAR(shown(black()), 127.5, 1);
    texture().mipmaps = MipPolicy::None;
    frames(3);
    EXPECT_EQ(state().look.level, 0) << "there is no other level";
    EXPECT_EQ(shown(white()), 255);
}

// checker.c: half of the texels are 255, the others 0.
TEST_F(PlaneTools, TheHistogramHasItsNumbers) {
    (void)picture();
    openTools();
    EXPECT_TRUE(has("histogram"));
    for (const char* name : {"statistics:R 0 255 127.50", "statistics:B 0 255 127.50",
                             "statistics:A 255 255 255.00", "statistics:L 0 255 127.50"})
        EXPECT_TRUE(has(name)) << name << ", not " << noted("statistics:");
    // Each component has its own line, one below the other.
    EXPECT_LE(places.items.at("histogram:R").bottom, places.items.at("histogram:G").top + 1);
    EXPECT_LE(places.items.at("histogram:G").bottom, places.items.at("histogram:B").top + 1);
    EXPECT_FALSE(has("histogram:A"));
}

TEST_F(PlaneTools, SlidersWork) {
    openTools();
    drag(place("exposure"), {60, 0});
    EXPECT_GT(state().look.exposure, 0.1F);
    click("plain look");
    EXPECT_TRUE(state().look.isPlain());
    click("channel=Red");
    EXPECT_EQ(state().look.channel, Channel::Red);
    click("board");
    EXPECT_FALSE(state().look.board);
    click("snap:Quarters");
    EXPECT_TRUE(state().snapping.on);
    EXPECT_EQ(state().snapping.to, Snap::Quarter);
    click("drag selects");
    EXPECT_TRUE(state().selects);
    click("vertex numbers");
    click("legend on");
    EXPECT_EQ(noted("vertex number:"), "");
    EXPECT_EQ(noted("legend:"), "");
}

TEST_F(PlaneTools, MirrorTheChosenOnesOrAll) {
    openTools();
    click("menu mirror s");
    expectCoord(0, 1, 0);
    expectCoord(2, 0, 1);
    EXPECT_EQ(undoSteps(), 1U);
    chooseVertices(session->look.selection, {0, 1});
    click("menu mirror t");
    expectCoord(0, 1, 0); // both have the same t
    chooseVertices(session->look.selection, {1, 2});
    click("menu mirror t");
    expectCoord(1, 0, 1);
    expectCoord(2, 0, 0);
    expectCoord(3, 1, 1);
}

// Longitudes of the square's corners in the plane z = 0: 0.25 on the left, 0.75 on the right.
TEST_F(PlaneTools, ProjectIsOneStep) {
    openTools();
    click("project:Spherical");
    expectCoord(0, 0.25F, 0.25F);
    expectCoord(2, 0.75F, 0.75F);
    click("project:Planar");
    expectCoord(0, 0, 0);
    expectCoord(2, 1, 1);
    EXPECT_EQ(undoSteps(), 2U);
    EXPECT_EQ(session->document.history.undoName(), "Planar projection");
}

TEST_F(PlaneTools, CoordinatesAreCopiedAndPasted) {
    openTools();
    click("copy coordinates");
    EXPECT_STREQ(ImGui::GetClipboardText(), "0 0\n1 0\n1 1\n0 1\n");
    ImGui::SetClipboardText("0 0\n2 0\n2 2\n0 2");
    click("paste coordinates");
    expectCoord(2, 2, 2);
    EXPECT_EQ(undoSteps(), 1U);
    chooseVertices(session->look.selection, {0, 2});
    ImGui::SetClipboardText("0.5, 0.25\n3, 4");
    click("paste coordinates");
    expectCoord(0, 0.5F, 0.25F);
    expectCoord(1, 2, 0);
    expectCoord(2, 3, 4);
}

TEST_F(PlaneTools, WhatDoesNotFitIsToldAndChangesNothing) {
    const Scene before = scene();
    moveTo(at(0.5F, 0.5F));
    ImGui::SetClipboardText("hello");
    key('V', {ctrl});
    EXPECT_EQ(session->look.notice.text,
              "The clipboard has no texture coordinates: line 1: expected a number, found \"hello\".");
    ImGui::SetClipboardText("0 0\n1 1\n");
    key('V', {ctrl});
    EXPECT_EQ(session->look.notice.text, "Expected coordinates of 4 vertices, but the clipboard has 2.");
    EXPECT_EQ(scene(), before);
    ImGui::SetClipboardText("");
    key('C', {ctrl});
    EXPECT_STREQ(ImGui::GetClipboardText(), "0 0\n1 0\n1 1\n0 1\n");
}

TEST_F(PlaneTools, OfACubeMapHaveNoVertices) {
    texture().pattern = Pattern::CubeFaces;
    unit().target = Target::CubeMap;
    state().look.channel = Channel::Red;
    (void)picture();
    // +x in the third column is red, +y above the second one green.
    EXPECT_GT(shown(at(0.69F, 0.4F)), shown(at(0.44F, 0.66F)) + 60);
    openTools();
    EXPECT_FALSE(has("copy coordinates"));
    EXPECT_TRUE(has("histogram"));
}

TEST_F(PlaneTools, TheKeysOverThePlaneAreListed) {
    key(ui::key::f1);
    frames(2);
    for (const PlaneKeyRow& row : planeKeys)
        EXPECT_TRUE(has(std::string("plane key:") + row.keys)) << row.keys;
    EXPECT_GE(planeKeys.size(), 8U);
}

/// With threads, a large image's levels arrive later: the previous picture stays until then.
class PlaneToolsLater : public PlaneTools {
protected:
    PlaneToolsLater() { lend(services.lend()); }

    void show(std::byte value) {
        Image image = Image::uninitialised(PixelFormat::Rgba8, 1024, 512);
        std::ranges::fill(image.pixels, value);
        session->document.images.put("made.dds", textureOf(std::move(image), "DDS"));
        texture().source = SourceKind::File;
        texture().file = "made.dds";
        texture().mipmaps = MipPolicy::Generated;
        frames(2);
    }
    void waitForAll() {
        for (int i = 0; i < 3; ++i) {
            services.lend().levels->wait();
            frames(2);
            services.lend().levelPictures->wait();
            frames(2);
        }
    }

    std::mutex held;
    ServicesBeside services{[this] { const std::scoped_lock lock(held); }};
};

TEST_F(PlaneToolsLater, WhatWasCancelledComesWhenItIsWantedAgain) {
    LevelsWorker& worker = session->services.levels;
    {
        const std::unique_lock lock(held);
        show(std::byte{100});
        state().look.channel = Channel::Red;
        frames(3);
        ASSERT_TRUE(worker.progress());
        worker.cancel(worker.progress()->ticket);
    }
    waitForAll();
    EXPECT_EQ(state().level.picture(), nullptr);
    EXPECT_NE(state().level.problem(), "");
    worker.retry({session->document.images.picturesOf(texture()), imageSettings(texture()), unit().target});
    frames(1);
    EXPECT_EQ(state().level.problem(), "") << "it is pending";
    waitForAll();
    ASSERT_NE(state().level.picture(), nullptr);
    EXPECT_EQ(state().level.picture()->width, 1024);
    EXPECT_EQ(state().level.problem(), "");
}

TEST_F(PlaneToolsLater, TheFormerPictureStaysUntilThereIsANewOne) {
    show(std::byte{100});
    {
        const std::unique_lock lock(held);
        state().look.channel = Channel::Red;
        frames(3);
        EXPECT_EQ(state().level.picture(), nullptr);
        EXPECT_TRUE(state().level.isComputing());
        EXPECT_NE(noted("legend:Computing…"), "");
    }
    waitForAll();
    ASSERT_NE(state().level.picture(), nullptr);
    EXPECT_EQ(state().level.picture()->width, 1024);
    EXPECT_EQ(state().level.statistics()->components[0].mean, 100);
    EXPECT_EQ(noted("legend:Computing…"), "");
    {
        const std::unique_lock lock(held);
        state().look.level = 1;
        frames(3);
        ASSERT_NE(state().level.picture(), nullptr);
        EXPECT_EQ(state().level.picture()->width, 1024) << "the former one";
        EXPECT_NE(noted("legend:Computing…"), "");
    }
    waitForAll();
    EXPECT_EQ(state().level.picture()->width, 512);
    EXPECT_EQ(state().level.picture()->height, 256);
    state().look.exposure = 1;
    waitForAll();
    EXPECT_EQ(std::to_integer<int>(state().level.picture()->at(3, 3)[0]), 200) << "100 times 2";
    EXPECT_FALSE(state().level.isComputing());
}

TEST_F(PlaneToolsLater, AnImageThatIsGoneIsNotShown) {
    show(std::byte{100});
    state().look.channel = Channel::Red;
    waitForAll();
    ASSERT_NE(state().level.picture(), nullptr);
    const std::unique_lock lock(held);
    show(std::byte{50});
    EXPECT_EQ(state().level.picture(), nullptr);
    EXPECT_TRUE(state().level.isComputing());
}

} // namespace
} // namespace texplorer::ui::plane_tools_test
