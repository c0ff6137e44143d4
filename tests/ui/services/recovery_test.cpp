// Unsaved work of a window that crashed: kept while the user edits, and offered by the next window.

#include "app/ui/files/scene_files.h"
#include "app/ui/files/scene_saving.h"
#include "app/ui/widgets/keys.h"
#include "tests/support/no_threads.h"
#include "tests/support/small_bmp.h"
#include "tests/support/temp_dir.h"
#include "tests/ui/edits.h"
#include "tests/ui/workbench.h"
#include "texplorer/files/file_io.h"
#include "texplorer/image/texture_image.h"

#include <gmock/gmock.h>

#include <fstream>
#include <mutex>

namespace texplorer::ui::recovery_test {
namespace {

using namespace test;

namespace fs = std::filesystem;
using namespace std::chrono_literals;

class Restoring : public Workbench {
protected:
    /// Opens a window, which offers earlier unsaved work. Only `flush` writes.
    void window() {
        shut();
        start(defaultScene());
        unsaved.emplace(folder, std::function<void()>{}, 24h);
        session->services.unsaved = &*unsaved;
        frames(3);
    }
    void edit(float shininess) {
        scene().material.shininess = shininess;
        recordEdit(*session, "Shininess");
        frames(1);
    }
    bool flush() { return unsaved->autosave.flush().has_value(); }
    /// Opens a window with unsaved work that is written.
    void windowWithWork(float shininess = 77) {
        window();
        edit(shininess);
        ASSERT_TRUE(flush());
    }
    void shut() {
        session.reset();
        unsaved.reset();
    }
    [[nodiscard]] std::size_t drafts() const {
        std::size_t count = 0;
        if (fs::exists(folder))
            for (const fs::directory_entry& each : fs::directory_iterator(folder))
                count += each.path().extension() == ".scene" ? 1U : 0U;
        return count;
    }

