#include "app/ui/files/program_file.h"
#include "tests/support/temp_dir.h"
#include "texplorer/codec/tga/tga.h"
#include "texplorer/files/file_io.h"

#include <gmock/gmock.h>

#include <latch>
#include <mutex>

namespace texplorer::ui::program_file_test {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* noBorder =
    "The program can't be written: textures[0].border: textures have no border in "
    "OpenGL 3.3's core profile.";

class ProgramFile : public testing::Test {
protected:
    std::string saved(emit::Flavour flavour, const std::filesystem::path& file) {
        session.asking.flavour = flavour;
        EXPECT_TRUE(saveProgram(session, file));
        const std::optional<FileNews> news = services.lend().writing->takeNews();
        said = news ? news->text.english() : std::string();
        return readText(file).value_or("");
    }

    const test::TempDir folder;
    ServicesAtOnce services;
    Session session{services.lend()};
    std::string said;
};

TEST_F(ProgramFile, IsTheProgramThatTexshotWrites) {
    for (const EnumRow& row : emit::flavourRows) {
        const auto flavour = static_cast<emit::Flavour>(row.value);
        const std::string name = programFileName(session.document);
        emit::TextureCodes codes;
        const emit::ProgramOptions options{.title = "scene", .source = name};
        const auto lines = emit::program(flavour, session.document.scene, {}, options, codes);
        EXPECT_EQ(saved(flavour, folder / name), textOf(lines.value(), false)) << row.name;
        EXPECT_EQ(said, "Written: " + (folder / name).string());
    }
}

TEST_F(ProgramFile, IsNamedForTheScene) {
    EXPECT_EQ(programFileName(session.document), "scene.c");
    session.document.suggested = "/somewhere/earth.texplorer.json";
    EXPECT_EQ(programFileName(session.document), "earth.c");
    EXPECT_THAT(describe(saveProgram(session, folder / "earth.html").error()),
                HasSubstr("ends with .c, found \"earth.html\""));
}

TEST_F(ProgramFile, NamesImagesFromItsOwnFolder) {
    std::filesystem::create_directory(folder / "images");
    Image image = Image::uninitialised(PixelFormat::Rgb8, 16, 16);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<std::byte>(i * 37 % 251);
    ASSERT_TRUE(writeFileAtomically(folder / "images" / "a.tga",
                                    encodeTga(textureOf(std::move(image), "TGA")).value()));
    session.document.images = ImageSource(folder.path());
    session.document.scene.textures[0].source = SourceKind::File;
    session.document.scene.textures[0].file = "images/a.tga";
    ASSERT_TRUE(session.document.images.load(session.document.scene));
    EXPECT_THAT(saved(emit::Flavour::Fixed, folder / "a.c"), HasSubstr("\"images/a.tga\""));
    std::filesystem::create_directory(folder / "other");
    EXPECT_THAT(saved(emit::Flavour::Fixed, folder / "other" / "a.c"),
                HasSubstr((folder / "images" / "a.tga").string()));
}

TEST_F(ProgramFile, WhatAFlavourCantSayIsOneSentence) {
    session.document.scene.textures[0].border = 1;
    EXPECT_EQ(saved(emit::Flavour::Glsl, folder / "a.c"), "");
    EXPECT_EQ(said, noBorder);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.c"));
}

// What is known at once is said before anybody chooses a file.
TEST_F(ProgramFile, IsNotAskedForWhereThereCanBeNone) {
    session.document.scene.textures[0].border = 1;
    askSaveProgram(session, emit::Flavour::Glsl);
    EXPECT_EQ(session.asking.dialog, Dialog::None);
    EXPECT_EQ(session.look.notice.text, noBorder);
    askSaveProgram(session, emit::Flavour::Fixed);
    EXPECT_EQ(session.asking.dialog, Dialog::SaveProgram);
}

TEST_F(ProgramFile, HasTheCallsThatAreListed) {
    constexpr const char* same = "GL_TEXTURE_WRAP_S, GL_REPEAT";
    EXPECT_THAT(saved(emit::Flavour::Fixed, folder / "a.c"), Not(HasSubstr(same)));
    session.window.allCalls = true;
    EXPECT_THAT(saved(emit::Flavour::Fixed, folder / "a.c"), HasSubstr(same));
}

// The window goes on, says how far it is, and gives it up.
TEST_F(ProgramFile, IsMadeBesideTheWindow) {
    session.document.scene.textures[0].compression = Compression::Cached;
    session.document.scene.textures[0].pattern = Pattern::Brick;
    std::latch begun(1);
    std::latch goOn(1);
    std::once_flag once;
    FileWriting beside(When::WhenReady, [&] {
        std::call_once(once, [&] {
            begun.count_down();
            goOn.wait();
        });
    });
    beside.write(programOrder(session, folder / "a.c"));
    begun.wait();
    ASSERT_TRUE(beside.progress());
    EXPECT_EQ(beside.progress()->pictures, 0U);
    beside.cancel();
    goOn.count_down();
    beside.write(programOrder(session, folder / "b.c"));
    beside.wait();
    EXPECT_THAT(beside.takeNews()->text, HasSubstr("b.c"));
    EXPECT_FALSE(std::filesystem::exists(folder / "a.c"));
}

TEST_F(ProgramFile, TellsHowFarItsTexturesAre) {
    Scene& scene = session.document.scene;
    scene.textures[0].compression = Compression::Cached;
    scene.textures[0].pattern = Pattern::Brick;
    scene.textures.push_back(scene.textures[0]);
    scene.textures[1].pattern = Pattern::Planet;
    const FileOrder order = programOrder(session, folder / "a.c");
    std::vector<float> shares;
    ASSERT_TRUE(order.make({.report = [&](float share) { shares.push_back(share); }}));
    EXPECT_TRUE(std::ranges::is_sorted(shares)) << "one textures's share after the other's";
    ASSERT_FALSE(shares.empty());
    EXPECT_FLOAT_EQ(shares.back(), 1);
    EXPECT_THAT(shares, testing::Contains(testing::AllOf(testing::Gt(0.01F), testing::Lt(0.5F))));
}

} // namespace
} // namespace texplorer::ui::program_file_test
