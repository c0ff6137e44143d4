#include "app/ui/editor/received_files.h"
#include "app/ui/files/asking.h"
#include "app/ui/files/inspected_file.h"
#include "app/ui/files/loads.h"
#include "app/ui/files/scene_files.h"
#include "app/ui/widgets/keys.h"
#include "tests/support/raw_file.h"
#include "tests/support/small_bmp.h"
#include "tests/support/temp_dir.h"
#include "tests/ui/edits.h"
#include "tests/ui/workbench.h"
#include "texplorer/s3tc/surface_pixels.h"

#include <gmock/gmock.h>

#include <condition_variable>
#include <mutex>

namespace texplorer::ui::loads_test {
namespace {

using namespace test;

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A window whose files are read on a thread of their own.
class Loads : public Workbench {
protected:
    Loads() { lend(services.lend()); }
    ~Loads() override { open(true); }

    fs::path bmp(const std::string& name, char red) {
        texplorer::test::writeRaw(folder / name, texplorer::test::onePixelBmp({0, 0, red}));
        return folder / name;
    }
    void write(const std::string& name, const std::string& text) {
        texplorer::test::writeRaw(folder / name, text);
    }
    void openNow(const std::string& name) {
        ASSERT_TRUE(openScene(*session, folder / name));
        waitForFiles(*session);
    }
    void importNow(const fs::path& file) {
        importImage(*session, file);
        waitForFiles(*session);
        frames(1);
    }
    /// Of the picture that is bound; -1: none, or a pattern.
    int red() {
        const Texture* bound = boundTexture(*session);
        if (!bound || bound->source != SourceKind::File || !session->document.images.holds(bound->file))
            return -1;
        return std::to_integer<int>(uprightImage(*session->document.images.find(*bound)).pixels[0]);
    }
    /// Lets the files be read, or holds them up.
    void open(bool isOpen) {
        const std::scoped_lock lock(mutex);
        gateIsOpen = isOpen;
        changed.notify_all();
    }
    /// Frames as long as there is news, until something holds. Where it never does, the test's time
    /// runs out.
    void framesUntil(const std::function<bool()>& holds) {
        while (true) {
            frames(1);
            if (holds())
                return;
            std::unique_lock lock(mutex);
            changed.wait(lock, [this] { return news > 0; });
            news = 0;
        }
    }

    texplorer::test::TempDir folder;
    std::mutex mutex;
    std::condition_variable changed;
    bool gateIsOpen = true;
    int news = 0;
    ServicesBeside services{[this] {
        std::unique_lock lock(mutex);
        ++news;
        changed.notify_all();
        changed.wait(lock, [this] { return gateIsOpen; });
    }};
};

TEST_F(Loads, AnImageComesLaterInOneStepOfUndo) {
    const Scene before = scene();
    importImage(*session, bmp("red.bmp", 50));
    EXPECT_EQ(scene(), before);
    EXPECT_FALSE(session->document.history.canUndo());
    waitForFiles(*session);
    EXPECT_EQ(red(), 50);
    EXPECT_EQ(session->document.history.undoName(), "Open red.bmp");
    take(*session, Undo{});
    EXPECT_EQ(scene(), before);
    EXPECT_FALSE(session->document.history.canUndo());
}

TEST_F(Loads, AFileIsDecodedOnceWhateverASceneCallsIt) {
    (void)bmp("red.bmp", 50);
    fs::create_symlink("red.bmp", folder / "link.bmp");
    write("scene.json", R"({"version": 1, "textures": [{"source": "file", "file": "red.bmp"},
        {"source": "file", "file": "./red.bmp"}, {"source": "file", "file": "link.bmp"}]})");
    openNow("scene.json");
    ASSERT_EQ(scene().textures.size(), 3U);
    const auto image = session->document.images.find(scene().textures[0]);
    ASSERT_NE(image, nullptr);
    EXPECT_EQ(session->document.images.find(scene().textures[1]), image);
    EXPECT_EQ(session->document.images.find(scene().textures[2]), image);
}

