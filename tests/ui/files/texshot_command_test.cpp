#include "app/ui/files/scene_saving.h"
#include "app/ui/files/texshot_command.h"
#include "tests/support/temp_dir.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/params.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>

namespace texplorer::texshot_command_test {
namespace {

using namespace ui;
using testing::HasSubstr;

/// The words that a shell makes of a command line: printf gives each a line.
std::vector<std::string> wordsOf(const std::string& command) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(
        ::popen(("printf '%s\\n' " + command).c_str(), "r"), ::pclose);
    std::string text;
    std::array<char, 4096> buffer{};
    while (const std::size_t read = std::fread(buffer.data(), 1, buffer.size(), pipe.get()))
        text.append(buffer.data(), read);
    std::vector<std::string> words;
    for (std::size_t end = 0; (end = text.find('\n')) != std::string::npos; text.erase(0, end + 1))
        words.push_back(text.substr(0, end));
    return words;
}

/// What texshot makes of such words, as its scene_argument.cpp does it.
Scene sceneOf(const std::vector<std::string>& words) {
    Scene scene = defaultScene();
    if (words.size() > 2 && words[2].ends_with(".json"))
        scene = parseScene(readText(words[2]).value()).value();
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        if (words[i] != "--set")
            continue;
        const std::size_t equals = words[i + 1].find('=');
        EXPECT_TRUE(setParam(scene, words[i + 1].substr(0, equals), words[i + 1].substr(equals + 1)))
            << words[i + 1];
    }
    return scene;
}

class TexshotCommand : public testing::Test {
protected:
    [[nodiscard]] Scene& scene() { return session.document.scene; }
    [[nodiscard]] std::vector<std::string> words() const {
        return wordsOf(texshotCommand(session, {640, 480}).value());
    }

    ServicesAtOnce services;
    Session session{services.lend()};
};

TEST_F(TexshotCommand, LeadsToTheSceneFromTheStart) {
    scene().textures.front().minFilter = MinFilter::Nearest;
    scene().textures.front().source = SourceKind::File;
    scene().textures.front().file = "/pictures/it's a $HOME `brick`.png";
    scene().passes.front().units.front().envColor = {0.1F, 0.2F, 0.3F, 1};
    scene().models.front().name = "a; b";
    session.look.playback.time = 1.5;
    session.view.renderer = RendererKind::Reference;
    const std::vector<std::string> made = words();
    EXPECT_EQ(sceneOf(made), scene());
    const std::string line = texshotCommand(session, {640, 480}).value();
    EXPECT_THAT(line, testing::StartsWith("texshot shot --set "));
    EXPECT_THAT(line, HasSubstr(" --time 1.5 --renderer reference --size 640x480 -o scene.png"));
}

TEST_F(TexshotCommand, NamesTheFileAndWhatWasChangedSince) {
    const test::TempDir folder;
    const std::filesystem::path file = folder / "my scene.json";
    scene().textures.push_back({});
    ASSERT_TRUE(saveScene(session, file));
    scene().textures.back().wrapT = Wrap::MirroredRepeat;
    const std::vector<std::string> made = words();
    EXPECT_EQ(made.at(2), file);
    EXPECT_EQ(sceneOf(made), scene());
    EXPECT_EQ(made.back(), "my scene.png");
}

TEST_F(TexshotCommand, SaysWhatCannotBeSet) {
    scene().textures.push_back({});
    const Result<std::string> command = texshotCommand(session, {640, 480});
    ASSERT_FALSE(command);
    EXPECT_THAT(command.error().message, HasSubstr("save the scene"));
}

TEST_F(TexshotCommand, DrawsTheSheetToo) {
    scene().textures.front().wrapS = Wrap::Clamp;
    session.look.playback.time = 0.5;
    session.sheet.own =
        SheetAxes{SheetAxis{"textures[0].wrapT", "*"}, SheetAxis{"light.position", "0,0,1,0;1,0,0,0"}};
    const std::vector<std::string> made = wordsOf(sweepCommand(session).value());
    EXPECT_EQ(sceneOf(made), scene());
    EXPECT_THAT(made,
                testing::IsSupersetOf({"sweep", "textures[0].wrapT=*", "light.position=0,0,1,0;1,0,0,0"}));
    EXPECT_THAT(sweepCommand(session).value(),
                testing::EndsWith(" --time 0.5 --axis 'textures[0].wrapT=*' --axis "
                                  "'light.position=0,0,1,0;1,0,0,0' --renderer reference --size 320x200 "
                                  "-o scene-sheet.png"));
    session.sheet.labels = sheet::LabelKind::Words;
    session.view.anisotropy = reference::AnisotropyMethod::Ellipse;
    session.view.rho = reference::RhoMethod::Lower;
    EXPECT_THAT(sweepCommand(session).value(),
                HasSubstr(" --anisotropy ellipse --rho lower --labels words --size "));
}

TEST_F(TexshotCommand, DrawsTheReferenceAsTheWindowDoes) {
    session.view.anisotropy = reference::AnisotropyMethod::Ellipse;
    session.view.rho = reference::RhoMethod::Upper;
    EXPECT_THAT(texshotCommand(session, {64, 48}).value(), testing::Not(HasSubstr("--rho")));
    session.view.renderer = RendererKind::Reference;
    EXPECT_THAT(texshotCommand(session, {64, 48}).value(),
                HasSubstr(" --renderer reference --anisotropy ellipse --rho upper --size 64x48"));
}

TEST_F(TexshotCommand, OfASheetSaysWhatIsWrongWithIt) {
    session.sheet.own = SheetAxes{SheetAxis{"textures[3].wrapT", "*"}, SheetAxis{"light.position", "*"}};
    EXPECT_THAT(sweepCommand(session).error().where.text(), HasSubstr("textures[3]"));
}

} // namespace
} // namespace texplorer::texshot_command_test