    texplorer::test::TempDir parent;
    fs::path folder = parent / "unsaved";
    std::optional<UnsavedWork> unsaved;
};

TEST_F(Restoring, WithoutAThreadThePictureIsThereAtOnce) {
    windowWithWork();
    shut();
    const texplorer::test::NoThreads none;
    const Recovery recovery(folder);
    ASSERT_EQ(recovery.offers().size(), 1U);
    ASSERT_TRUE(recovery.picture());
    EXPECT_EQ(recovery.picture()->width, 320);
}

TEST_F(Restoring, ADraftWhoseLockCannotBeOpenedIsSaidAndStays) {
    windowWithWork();
    shut();
    std::vector<fs::path> locks;
    for (const fs::directory_entry& each : fs::directory_iterator(folder))
        if (each.path().extension() == ".lock")
            locks.push_back(each.path());
    for (const fs::path& lock : locks) {
        fs::remove(lock);
        fs::create_symlink(parent / "nowhere", lock);
    }
    window();
    ASSERT_EQ(unsaved->recovery.offers().size(), 1U);
    const Recovery::Offer& offer = unsaved->recovery.offers().front();
    ASSERT_FALSE(offer.draft);
    EXPECT_THAT(offer.draft.error().message, testing::HasSubstr("can't be locked: "));
    unsaved->recovery.discard(); // this window does not own it
    EXPECT_EQ(drafts(), 1U);
}

TEST_F(Restoring, NothingIsOfferedWhereNothingWasLost) {
    window();
    EXPECT_EQ(session->asking.dialog, Dialog::None);
    scene().view.azimuth += 10; // looking around in an unedited scene is not an edit
    recordEdit(*session, "Orbit");
    frames(1);
    EXPECT_TRUE(flush());
    EXPECT_EQ(drafts(), 0U);
}

TEST_F(Restoring, WhatWasEditedComesBack) {
    windowWithWork();
    const Scene work = scene();
    ASSERT_EQ(drafts(), 1U);

    window();
    EXPECT_EQ(session->asking.dialog, Dialog::Restore);
    EXPECT_TRUE(has("restore:name"));
    EXPECT_NE(scene(), work);
    click("restore:restore");
    EXPECT_EQ(session->asking.dialog, Dialog::None);
    EXPECT_EQ(scene(), work) << "camera and all";
    EXPECT_TRUE(isDirty(session->document));
    EXPECT_EQ(drafts(), 1U) << "it is still not saved";

    edit(78);
    ASSERT_TRUE(flush());
    EXPECT_EQ(drafts(), 1U) << "and has one draft";
    ASSERT_TRUE(saveScene(*session, parent / "saved.json"));
    frames(1);
    ASSERT_TRUE(flush());
    EXPECT_EQ(drafts(), 0U);
    window();
    EXPECT_EQ(session->asking.dialog, Dialog::None);
}

TEST_F(Restoring, ItsPictureIsDrawn) {
    windowWithWork();
    window();
    while (!unsaved->recovery.picture()) // if it never comes, the test times out
        std::this_thread::yield();
    frames(1);
    EXPECT_TRUE(has("restore:picture"));
    const Image& image = *unsaved->recovery.picture();
    EXPECT_NE(image.at(image.width / 3, image.height / 2)[0], image.at(0, 0)[0]) << "a lit cube";
    (void)picture();
}

TEST_F(Restoring, FilesAndTheirImagesAreFoundAgain) {
    const auto write = [](const fs::path& path, std::string_view text) {
        ASSERT_TRUE(writeFileAtomically(path, viewBytes(text)));
    };
    fs::create_directory(parent / "pictures");
    write(parent / "pictures" / "red.bmp", texplorer::test::onePixelBmp({0, 0, 99}));
    write(
        parent / "scene.json",
        R"({"version": 1, "view": {"azimuth": 5}, "textures": [{"source": "file", "file": "pictures/red.bmp"}]})");
    window();
    ASSERT_TRUE(openScene(*session, parent / "scene.json"));
    frames(1);
    edit(5);
    ASSERT_TRUE(flush());

    window();
    click("restore:restore");
    EXPECT_EQ(session->document.file, parent / "scene.json");
    EXPECT_EQ(scene().textures[0].file, "pictures/red.bmp");
    ASSERT_NE(session->document.images.find(scene().textures[0]), nullptr);
    EXPECT_TRUE(isDirty(session->document));
    edit(defaultScene().material.shininess); // as it is in the file
    EXPECT_FALSE(isDirty(session->document));
    ASSERT_TRUE(flush());
    EXPECT_EQ(drafts(), 0U);
}

TEST_F(Restoring, AnImageThatIsGoneIsSaidAndTheWorkIsThere) {
    window();
    texture().source = SourceKind::File;
    texture().file = (parent / "gone.bmp").string();
    edit(6);
    ASSERT_TRUE(flush());
    window();
    click("restore:restore");
    frames(2);
    EXPECT_EQ(scene().material.shininess, 6);
    EXPECT_EQ(session->asking.dialog, Dialog::Refused);
    EXPECT_TRUE(has("refused:" + (parent / "gone.bmp").string()));
}

TEST_F(Restoring, DiscardForgetsItAndLaterDoesNot) {
    windowWithWork(1);
    window();
    key(key::escape);
    EXPECT_EQ(session->asking.dialog, Dialog::None);
    frames(2);
    EXPECT_EQ(session->asking.dialog, Dialog::None) << "not again in this window";
    window();
    ASSERT_EQ(session->asking.dialog, Dialog::Restore);
    click("restore:discard");
    EXPECT_EQ(drafts(), 0U);
    EXPECT_EQ(session->asking.dialog, Dialog::None);
    EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(Restoring, SeveralAreOfferedOneAfterTheOther) {
    for (const float shininess : {1.0F, 2.0F, 3.0F}) {
        Autosave autosave(folder, {}, 24h);
        Scene work = defaultScene();
        work.material.shininess = shininess;
        autosave.keep({}, {}, work);
        ASSERT_TRUE(autosave.flush());
    }
    window();
    EXPECT_EQ(unsaved->recovery.offers().size(), 3U);
    click("restore:discard");
    ASSERT_EQ(session->asking.dialog, Dialog::Restore);
    click("restore:restore");
    EXPECT_EQ(session->asking.dialog, Dialog::None);
    window();
    EXPECT_EQ(drafts(), 2U);
    EXPECT_EQ(unsaved->recovery.offers().size(), 2U) << "the one that was restored was not saved";
}

TEST_F(Restoring, ADamagedDraftIsASentence) {
    windowWithWork(1);
    shut();
    for (const fs::directory_entry& each : fs::directory_iterator(folder))
        std::ofstream(each.path()) << "\x7F"
                                      "ELF";
    window();
    ASSERT_EQ(session->asking.dialog, Dialog::Restore);
    EXPECT_TRUE(has("restore:error"));
    EXPECT_FALSE(has("restore:restore"));
    key(key::enter); // has no meaning here
    EXPECT_EQ(session->asking.dialog, Dialog::Restore);
    click("restore:discard");
    EXPECT_EQ(drafts(), 0U);
}

TEST_F(Restoring, AWindowBesideThisOneKeepsItsOwn) {
    windowWithWork(1);
    const Recovery other(folder);
    EXPECT_TRUE(other.offers().empty());
}

TEST_F(Restoring, WithoutAFolderItIsSaidOnce) {
    std::ofstream(parent / "file") << "x";
    folder = parent / "file" / "unsaved";
    window();
    edit(1);
    EXPECT_FALSE(flush());
    frames(2);
    EXPECT_TRUE(has("notice"));
    EXPECT_EQ(session->asking.dialog, Dialog::None);
    session->look.notice = {};
    edit(2);
    EXPECT_FALSE(flush());
    frames(2);
    EXPECT_FALSE(has("notice"));
}

} // namespace
} // namespace texplorer::ui::recovery_test