TEST_F(Loads, AFileBeyondTheBudgetIsRefusedAndTheSceneStays) {
    TextureImage outline; // as large as all images of a scene may be, but for its pixels
    outline.surfaces.emplace_back(Image{PixelFormat::Rgba8, 16384, 16384, 2, {}});
    ASSERT_EQ(byteCount(outline), sceneImageBytes);
    texture().source = SourceKind::File;
    texture().file = "huge";
    session->document.images.put("huge", std::move(outline));
    const Scene before = scene();
    importImage(*session, bmp("red.bmp", 50));
    waitForFiles(*session);
    EXPECT_EQ(scene(), before);
    EXPECT_THAT(
        session->look.notice.text,
        HasSubstr("red.bmp: the image needs 3 bytes, but of the 2147483648 for all images of a scene, 0 "
                  "are left"));
}

TEST_F(Loads, EditsInBetweenStay) {
    importImage(*session, bmp("red.bmp", 50));
    texture().wrapS = Wrap::Clamp;
    recordEdit(*session, "Wrap s");
    waitForFiles(*session);
    EXPECT_EQ(red(), 50);
    EXPECT_EQ(texture().wrapS, Wrap::Clamp);
    take(*session, Undo{});
    EXPECT_EQ(texture().source, SourceKind::Pattern);
    EXPECT_EQ(texture().wrapS, Wrap::Clamp);
}

TEST_F(Loads, TheLastOneThatWasOpenedIsShown) {
    importNow(bmp("a.bmp", 10));
    importImage(*session, bmp("b.bmp", 20));
    importImage(*session, folder / "a.bmp"); // there already, but it waits its turn
    EXPECT_EQ(red(), 10);
    waitForFiles(*session);
    EXPECT_EQ(red(), 10);
    take(*session, Undo{});
    EXPECT_EQ(red(), 20);
}

TEST_F(Loads, ADamagedImageChangesNothingAndCanBeLookedInto) {
    const Scene before = scene();
    write("half.bmp", texplorer::test::onePixelBmp({0, 0, 1}).substr(0, 40));
    requestOpen(*session, {folder / "half.bmp"});
    waitForFiles(*session);
    frames(2);
    EXPECT_EQ(scene(), before);
    EXPECT_FALSE(session->document.history.canUndo());
    EXPECT_THAT(session->look.notice.text, HasSubstr("half.bmp"));
    click("look inside");
    waitForFiles(*session);
    frames(3);
    ASSERT_TRUE(has("file:problem"));
    EXPECT_TRUE(has("hex:0"));
    EXPECT_EQ(session->look.fileView.shown, folder / "half.bmp");
    click("file:back");
    EXPECT_TRUE(has("file:none"));
    click("dismiss notice");
    EXPECT_FALSE(has("notice"));
}

TEST_F(Loads, AMissingImageIsSaidAtOnce) {
    requestOpen(*session, {folder / "gone.bmp"});
    EXPECT_THAT(session->look.notice.text, HasSubstr("gone.bmp"));
    frames(2);
    EXPECT_FALSE(has("look inside"));
}

TEST_F(Loads, TheStatusBarShowsWhatIsLoadedAndCancels) {
    const Scene before = scene();
    open(false);
    importImage(*session, bmp("red.bmp", 50));
    frames(3);
    ASSERT_TRUE(has("loading"));
    click("cancel:load");
    EXPECT_FALSE(has("loading"));
    EXPECT_TRUE(session->document.loads.empty());
    open(true);
    waitForFiles(*session);
    EXPECT_EQ(scene(), before);
    importNow(folder / "red.bmp");
    EXPECT_EQ(red(), 50);
}

TEST_F(Loads, ASceneComesWithAllItsImages) {
    bmp("a.bmp", 10);
    bmp("b.bmp", 20);
    write("two.json", R"({"version": 1, "textures": [{"source": "file", "file": "a.bmp"},
                                                     {"source": "file", "file": "b.bmp"}]})");
    ASSERT_TRUE(openScene(*session, folder / "two.json").has_value());
    EXPECT_TRUE(session->document.file.empty());
    waitForFiles(*session);
    EXPECT_EQ(session->document.file, folder / "two.json");
    EXPECT_EQ(red(), 10);
    EXPECT_TRUE(session->document.images.holds("b.bmp"));
    EXPECT_FALSE(session->document.history.canUndo());
}

TEST_F(Loads, ASceneWithAMissingImageChangesNothing) {
    const Scene before = scene();
    bmp("a.bmp", 10);
    write("two.json", R"({"version": 1, "textures": [{"source": "file", "file": "gone.bmp"},
                                                     {"source": "file", "file": "a.bmp"}]})");
    openNow("two.json");
    EXPECT_EQ(scene(), before);
    EXPECT_TRUE(session->document.file.empty());
    EXPECT_TRUE(session->document.loads.empty());
    EXPECT_THAT(session->look.notice.text, HasSubstr("gone.bmp"));
}

