// Overlays for presentations: notes and the spotlight.

#include "app/ui/files/replaced_document.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/palette.h"
#include "app/ui/window/notes.h"
#include "tests/ui/workbench.h"

namespace texplorer::notes_test {
namespace {

using namespace ui;

class Notes : public test::Workbench {
protected:
    [[nodiscard]] ViewNotes& notes() { return session->look.notes; }
    /// A point of the picture area, as fractions of its size.
    [[nodiscard]] ImVec2 at(float x, float y) const {
        return {static_cast<float>(layout.canvas.x) + x * static_cast<float>(layout.canvas.width),
                static_cast<float>(layout.canvas.y) + y * static_cast<float>(layout.canvas.height)};
    }
    void write(ImVec2 where, std::string_view words) {
        moveTo(where);
        key('N');
        type(words);
        key(ui::key::enter);
    }
};

TEST_F(Notes, AKeyPutsOneAtThePointer) {
    write(at(0.25F, 0.5F), "see the seam");
    ASSERT_EQ(notes().list.size(), 1U);
    EXPECT_EQ(notes().list[0].text, "see the seam");
    EXPECT_NEAR(notes().list[0].at.x, 0.25F, 0.01F);
    EXPECT_NEAR(notes().list[0].at.y, 0.5F, 0.01F);
    EXPECT_FALSE(notes().isEdited);
    EXPECT_TRUE(has("note:0"));
    EXPECT_FALSE(session->document.history.canUndo()) << "it is no part of the scene";
}

TEST_F(Notes, AreRemovedWithTheDocument) {
    write(at(0.25F, 0.5F), "see the seam");
    replaceDocument(*session, {defaultScene(), ImageSource{}});
    frames(2);
    EXPECT_FALSE(has("note:0"));
}

TEST_F(Notes, DeleteRemovesTheOneUnderThePointer) {
    write(at(0.2F, 0.2F), "first");
    write(at(0.7F, 0.2F), "second");
    moveTo(place("note:0"));
    key(ui::key::del);
    ASSERT_EQ(notes().list.size(), 1U);
    EXPECT_EQ(notes().list[0].text, "second");
}

TEST_F(Notes, OneWithoutWordsIsNone) {
    moveTo(at(0.3F, 0.3F));
    key('N');
    EXPECT_TRUE(has("note:field"));
    key(ui::key::escape);
    EXPECT_TRUE(notes().list.empty());
    moveTo(place("parameters"));
    key('N');
    EXPECT_TRUE(notes().list.empty()) << "the pointer is not over the view";
}

TEST_F(Notes, ADragMovesOneAndTheCameraStays) {
    write(at(0.25F, 0.25F), "here");
    const Scene before = scene();
    const auto width = static_cast<float>(layout.canvas.width);
    drag(place("note:0"), {0.5F * width, 0});
    EXPECT_NEAR(notes().list[0].at.x, 0.75F, 0.02F);
    EXPECT_NEAR(notes().list[0].at.y, 0.25F, 0.02F);
    EXPECT_EQ(scene(), before);
    drag(place("note:0"), {width, 0});
    const WidgetPlaces::Item& shown = places.items.find("note:0")->second;
    EXPECT_LE(shown.right, static_cast<float>(layout.canvas.right()) + 1) << "it stays inside";
}

TEST_F(Notes, ADoubleClickEditsAndDeleteRemoves) {
    write(at(0.2F, 0.2F), "first");
    write(at(0.6F, 0.6F), "second");
    doubleClickAt(place("note:0"));
    ASSERT_TRUE(has("note:field"));
    type("changed");
    key(ui::key::enter);
    EXPECT_EQ(notes().list[0].text, "changed");
    clickAt(place("note:1"));
    key(ui::key::del);
    ASSERT_EQ(notes().list.size(), 1U);
    EXPECT_EQ(notes().list[0].text, "changed");
    key(ui::key::del);
    EXPECT_EQ(notes().list.size(), 1U) << "none is chosen";
}

TEST_F(Notes, TheMenuPutsOneInTheMiddleAndClearsThem) {
    click("menu:View");
    click("menu:Note");
    ASSERT_TRUE(has("note:field"));
    type("middle");
    key(ui::key::enter);
    EXPECT_EQ(notes().list.at(0).text, "middle");
    click("menu:View");
    click("menu:Clear notes");
    EXPECT_TRUE(notes().list.empty());
    EXPECT_FALSE(has("note:0"));
}

// Dear ImGui's lists have room for some 16,000 letters, and a note has nine of each.
TEST_F(Notes, ALongOneIsCutAndItsFieldStaysOverTheView) {
    for (const auto& [letter, count] :
         {std::pair{std::string("M"), 100'000}, std::pair{std::string("я"), 600}}) {
        std::string words;
        for (int i = 0; i < count; ++i)
            words += letter;
        moveTo(at(0.9F, 0.9F));
        key('N');
        ImGui::SetClipboardText(words.c_str());
        key('V', {test::ctrl});
        frames(2);
        const WidgetPlaces::Item field = places.items.at("note:field");
        EXPECT_GE(field.left, static_cast<float>(layout.canvas.x));
        EXPECT_LE(field.right, static_cast<float>(layout.canvas.right()) + 1);
        key(ui::key::enter);
        frames(2);
        ASSERT_EQ(notes().list.size(), 1U);
        EXPECT_LE(notes().list[0].text.size(), maxNoteBytes);
        EXPECT_GE(notes().list[0].text.size(), maxNoteBytes - 2);
        EXPECT_TRUE(notes().list[0].text.ends_with(letter + "…"));
        expectSoundFrame();
        clearNotes(*session);
    }
}

/// The number of pixels that differ noticeably from the first picture.
int pixelsThatDiffer(const Image& a, const Image& b, const WidgetPlaces::Item& item, int height) {
    int count = 0;
    for (int y = static_cast<int>(item.top); y < static_cast<int>(item.bottom); ++y) {
        for (int x = static_cast<int>(item.left); x < static_cast<int>(item.right); ++x)
            count += a.at(x, height - 1 - y)[1] != b.at(x, height - 1 - y)[1];
    }
    return count;
}

TEST_F(Notes, AreSeenWithTheirHalo) {
    moveTo({1, 1});
    const Image without = picture();
    write(at(0.4F, 0.4F), "MMMM");
    moveTo({1, 1});
    clickAt(at(0.05F, 0.95F)); // no longer selected: no frame
    moveTo({1, 1});
    const Image with = picture();
    const WidgetPlaces::Item item = places.items.find("note:0")->second;
    const auto area = static_cast<int>((item.right - item.left) * (item.bottom - item.top));
    EXPECT_GT(pixelsThatDiffer(without, with, item, 800), area / 3);
}

TEST_F(Notes, GrowWithTheText) {
    write(at(0.4F, 0.4F), "words");
    const WidgetPlaces::Item before = places.items.find("note:0")->second;
    session->settings.textPercent = 200;
    frames(3);
    const WidgetPlaces::Item after = places.items.find("note:0")->second;
    EXPECT_NEAR((after.right - after.left) / (before.right - before.left), 2, 0.15);
}

TEST_F(Notes, TheSpotlightDimsAllButADisc) {
    moveTo(at(0.5F, 0.5F));
    const Image without = picture();
    key('L');
    EXPECT_TRUE(session->window.spotlight);
    const Image with = picture();
    const ImVec2 centre = at(0.5F, 0.5F);
    const auto pixel = [&](const Image& image, float x, float y) {
        return std::to_integer<int>(image.at(static_cast<int>(x), 799 - static_cast<int>(y))[1]);
    };
    EXPECT_EQ(pixel(with, centre.x + 20, centre.y), pixel(without, centre.x + 20, centre.y));
    int brighter = 0;
    for (int x = 0; x < 300; ++x) // the parameters, far away
        brighter += pixel(with, static_cast<float>(x), 300) > pixel(without, static_cast<float>(x), 300) / 2;
    EXPECT_EQ(brighter, 0) << "a third of the light is left";
    key(ui::key::escape);
    EXPECT_FALSE(session->window.spotlight);
    click("menu:View");
    click("menu:Spotlight");
    EXPECT_TRUE(session->window.spotlight);
}

} // namespace
} // namespace texplorer::notes_test
