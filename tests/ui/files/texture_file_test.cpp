#include "app/ui/files/texture_file.h"
#include "tests/support/temp_dir.h"
#include "texplorer/codec/texture_file.h"
#include "texplorer/files/file_io.h"
#include "texplorer/s3tc/surface_pixels.h"

#include <gmock/gmock.h>

#include <stop_token>

namespace texplorer::ui::texture_file_test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

class TextureFile : public testing::Test {
protected:
    TextureFile() {
        texture().mipmaps = MipPolicy::Generated;
        session.saving = {};
    }

    Texture& texture() { return session.document.scene.textures.front(); }

    /// Writes it and returns what the window says.
    std::string said(const std::string& name) {
        if (const Result<void> asked = saveTextureFile(session, folder / name); !asked)
            return asked.error().message;
        return session.services.writing->takeNews().value().text;
    }

    test::TempDir folder;
    ServicesAtOnce services;
    Session session{services.lend()};
};

TEST_F(TextureFile, HasTheLevelsOfTheBoundTexture) {
    EXPECT_THAT(said("a.dds"), EndsWith("a.dds"));
    const TextureImage read = loadTexture(folder / "a.dds").value();
    const Image base = toImage(read.surface(0, 0));
    EXPECT_EQ(base.width, widthOf(boundImage(session)->surface(0, 0)));
    EXPECT_EQ(read.levels, 7) << "64 texels";
    Image upright = toImage(boundImage(session)->surface(0, 0));
    flipVertically(upright); // a DDS file begins with the top row
    EXPECT_EQ(base.pixels, upright.pixels);
}

TEST_F(TextureFile, IsCompressedWhereTheUserChoosesSo) {
    session.saving.blocks = SavedBlocks::Chosen;
    session.saving.format = BlockFormat::Dxt3;
    EXPECT_THAT(said("a.dds"), EndsWith("a.dds"));
    const TextureImage read = loadTexture(folder / "a.dds").value();
    EXPECT_EQ(std::get<BlockImage>(read.surface(0, 6)).format, BlockFormat::Dxt3);
}

TEST_F(TextureFile, SaysWhatItLacks) {
    session.saving.file = "BMP";
    session.saving.level = 2;
    EXPECT_THAT(said("a.bmp"), EndsWith("a.bmp. Lost: 6 of the texture's 7 mip levels."));
    EXPECT_EQ(widthOf(loadTexture(folder / "a.bmp").value().surface(0, 0)), 16);
    EXPECT_THAT(said("a.png"), HasSubstr("expected a name that ends with .bmp"));
}

TEST_F(TextureFile, IsTheLightsViewOfTheSelectedTime) {
    texture().source = SourceKind::LightDepth;
    texture().depthSize = 32;
    texture().internalFormat = InternalFormat::DepthComponent24;
    session.saving.file = "PNG";
    EXPECT_THAT(said("a.png"), HasSubstr("24 bits a component become 8"));
    const Image read = toImage(loadTexture(folder / "a.png").value().surface(0, 0));
    EXPECT_EQ(read.width, 32);
    EXPECT_TRUE(std::ranges::any_of(read.pixels, [](std::byte depth) { return depth != std::byte{255}; }))
        << "the models";
}

TEST_F(TextureFile, HasANameOfItsOwn) {
    EXPECT_EQ(textureFileName(session), "checker.dds");
    texture().source = SourceKind::File;
    texture().file = "folder/earth.PNG";
    EXPECT_EQ(textureFileName(session), "earth.dds");
    session.saving.file = "PNG";
    EXPECT_EQ(textureFileName(session), "earth-texture.png") << "not the image that the scene reads";
}

TEST_F(TextureFile, IsRefusedWithTheReason) {
    EXPECT_EQ(textureRefusal(session), Sentence());
    texture().mipmaps = MipPolicy::Missing;
    EXPECT_THAT(said("a.dds"), HasSubstr("a DDS file has all levels"));
    texture().source = SourceKind::File;
    texture().file = "gone.png";
    EXPECT_EQ(textureRefusal(session).english(), "Its image is not loaded.");
    session.document.scene.textures.clear();
    EXPECT_EQ(textureRefusal(session).english(), "No texture is bound to the selected unit.");
    EXPECT_FALSE(std::filesystem::exists(folder / "a.dds"));
}

TEST_F(TextureFile, LeavesTheOldFileWhereItFailsOrIsCancelled) {
    const std::string old = "old";
    ASSERT_TRUE(writeFileAtomically(folder / "a.dds", viewBytes(old)));
    const std::optional<FileFingerprint> replaces = fingerprintOf(folder / "a.dds");
    std::stop_source stop;
    stop.request_stop();
    FileWriting stopped(When::AtOnce, {}, {.stop = stop.get_token()});
    EXPECT_TRUE(stopped.writeAs(textureOrder(session, folder / "a.dds").value(), ".dds", replaces));
    EXPECT_FALSE(stopped.takeNews());

    texture().file = "cube.png";
    texture().source = SourceKind::File;
    session.document.images.put("cube.png", Image::uninitialised(PixelFormat::Rgb8, 3, 2));
    session.document.scene.passes.front().units.front().target = Target::CubeMap; // whose faces are square
    ASSERT_TRUE(saveTextureFile(session, folder / "a.dds", replaces));
    EXPECT_THAT(session.services.writing->takeNews().value().text.english(), HasSubstr("can't be written"));
    EXPECT_EQ(readFile(folder / "a.dds").value().size(), old.size());

    texture() = {};
    session.document.scene.passes.front().units.front().target = Target::Texture2D;
    ASSERT_TRUE(saveTextureFile(session, folder / "a.dds", replaces));
    EXPECT_TRUE(session.services.writing->takeNews().value().isGood);
    EXPECT_EQ(readFile(folder / "a.dds").value().size(), 128U + 64U * 64U * 4U);
}

} // namespace
} // namespace texplorer::ui::texture_file_test