TEST_F(Loads, OfTwoScenesTheLaterOneIsOpened) {
    bmp("a.bmp", 10);
    const std::string text = R"({"version": 1, "textures": [{"source": "file", "file": "a.bmp"}]})";
    write("one.json", text);
    write("two.json", text);
    ASSERT_TRUE(openScene(*session, folder / "one.json").has_value());
    ASSERT_TRUE(openScene(*session, folder / "two.json").has_value());
    EXPECT_EQ(session->document.loads.size(), 1U);
    waitForFiles(*session);
    EXPECT_EQ(session->document.file, folder / "two.json");
}

TEST_F(Loads, ChangesMadeMeanwhileAreNotLostUnasked) {
    bmp("a.bmp", 10);
    write("one.json", R"({"version": 1, "textures": [{"source": "file", "file": "a.bmp"}]})");
    ASSERT_TRUE(openScene(*session, folder / "one.json").has_value());
    texture().wrapS = Wrap::Clamp;
    recordEdit(*session, "Wrap s");
    waitForFiles(*session);
    EXPECT_EQ(session->asking.dialog, Dialog::Discard);
    EXPECT_TRUE(session->document.file.empty());
    frames(3);
    click("discard:cancel");
    EXPECT_EQ(texture().wrapS, Wrap::Clamp);
    ASSERT_TRUE(openScene(*session, folder / "one.json").has_value());
    texture().wrapT = Wrap::Clamp;
    recordEdit(*session, "Wrap t");
    waitForFiles(*session);
    frames(3);
    click("discard:drop");
    EXPECT_EQ(session->document.file, folder / "one.json");
    EXPECT_EQ(red(), 10);
}

TEST_F(Loads, AChangedFileIsLoadedAgain) {
    importNow(bmp("live.bmp", 10));
    const Scene before = scene();
    bmp("new.bmp", 20);
    fs::rename(folder / "new.bmp", folder / "live.bmp"); // as editors save
    framesUntil([&] { return red() == 20; });
    bmp("live.bmp", 30);
    framesUntil([&] { return red() == 30; });
    EXPECT_EQ(scene(), before);
    EXPECT_EQ(session->document.history.undoName(), "Open live.bmp") << "no step of undo";
}

TEST_F(Loads, ADamagedFileKeepsItsOldPictureAndIsMentionedOnce) {
    importNow(bmp("live.bmp", 10));
    write("live.bmp", "BM, and no more");
    framesUntil([&] { return !session->look.notice.text.empty(); });
    EXPECT_THAT(session->look.notice.text, HasSubstr("live.bmp"));
    EXPECT_THAT(session->look.notice.text, HasSubstr("old image"));
    EXPECT_EQ(red(), 10);
    session->look.notice = {};
    lookInto(*session, folder / "live.bmp"); // shows when the file has been noticed once more
    frames(3);
    const std::string worse = "BM, and a little more, but not enough";
    write("live.bmp", worse);
    framesUntil([&] {
        const auto& content = session->look.fileView.content;
        return content && content->fileBytes == worse.size() && session->document.loads.empty();
    });
    EXPECT_EQ(session->look.notice.text, "");
    bmp("live.bmp", 40);
    framesUntil([&] { return red() == 40; });
    EXPECT_TRUE(session->document.damaged.empty());
    write("live.bmp", "BM");
    framesUntil([&] { return !session->look.notice.text.empty(); });
    bmp("live.bmp", 50);
    framesUntil([&] { return red() == 50; });
    EXPECT_EQ(session->look.notice.text, "") << "the file is whole";
}

TEST_F(Loads, TheCommandLinesFilesComeLaterAllAtOnce) {
    const fs::path a = bmp("a.bmp", 10);
    const fs::path b = bmp("b.bmp", 20);
    write("scene.json", R"({"version": 1, "textures": [{"wrapS": "GL_CLAMP"}]})");
    open(false);
    ASSERT_TRUE(openArguments(*session, {a, folder / "scene.json", b, a}).has_value());
    frames(3);
    EXPECT_TRUE(has("loading"));
    EXPECT_EQ(red(), -1);
    EXPECT_TRUE(session->document.file.empty());
    open(true);
    waitForFiles(*session);
    EXPECT_EQ(red(), 10);
    EXPECT_EQ(texture().wrapS, Wrap::Clamp);
    EXPECT_EQ(session->document.file, folder / "scene.json");
    ASSERT_EQ(scene().textures.size(), 3U);
    EXPECT_TRUE(session->document.images.holds(scene().textures[1].file));
    EXPECT_FALSE(isDirty(session->document));
    EXPECT_FALSE(session->document.history.canUndo());
}

