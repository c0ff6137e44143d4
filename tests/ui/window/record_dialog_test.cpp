#include "app/ui/files/recording_file.h"
#include "app/ui/files/texshot_command.h"
#include "app/ui/widgets/keys.h"
#include "tests/support/temp_dir.h"
#include "tests/ui/workbench.h"

#include <gmock/gmock.h>

namespace texplorer::ui::record_dialog_test {
namespace {

using namespace test;

class RecordDialog : public Workbench {
protected:
    RecordDialog() {
        session->look.playback.playing = false;
        session->recording.width = 32;
        session->recording.height = 20;
        session->recording.perSecond = 4;
        click("menu:File");
        frames(2);
        click("menu:Record animation…");
        frames(3);
    }
};

TEST_F(RecordDialog, LeadsToAFile) {
    const TempDir folder;
    ASSERT_EQ(session->asking.dialog, Dialog::Record);
    EXPECT_TRUE(has("record:still")) << "nothing moves yet";
    click("record:GIF");
    click("record:choose");
    frames(3);
    ASSERT_EQ(session->asking.dialog, Dialog::SaveRecording);
    EXPECT_EQ(states.dialogs.browser.typed, "scene.gif");
    key('A', {ctrl});
    type((folder / "a").string());
    key(key::enter);
    frames(3);
    EXPECT_EQ(session->asking.dialog, Dialog::None);
    EXPECT_EQ(session->look.notice.text, "Written: " + (folder / "a.gif").string());
    EXPECT_TRUE(std::filesystem::exists(folder / "a.gif"));
}

TEST_F(RecordDialog, KnowsHowLongTheKeyFramesAre) {
    scene().timeline.keys = {{0, "view.azimuth", "0"}, {2.5F, "view.azimuth", "90"}};
    frames(2);
    EXPECT_FALSE(has("record:still"));
    doubleClickAt(place("record:seconds"));
    key('A', {ctrl});
    type("1.5");
    key(key::enter);
    frames(2);
    EXPECT_EQ(session->asking.dialog, Dialog::Record) << "Enter ended the typing";
    EXPECT_EQ(recordedSeconds(*session), 1.5F);
    click("record:as keys");
    frames(2);
    EXPECT_EQ(recordedSeconds(*session), 2.5F);
}

TEST_F(RecordDialog, SaysWhatCantBe) {
    click("record:GIF");
    session->recording.perSecond = 80;
    frames(2);
    EXPECT_TRUE(has("record:problem"));
    click("record:choose");
    frames(2);
    EXPECT_EQ(session->asking.dialog, Dialog::Record);
    key(key::escape);
    frames(2);
    EXPECT_EQ(session->asking.dialog, Dialog::None);
}

TEST_F(RecordDialog, CopiesItsCommand) {
    click("record:copy");
    EXPECT_STREQ(ImGui::GetClipboardText(), animateCommand(*session).value().c_str());
    EXPECT_THAT(ImGui::GetClipboardText(),
                testing::AllOf(testing::StartsWith("texshot animate"),
                               testing::EndsWith(" --fps 4 --seconds 4 --renderer reference --size 32x20 -o "
                                                 "scene.webp")));
}

} // namespace
} // namespace texplorer::ui::record_dialog_test
