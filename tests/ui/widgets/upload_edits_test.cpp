// The switch of a custom upload, which changes nothing that is seen.

#include "tests/ui/workbench.h"
#include "texplorer/image/convert.h"
#include "texplorer/texture/texture_levels.h"

#include <array>
#include <cstdint>
#include <vector>

namespace texplorer::ui::upload_edits_test {
namespace {

using namespace test;

class UploadEdits : public Workbench {
protected:
    /// 15 texels wide, so that tight rows are no multiple of 4 bytes.
    void showFile() {
        Image image = Image::uninitialised(PixelFormat::Rgb8, 15, 15);
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            image.pixels[i] = static_cast<std::byte>(i * 7);
        session->document.images.put("odd.png", std::move(image));
        texture().source = SourceKind::File;
        texture().file = "odd.png";
        frames(3);
    }
    void openGroup() {
        session->out.wantedSection = Section::Texture;
        frames(3);
        scrollTo("textures[0].upload#group");
        click("textures[0].upload#group");
        frames(2);
    }
    void turnOn() {
        openGroup();
        scrollTo("textures[0].upload.custom");
        click("textures[0].upload.custom");
        frames(2);
    }
    /// The colours of all texels, level by level.
    [[nodiscard]] std::vector<std::array<std::uint8_t, 4>> levels() {
        std::vector<std::array<std::uint8_t, 4>> colors;
        const TexturePictures pictures = session->document.images.picturesOf(texture());
        const Result<TextureLevels> made = prepareLevels(texture(), pictures);
        for (const TextureLevel& level : made->levels) {
            const Image& image = std::get<Image>(*level.surface);
            for (int y = 0; y < image.height; ++y) {
                for (int x = 0; x < image.width; ++x)
                    colors.push_back(rgbaOf(image.format, image.at(x, y).data()));
            }
        }
        return colors;
    }
};

TEST_F(UploadEdits, TheGroupIsClosedAtFirst) {
    session->out.wantedSection = Section::Texture;
    frames(3);
    EXPECT_TRUE(has("textures[0].upload#group"));
    EXPECT_FALSE(has("textures[0].upload.custom"));
    session->out.wantedParam = "textures[0].upload.alignment";
    frames(3);
    EXPECT_TRUE(has("textures[0].upload.alignment")) << "who asks for a parameter finds it";
}

TEST_F(UploadEdits, TurningItOnIsOneEditThatKeepsThePicture) {
    showFile();
    const auto before = levels();
    const std::size_t step = session->document.history.position();
    turnOn();
    const Upload& upload = texture().upload;
    EXPECT_TRUE(upload.custom);
    EXPECT_EQ(upload.format, TransferFormat::Rgb);
    EXPECT_EQ(upload.alignment, 1) << "45 bytes are no multiple of 4";
    EXPECT_EQ(session->document.history.position(), step + 1);
    EXPECT_EQ(levels(), before);
    key('Z', {ctrl});
    EXPECT_EQ(texture().upload, Upload{});
}

// Rows of 4 RGB pixels are 12 bytes, a multiple of 4, but those of the level of 2 pixels are 6.
TEST_F(UploadEdits, SmallLevelsFitAsWell) {
    session->document.images.put("even.png", Image{PixelFormat::Rgb8, 4, 4, 1, Bytes(48, std::byte{9})});
    texture().source = SourceKind::File;
    texture().file = "even.png";
    texture().mipmaps = MipPolicy::Generated;
    frames(3);
    const auto before = levels();
    turnOn();
    EXPECT_EQ(texture().upload.alignment, 1);
    EXPECT_EQ(levels(), before);
}

TEST_F(UploadEdits, AStepThatAddsAlphaIsInTheMemory) {
    showFile();
    texture().preparation = {{.op = ImageOp::LuminanceToAlpha}};
    frames(3);
    const auto before = levels();
    turnOn();
    EXPECT_EQ(texture().upload.format, TransferFormat::Rgba);
    EXPECT_EQ(levels(), before);
}

} // namespace
} // namespace texplorer::ui::upload_edits_test