TEST_F(Loads, ADamagedFileOfTheCommandLineIsSaidInTheWindow) {
    write("half.bmp", texplorer::test::onePixelBmp({0, 0, 1}).substr(0, 40));
    EXPECT_TRUE(checkArguments({folder / "half.bmp"}).empty()) << "it begins as a BMP does";
    ASSERT_TRUE(openArguments(*session, {folder / "half.bmp"}).has_value());
    waitForFiles(*session);
    frames(2);
    EXPECT_TRUE(has("look inside"));
    write("text.bmp", "Hello");
    EXPECT_EQ(checkArguments({folder / "text.bmp"}).size(), 1U);
    EXPECT_EQ(checkArguments({folder / "gone.bmp"}).size(), 1U);
}

TEST_F(Loads, OneBadFileOfManyIsListedAndTheOthersAreOpened) {
    std::vector<fs::path> files;
    for (int i = 0; i < 40; ++i)
        files.push_back(bmp("good" + std::to_string(i) + ".bmp", static_cast<char>(i)));
    write("half.bmp", texplorer::test::onePixelBmp({0, 0, 1}).substr(0, 40));
    write("text.bmp", "Hello");
    files.insert(files.begin(), folder / "half.bmp"); // the one that would be shown
    files.insert(files.begin() + 20, folder / "text.bmp");
    files.insert(files.begin() + 30, folder / "gone.bmp");
    EXPECT_EQ(checkArguments(files).size(), 2U) << "what is seen before it is decoded";
    ASSERT_TRUE(openArguments(*session, files).has_value());
    waitForFiles(*session);
    frames(3);
    EXPECT_EQ(scene().textures.size(), 40U);
    EXPECT_EQ(red(), 0) << "the first that could be read is shown";
    EXPECT_FALSE(session->document.history.canUndo());
    EXPECT_FALSE(isDirty(session->document));
    EXPECT_EQ(session->asking.dialog, Dialog::Refused);
    ASSERT_EQ(session->asking.refused.size(), 3U);
    for (const char* each : {"half.bmp", "text.bmp", "gone.bmp"})
        EXPECT_TRUE(has("refused:" + (folder / each).string())) << each;
    for (const Error& each : session->asking.refused)
        EXPECT_FALSE(each.message.empty()) << each.where;
    click("refused:close");
    EXPECT_EQ(session->asking.dialog, Dialog::None);
    frames(2);
    EXPECT_EQ(session->asking.dialog, Dialog::None) << "it is said once";
}

TEST_F(Loads, HundredsOfBadFilesAreAListThatScrolls) {
    std::vector<fs::path> files{bmp("red.bmp", 50)};
    for (int i = 0; i < 300; ++i)
        files.push_back(folder / ("gone" + std::to_string(i) + ".bmp"));
    ASSERT_TRUE(openArguments(*session, files).has_value());
    waitForFiles(*session);
    frames(4);
    EXPECT_EQ(red(), 50);
    EXPECT_EQ(session->asking.refused.size(), 300U);
    const std::string last = "refused:" + files.back().string();
    EXPECT_FALSE(places.items.at(last).visible);
    wheel(place("refused:" + files[2].string()), -1000);
    EXPECT_TRUE(places.items.at(last).visible);
    click("refused:close"); // is in sight all the time
    EXPECT_EQ(session->asking.dialog, Dialog::None);
}

TEST_F(Loads, MoreImagesThanASceneHasTexturesAreListed) {
    std::vector<fs::path> files;
    for (int i = 0; i < 70; ++i)
        files.push_back(bmp("good" + std::to_string(i) + ".bmp", static_cast<char>(i)));
    ASSERT_TRUE(openArguments(*session, files).has_value());
    waitForFiles(*session);
    frames(2);
    EXPECT_EQ(scene().textures.size(), maxTextures);
    ASSERT_EQ(session->asking.refused.size(), 6U);
    EXPECT_EQ(session->asking.refused.back().where, files.back().string());
}

