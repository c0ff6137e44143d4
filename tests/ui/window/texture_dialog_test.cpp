#include "app/ui/files/texture_file.h"
#include "app/ui/widgets/keys.h"
#include "tests/support/temp_dir.h"
#include "tests/ui/workbench.h"
#include "texplorer/codec/texture_file.h"

#include <gmock/gmock.h>

namespace texplorer::ui::texture_dialog_test {
namespace {

using namespace test;

class TextureDialog : public Workbench {
protected:
    TextureDialog() {
        session->look.playback.playing = false;
        scene().textures.front().mipmaps = MipPolicy::Generated;
        openDialog();
    }

    void openDialog() {
        frames(2);
        click("menu:File");
        frames(2);
        click("menu:Save texture…");
        frames(3);
    }

    void choose(std::string_view list, std::string_view choice) {
        click(list);
        frames(2);
        click(choice);
        frames(2);
    }
};

TEST_F(TextureDialog, LeadsToAFile) {
    const TempDir folder;
    ASSERT_EQ(session->asking.dialog, Dialog::Texture);
    choose("texture:blocks", "texture:GL_COMPRESSED_RGBA_S3TC_DXT5_EXT");
    click("texture:best");
    click("texture:choose");
    frames(3);
    ASSERT_EQ(session->asking.dialog, Dialog::SaveTexture);
    EXPECT_EQ(session->saving.quality, EncodeQuality::Best);
    EXPECT_EQ(states.dialogs.browser.typed, "checker.dds");
    key('A', {ctrl});
    type((folder / "a").string());
    key(key::enter);
    frames(3);
    EXPECT_EQ(session->asking.dialog, Dialog::None);
    EXPECT_EQ(session->look.notice.text, "Written: " + (folder / "a.dds").string());
    const TextureImage read = loadTexture(folder / "a.dds").value();
    EXPECT_EQ(read.levels, 7);
    EXPECT_EQ(std::get<BlockImage>(read.surface(0, 0)).format, BlockFormat::Dxt5);
}

TEST_F(TextureDialog, NamesTheTexture) {
    EXPECT_TRUE(has("texture:which"));
}

TEST_F(TextureDialog, OffersTheLevelsOfAPicture) {
    click("texture:PNG");
    frames(2);
    click("texture:blocks");
    frames(2);
    EXPECT_FALSE(has("texture:none")) << "only DDS files have blocks";
    choose("texture:level", "texture:level 3");
    EXPECT_EQ(session->saving.level, 3);
    EXPECT_EQ(session->saving.blocks, SavedBlocks::AsTexture);
    EXPECT_EQ(savedLevels(*session).value().front().width, 8);
    click("texture:level");
    frames(2);
    key(key::escape);
    frames(2);
    EXPECT_FALSE(has("texture:level 3"));
    EXPECT_EQ(session->asking.dialog, Dialog::Texture) << "Escape closed the list";
    key(key::escape);
    frames(2);
    EXPECT_EQ(session->asking.dialog, Dialog::None);
}

TEST_F(TextureDialog, SaysWhatCantBe) {
    scene().textures.front().mipmaps = MipPolicy::Missing;
    frames(2);
    EXPECT_TRUE(has("texture:problem"));
    key(key::enter);
    click("texture:choose");
    frames(2);
    EXPECT_EQ(session->asking.dialog, Dialog::Texture);
    click("texture:cancel");
    frames(2);
    scene().textures.front() = {.source = SourceKind::File};
    openDialog();
    EXPECT_EQ(session->asking.dialog, Dialog::None) << "the item is disabled";
}

} // namespace
} // namespace texplorer::ui::texture_dialog_test
