#include "app/ui/files/inspected_file.h"
#include "app/ui/files/scene_files.h"
#include "tests/support/raw_file.h"
#include "tests/support/small_bmp.h"
#include "tests/support/temp_dir.h"
#include "tests/ui/edits.h"
#include "tests/ui/workbench.h"

namespace texplorer::ui::file_tab_test {
namespace {

using namespace test;

class FileTab : public Workbench {
protected:
    /// A file with a made-up anatomy: a header of two fields, a gap, and 1000 bytes of pixels.
    void showMadeUp() {
        auto file = std::make_shared<DissectedFile>();
        file->anatomy.format = "Made up";
        file->anatomy.fields = {{0, 4, "header", "", "", "", 0},
                                {0, 2, "magic", "BM", "always BM", "", 1},
                                {2, 2, "bits", "33", "bits a pixel", "expected 24 or 32", 1},
                                {8, 1000, "pixels", "", "bottom row first", "", 0}};
        file->bytes.resize(1008);
        for (std::size_t i = 0; i < file->bytes.size(); ++i)
            file->bytes[i] = static_cast<std::byte>(i);
        file->fileBytes = file->bytes.size();
        file->problem = "Made up: the pixels are bad";
        InspectedFile& view = session->look.fileView;
        view.chosen = view.shown = "/made/up.img";
        receiveInspected(*session, ImageLoader::Content(std::shared_ptr<const DissectedFile>(file)));
        click("tab:File");
    }
    /// Where a byte is in the bytes, in its hexadecimal form.
    ImVec2 byteAt(std::size_t offset) {
        const std::size_t perLine = [&] {
            std::size_t width = 4;
            while (!has("hex:" + std::to_string(width)))
                width *= 2;
            return width;
        }();
        const std::string row = "hex:" + std::to_string(offset / perLine * perLine);
        const WidgetPlaces::Item& item = places.items.at(row);
        const float letter = (item.right - item.left) / static_cast<float>(4 + 3 + perLine * 4);
        const auto column = static_cast<float>(offset % perLine);
        return {item.left + letter * (4 + 2 + column * 3 + 1), (item.top + item.bottom) / 2};
    }

    texplorer::test::TempDir folder;
};

// A scene may name such a file. Shown, each of its bytes has six letters; Dear ImGui's lists end at 16,000.
TEST_F(FileTab, ANameOfControlCharactersIsBearable) {
    texture().source = SourceKind::File;
    texture().file = std::string(4096, '\x01');
    click("tab:File");
    frames(3);
    EXPECT_TRUE(session->look.fileView.content == nullptr);
    expectSoundFrame();
    showTab(session->settings.workspace, Tab::Memory);
    open("Texture");
    scrollTo("textures[0].file");
    moveTo(place("textures[0].file"));
    frames(2);
    expectSoundFrame();
}

TEST_F(FileTab, ShowsTheFileOfTheBoundTexture) {
    texplorer::test::writeRaw(folder / "red.bmp", texplorer::test::onePixelBmp({0, 0, 50}));
    click("tab:File");
    EXPECT_TRUE(has("file:none")) << "a built-in pattern has none";
    importImage(*session, folder / "red.bmp");
    frames(3);
    EXPECT_TRUE(has("file:name"));
    EXPECT_TRUE(has("hex:0"));
    EXPECT_FALSE(has("file:problem"));
    ASSERT_NE(session->look.fileView.content, nullptr);
    EXPECT_EQ(session->look.fileView.content->fileBytes, 58U);
    EXPECT_FALSE(has("file:stored")) << "nothing was drawn";
    (void)picture();
    EXPECT_TRUE(has("file:stored"));
    take(*session, Undo{});
    frames(2);
    EXPECT_TRUE(has("file:none"));
}

TEST_F(FileTab, AFieldUnderTheMouseLightsItsBytesWhichAreDrawnByTheLine) {
    showMadeUp();
    EXPECT_TRUE(has("file:problem"));
    moveTo(place("field:bits"));
    EXPECT_EQ(states.details.file.hovered, 2U);
    for (const auto& [offset, field] : {std::pair<std::size_t, std::optional<std::size_t>>{0, 1},
                                        {1, 1},
                                        {2, 2},
                                        {3, 2},
                                        {5, std::nullopt},
                                        {9, 3}}) {
        moveTo(byteAt(offset));
        EXPECT_EQ(states.details.file.hovered, field) << offset;
    }
    moveTo({5, 5});
    EXPECT_EQ(states.details.file.hovered, std::nullopt);
    EXPECT_TRUE(has("hex:0"));
    EXPECT_FALSE(has("hex:992")) << "what is out of sight costs nothing";
    wheel(place("hex:0"), -200);
    EXPECT_TRUE(has("hex:992"));
    EXPECT_FALSE(has("hex:0"));
    click("field:header"); // brings its bytes into sight
    EXPECT_TRUE(has("hex:0"));
}

TEST_F(FileTab, AFileThatHasGoneIsSaid) {
    lookInto(*session, folder / "gone.bmp");
    frames(4);
    EXPECT_FALSE(session->look.fileView.problem.empty());
    EXPECT_TRUE(has("file:back"));
}

} // namespace
} // namespace texplorer::ui::file_tab_test