TEST_F(Loads, SeveralDroppedImagesAreOneStepOfUndo) {
    const Scene before = scene();
    requestOpen(*session, {bmp("a.bmp", 10), folder / "gone.bmp", bmp("b.bmp", 20)});
    waitForFiles(*session);
    frames(2);
    EXPECT_EQ(red(), 10);
    ASSERT_EQ(scene().textures.size(), 2U);
    EXPECT_EQ(scene().textures[1].file, (folder / "b.bmp").string());
    EXPECT_EQ(session->asking.dialog, Dialog::Refused);
    key(key::escape);
    take(*session, Undo{});
    EXPECT_EQ(scene(), before);
    requestOpen(*session, {folder / "gone.bmp", folder / "away.bmp"});
    frames(3);
    EXPECT_EQ(session->asking.refused.size(), 2U);
    EXPECT_EQ(scene(), before);
}

TEST_F(Loads, ASceneThatIsDroppedWithImagesIsShownWithThem) {
    write("scene.json", R"({"version": 1, "textures": [{"wrapS": "GL_CLAMP"}]})");
    write("other.json", R"({"version": 1})");
    texture().wrapT = Wrap::Clamp;
    recordEdit(*session, "Wrap t");
    requestOpen(*session, {bmp("a.bmp", 10), folder / "scene.json", folder / "other.json"});
    EXPECT_EQ(session->asking.dialog, Dialog::Discard);
    frames(2);
    click("discard:drop");
    waitForFiles(*session);
    frames(2);
    EXPECT_EQ(session->document.file, folder / "scene.json");
    EXPECT_EQ(texture().wrapS, Wrap::Clamp);
    EXPECT_EQ(red(), 10);
    ASSERT_EQ(session->asking.refused.size(), 1U);
    EXPECT_EQ(session->asking.refused[0].where, (folder / "other.json").string());
}

TEST_F(Loads, TheBrowserShowsSmallPictures) {
    bmp("red.bmp", 50);
    key('I', {ctrl});
    ASSERT_EQ(session->asking.dialog, Dialog::OpenImage);
    enterFolder(states.dialogs.browser, folder.path());
    frames(3);
    framesUntil([&] { return has("thumbnail:red.bmp"); });
    doubleClickAt(place("entry:red.bmp"));
    waitForFiles(*session);
    EXPECT_EQ(session->asking.dialog, Dialog::None);
    EXPECT_EQ(red(), 50);
}

// What a scene doesn't use isn't read with it.
TEST_F(Loads, AFileThatAnEditBringsIntoUseIsRead) {
    (void)bmp("level.bmp", 50);
    write("scene.json", R"({"version": 1, "textures": [{"mipmaps": "generated",
        "levels": [{"source": "file", "file": "level.bmp"}, {"source": "file", "file": "missing.bmp"}]}]})");
    openNow("scene.json");
    ASSERT_EQ(scene().textures.size(), 1U);
    EXPECT_FALSE(session->document.images.holds("level.bmp"));
    scene().textures[0].mipmaps = MipPolicy::Given;
    recordEdit(*session, "Mipmaps");
    framesUntil([this] { return session->document.images.holds("level.bmp"); });
    framesUntil([this] { return session->document.loads.empty(); });
    EXPECT_THAT(session->look.notice.text, HasSubstr("missing.bmp"));
    session->look.notice = {};
    frames(3);
    EXPECT_TRUE(session->look.notice.text.empty()) << "it is said once";
    EXPECT_EQ(session->document.history.undoName(), "Mipmaps");
}

// With a pattern as its source a file is kept, but not read.
TEST_F(Loads, AFileThatUndoBringsIntoUseIsRead) {
    write("scene.json", R"({"version": 1, "textures": [{"source": "pattern", "file": "red.bmp"}]})");
    (void)bmp("red.bmp", 50);
    openNow("scene.json");
    frames(1); // the camera is fitted in it: what is undone is the edit alone
    scene().textures[0].source = SourceKind::File;
    recordEdit(*session, "Source");
    take(*session, Undo{}); // before it was read
    frames(1);
    EXPECT_TRUE(session->document.loads.empty());
    ASSERT_TRUE(session->document.history.canRedo());
    take(*session, Redo{});
    framesUntil([this] { return session->document.images.holds("red.bmp"); });
}

} // namespace
} // namespace texplorer::ui::loads_test
