// The window in a host as bare as a browser.

#include "app/stage/given_files.h"
#include "app/stage/messages.h"
#include "app/stage/spoken.h"
#include "app/ui/files/address.h"
#include "app/ui/files/asking.h"
#include "app/ui/files/lessons.h"
#include "app/ui/files/scene_files.h"
#include "app/ui/widgets/widget_places.h"
#include "tests/stage/bare_host.h"
#include "tests/stage/no_files.h"
#include "tests/support/no_threads.h"
#include "tests/support/small_bmp.h"
#include "texplorer/files/file_io.h"
#include "texplorer/reference/draw.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/storage/scene_link.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <thread>

namespace texplorer::stage::bare_host_test {
namespace {

using testing::ElementsAre;
using testing::Gt;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr Surface wide{{1280, 800}, {1280, 800}};
constexpr int control = 341;

NamedFile named(std::string name, std::string_view content) {
    const ByteView bytes = viewBytes(content);
    return {std::move(name), {bytes.begin(), bytes.end()}};
}

const std::string red = test::onePixelBmp(std::string("\x00\x00\xff", 3));
const std::string blue = test::onePixelBmp(std::string("\xff\x00\x00", 3));

/// The names of files that are not fonts, which a window looks for and does without.
std::vector<std::string> besidesFonts(std::vector<std::string> files) {
    std::erase_if(files, [](const std::string& file) { return file.starts_with("/usr/share/fonts/"); });
    return files;
}

class BareHostTest : public testing::Test {
protected:
    BareHostTest() { host.run(); }
    void TearDown() override {
        EXPECT_THAT(besidesFonts(files.attempts), IsEmpty());
        EXPECT_EQ(host.graphics.refusals, 0) << "renderers that were not offered";
    }

    [[nodiscard]] PointerMoved at(std::string_view name) const {
        const auto found = places.items.find(name);
        if (found == places.items.end()) {
            ADD_FAILURE() << name << " is not in sight";
            return {};
        }
        const ui::WidgetPlaces::Item& item = found->second;
        return {(item.left + item.right) / 2, (item.top + item.bottom) / 2};
    }
    void click(std::string_view name) {
        host.run({at(name), ButtonChanged{0, true}, ButtonChanged{0, false}});
    }
    void press(int key, const Modifiers& held = {.control = true}) {
        using Kind = KeyChanged::Kind;
        if (held.control)
            host.run({KeyChanged{Kind::Press, control, held}});
        host.run({KeyChanged{Kind::Press, key, held}, KeyChanged{Kind::Release, key, held}});
        if (held.control)
            host.run({KeyChanged{Kind::Release, control}});
    }
    [[nodiscard]] const Scene& scene() const { return host.session.document.scene; }
    [[nodiscard]] const Texture& texture() const { return *ui::boundTexture(host.session); }

    test::NoThreads threads;
    NoFiles files;
    ui::WidgetPlaces places;
    BareHost host{wide};
};

TEST_F(BareHostTest, TheWindowOpensWithThePictureOfTheReferenceAndSleeps) {
    EXPECT_THAT(host.last.title, HasSubstr("Untitled"));
    EXPECT_EQ(host.last.wake, std::nullopt);
    EXPECT_THAT(host.graphics.vertices, Gt(1000U)) << "panels";
    const std::shared_ptr<const Image> shown = host.graphics.largest();
    ASSERT_TRUE(shown);
    const auto expected =
        reference::drawReference({scene(), host.session.document.images, 0, shown->width, shown->height});
    ASSERT_TRUE(expected);
    EXPECT_EQ(*shown, expected->image);
    EXPECT_EQ(host.session.view.renderer, RendererKind::Reference);
    EXPECT_THAT(host.loop.problems(), IsEmpty());
}

TEST_F(BareHostTest, AChoiceChangesThePictureAndUndoTakesItBack) {
    const Image before = *host.graphics.largest();
    click("textures[0].wrapS=GL_CLAMP");
    EXPECT_EQ(texture().wrapS, Wrap::Clamp);
    EXPECT_NE(*host.graphics.largest(), before);
    host.run({at("view")});
    press('Z');
    EXPECT_EQ(texture().wrapS, Wrap::Repeat);
    EXPECT_EQ(*host.graphics.largest(), before);
    EXPECT_EQ(host.last.wake, std::nullopt);
}

TEST_F(BareHostTest, ADroppedImageBecomesATexture) {
    const Image before = *host.graphics.largest();
    host.run({FilesGiven{{named("red.bmp", red)}}});
    EXPECT_EQ(texture().source, SourceKind::File);
    EXPECT_EQ(texture().file, "red.bmp");
    EXPECT_NE(*host.graphics.largest(), before);
    EXPECT_THAT(host.loop.problems(), IsEmpty());
    EXPECT_EQ(host.session.look.notice.text, "");
    press('Z');
    EXPECT_EQ(*host.graphics.largest(), before) << "it is one undo step";
}

TEST_F(BareHostTest, AnotherImageOfTheSameNameGetsAnotherOne) {
    host.run({FilesGiven{{named("image.bmp", red)}}});
    host.run({FilesGiven{{named("image.bmp", red)}}});
    EXPECT_EQ(texture().file, "image.bmp");
    host.run({FilesGiven{{named("image.bmp", blue)}}});
    EXPECT_EQ(texture().file, "image-2.bmp");
    host.run({FilesGiven{{named("../../image-3.bmp", blue)}}});
    EXPECT_EQ(texture().file, "image-3.bmp") << "names have no folder";
}

TEST_F(BareHostTest, AFileThatChangesIsDrawnAgainWithoutAnUndoStep) {
    host.run({FilesGiven{{named("image.bmp", red)}}});
    const Image before = *host.graphics.largest();
    const Bytes first = named("image.bmp", red).bytes;
    const Bytes second = named("image.bmp", blue).bytes;
    EXPECT_FALSE(replaceGivenFile(host.session, second, first)) << "no file has this content";
    EXPECT_TRUE(replaceGivenFile(host.session, first, second));
    host.run({Refresh{}});
    EXPECT_EQ(texture().file, "image.bmp");
    EXPECT_NE(*host.graphics.largest(), before);
    EXPECT_FALSE(replaceGivenFile(host.session, second, Bytes(second.begin(), second.begin() + 30)));
    host.run({Refresh{}});
    EXPECT_THAT(host.session.look.notice.text, HasSubstr("image.bmp: has changed and can't be read"));
    EXPECT_TRUE(replaceGivenFile(host.session, second, first)) << "the old image has stayed";
    host.run({Refresh{}});
    EXPECT_EQ(*host.graphics.largest(), before);
    press('Z');
    EXPECT_NE(texture().file, "image.bmp");
}

TEST_F(BareHostTest, SeveralImagesAreOneStepAndWhatIsRefusedIsListed) {
    host.run({FilesGiven{{named("a.bmp", red), named("b.txt", "no image"), named("c.bmp", blue)}}});
    EXPECT_EQ(texture().file, "a.bmp");
    EXPECT_EQ(scene().textures.back().file, "c.bmp");
    ASSERT_THAT(host.session.asking.refused, SizeIs(1));
    EXPECT_EQ(host.session.asking.refused.front().where, "b.txt");
    click("refused:close");
    press('Z');
    EXPECT_EQ(scene().textures, defaultScene().textures);
    host.run({FilesGiven{{named("b.txt", "no image")}}});
    EXPECT_THAT(host.session.look.notice.text, HasSubstr("b.txt"));
    EXPECT_THAT(host.session.asking.refused, IsEmpty());
}

TEST_F(BareHostTest, AnImageIsRequestedForAParameter) {
    host.run({FilesGiven{{named("red.bmp", red)}}});
    ui::askOpenImage(host.session, "textures[0].file");
    host.run({Refresh{}});
    ASSERT_THAT(host.wishes, SizeIs(1));
    EXPECT_FALSE(host.wishes[0].isScene);
    EXPECT_EQ(host.wishes[0].param, "textures[0].file");
    EXPECT_EQ(host.session.asking.dialog, ui::Dialog::None) << "no list of a folder";
    EXPECT_EQ(host.last.wake, std::nullopt) << "it waits for the host";
    host.run({FilesGiven{{named("blue.bmp", blue)}, host.wishes[0]}});
    EXPECT_EQ(scene().textures[0].file, "blue.bmp");
}

TEST_F(BareHostTest, TheHostGetsWhatIsSaved) {
    host.run({FilesGiven{{named("red.bmp", red)}}});
    EXPECT_THAT(host.last.title, HasSubstr("•"));
    press('S');
    ASSERT_THAT(host.saved, SizeIs(1));
    const std::vector<NamedFile>& written = host.saved[0];
    ASSERT_THAT(written, SizeIs(2));
    EXPECT_EQ(written[0].name, "scene.texplorer.json");
    EXPECT_EQ(parseScene({reinterpret_cast<const char*>(written[0].bytes.data()), written[0].bytes.size()}),
              scene());
    EXPECT_EQ(written[1].name, "red.bmp");
    EXPECT_EQ(written[1].bytes, named("", red).bytes);
    EXPECT_EQ(host.last.title, "scene.texplorer.json - Texplorer");
    EXPECT_TRUE(host.loop.step(host.now, {CloseAsked{}}).quit) << "nothing would be lost";
}

TEST_F(BareHostTest, WhatWasSavedIsOpenedAgainWithItsImage) {
    host.run({FilesGiven{{named("red.bmp", red)}}});
    const Scene before = scene();
    press('S');
    ui::askNewScene(host.session);
    host.run({Refresh{}});
    ASSERT_EQ(scene().textures, defaultScene().textures);
    press('O');
    ASSERT_THAT(host.wishes, SizeIs(1));
    EXPECT_TRUE(host.wishes[0].isScene);
    host.run({FilesGiven{host.saved.at(0), host.wishes[0]}});
    EXPECT_EQ(scene(), before);
    EXPECT_THAT(host.loop.problems(), IsEmpty());
    EXPECT_EQ(host.session.look.notice.text, "");
    EXPECT_EQ(host.last.title, "scene.texplorer.json - Texplorer");
}

TEST_F(BareHostTest, AnImageOfTheSceneMayArriveLaterOrFromTheHost) {
    Scene given = defaultScene();
    given.textures[0].source = SourceKind::File;
    given.textures[0].file = "red.bmp";
    const FilesGiven dropped{{named("a.json", writeScene(given))}};
    host.run({dropped});
    EXPECT_EQ(scene().textures, given.textures);
    EXPECT_THAT(host.session.look.notice.text, HasSubstr("red.bmp: the host does not have it"));
    host.run({FilesGiven{{named("red.bmp", red)}}});
    EXPECT_EQ(scene().textures, given.textures) << "it names the image already";
    EXPECT_THAT(host.loop.problems(), IsEmpty());
    const Image complete = *host.graphics.largest();
    ui::askNewScene(host.session);
    host.run({Refresh{}});
    host.known["red.bmp"] = named("", red).bytes;
    host.run({dropped});
    EXPECT_EQ(*host.graphics.largest(), complete);
}

TEST_F(BareHostTest, AQuestionComesBeforeADroppedSceneReplacesWork) {
    click("textures[0].wrapS=GL_CLAMP");
    host.run({FilesGiven{{named("a.json", writeScene(defaultScene()))}}});
    EXPECT_EQ(host.session.asking.dialog, ui::Dialog::Discard);
    click("discard:save");
    ASSERT_THAT(host.saved, SizeIs(1));
    EXPECT_EQ(scene().textures, defaultScene().textures) << "then it is opened";
    EXPECT_EQ(host.session.asking.dialog, ui::Dialog::None);
}

TEST_F(BareHostTest, ARequestThatFollowsSavingReachesTheHostToo) {
    click("textures[0].wrapS=GL_CLAMP");
    press('O');
    click("discard:save");
    EXPECT_THAT(host.saved, SizeIs(1));
    ASSERT_THAT(host.wishes, SizeIs(1));
    EXPECT_EQ(host.session.asking.dialog, ui::Dialog::None);
}

TEST_F(BareHostTest, OtherFilesAreSavedTheSameWay) {
    for (const ui::Dialog dialog :
         {ui::Dialog::SaveProgram, ui::Dialog::SaveAnswers, ui::Dialog::SaveTexture}) {
        host.session.asking.dialog = dialog;
        host.run({Refresh{}});
    }
    ASSERT_THAT(host.saved, SizeIs(3));
    EXPECT_EQ(host.saved[0].at(0).name, "scene.c");
    EXPECT_THAT(host.saved[0].at(0).bytes, SizeIs(Gt(1000U)));
    EXPECT_EQ(host.saved[1].at(0).name, "answers.json");
    EXPECT_EQ(host.saved[2].at(0).name, "checker.dds");
    EXPECT_THAT(host.saved[2].at(0).bytes, SizeIs(Gt(64U * 64U * 4U)));
}

TEST_F(BareHostTest, ARendererThatIsNotThereIsNotOffered) {
    for (const EnumRow& row : EnumTable<RendererKind>::rows)
        click("renderer:" + std::string(row.label));
    EXPECT_EQ(host.session.view.renderer, RendererKind::Reference);
    click("renderer:Compare");
    EXPECT_FALSE(isComparing(host.session.view)) << "with one renderer there is nothing to compare";
    host.run({at("view")});
    for (const int key : {int{'1'}, int{'2'}, int{'4'}})
        press(key, {});
    EXPECT_EQ(host.session.view.renderer, RendererKind::Reference) << "keys are no way around it";
    EXPECT_FALSE(isComparing(host.session.view));
    EXPECT_THAT(host.session.look.notice.text, HasSubstr("there is no OpenGL here"));
}

TEST_F(BareHostTest, ALessonThatShowsAnotherRendererShowsTheReference) {
    for (const auto& [lesson, step] : {std::pair("laboratory", 1U), std::pair("environments", 6U)}) {
        ASSERT_TRUE(ui::openLessonNamed(host.session, lesson, step));
        host.run({Refresh{}});
        EXPECT_EQ(host.session.view.renderer, RendererKind::Reference) << lesson;
        EXPECT_FALSE(isComparing(host.session.view)) << lesson;
        EXPECT_TRUE(host.graphics.largest()) << lesson;
    }
}

TEST(BareHostsSettingsTest, ARendererThatWasChosenElsewhereIsReplacedByTheReference) {
    const test::NoThreads threads;
    const NoFiles files;
    BareHost host(wide, RendererKind::Shader);
    host.run();
    EXPECT_EQ(host.session.view.renderer, RendererKind::Reference);
    EXPECT_THAT(host.session.look.notice.text, HasSubstr("there is no OpenGL here"));
    EXPECT_TRUE(host.graphics.largest());
    EXPECT_EQ(host.graphics.refusals, 0);
}

TEST_F(BareHostTest, ALessonIsOpenedAndAnsweredByMouse) {
    ui::askLesson(host.session, "first-texture");
    host.run({Refresh{}});
    ASSERT_TRUE(host.session.lesson);
    click("lesson:Next");
    click("answer:3");
    EXPECT_EQ(host.session.lesson->answer, 2U);
    EXPECT_TRUE(host.session.settings.lessons.at("first-texture").at(1).done);
    EXPECT_TRUE(places.items.contains("reason"));
    EXPECT_EQ(host.last.wake, std::nullopt);
}

TEST_F(BareHostTest, AnAddressOpensASceneOrALesson) {
    const Scene before = scene();
    ASSERT_TRUE(ui::openAddress(host.session, ""));
    EXPECT_EQ(scene(), before);
    Scene other = defaultScene();
    other.textures.front().wrapS = Wrap::Clamp;
    ASSERT_TRUE(ui::openAddress(host.session, writeSceneLink(other).value()));
    host.run({Refresh{}});
    EXPECT_EQ(texture().wrapS, Wrap::Clamp);
    ASSERT_TRUE(ui::openAddress(host.session, "lesson=first-texture&step=2"));
    host.run({Refresh{}});
    ASSERT_TRUE(host.session.lesson);
    EXPECT_EQ(host.session.lesson->step, 1U);
}

TEST_F(BareHostTest, AFrameShowsTheViewAndAnOpenLessonWithoutTheTour) {
    ui::Workspace& workspace = host.session.settings.workspace;
    showTab(workspace, ui::Tab::Lesson); // the list: no lesson is open
    host.session.window.tour = 0;
    ASSERT_TRUE(ui::openAddress(host.session, "layout=embed"));
    host.run({Refresh{}});
    EXPECT_FALSE(isOpen(workspace, ui::Tab::Lesson));
    EXPECT_EQ(host.session.window.tour, std::nullopt);
    ASSERT_TRUE(ui::openAddress(host.session, "lesson=wrap&layout=embed"));
    host.run({Refresh{}});
    EXPECT_TRUE(isOpen(workspace, ui::Tab::Lesson));
}

TEST_F(BareHostTest, AnAddressThatNamesNothingIsRefused) {
    const Scene before = scene();
    for (const auto& [address, said] :
         {std::pair("texplorer:1:%", "damaged"), std::pair("lesson=first", "first-texture"),
          std::pair("lesson=wrap&step=0", "from 1"), std::pair("lesson=wrap&step=99", "from 1 to"),
          std::pair("lesson=wrap&step=x", "from 1"), std::pair("step=2", "lesson=NAME"),
          std::pair("a=b", "lesson=NAME"), std::pair("=&=", "lesson=NAME")}) {
        const Result<void> opened = ui::openAddress(host.session, address);
        ASSERT_FALSE(opened) << address;
        EXPECT_THAT(describe(opened.error()).english(), HasSubstr(said));
    }
    EXPECT_EQ(scene(), before);
    EXPECT_FALSE(host.session.lesson);
}

TEST_F(BareHostTest, AMessageChangesTheSceneAsAnUndoStep) {
    EXPECT_EQ(answerMessage(host.session, R"({"texplorer": 1, "id": "a", "do": "set",
                                              "path": "textures[0].wrapS", "value": "GL_CLAMP"})"),
              R"({"texplorer":1,"id":"a"})");
    host.run({Refresh{}});
    EXPECT_EQ(texture().wrapS, Wrap::Clamp);
    EXPECT_THAT(answerMessage(host.session, R"({"texplorer": 1, "do": "read"})"),
                HasSubstr(R"("wrapS":"GL_CLAMP")"));
    host.run({at("view")});
    press('Z');
    EXPECT_EQ(texture().wrapS, Wrap::Repeat);
    EXPECT_EQ(
        answerMessage(host.session, R"({"texplorer": 1, "do": "load", "scene": {"view": {"azimuth": 7}}})"),
        R"({"texplorer":1})");
    host.run({Refresh{}});
    EXPECT_EQ(scene().view.azimuth, 7);
}

TEST_F(BareHostTest, OnlyTheUsersEditsAreUnsavedWork) {
    const auto receive = [this](std::string_view message) {
        EXPECT_EQ(answerMessage(host.session, message), R"({"texplorer":1})");
    };
    receive(R"({"texplorer": 1, "do": "load", "scene": {"textures": [{"pattern": "brick"}]}})");
    receive(R"({"texplorer": 1, "do": "set", "path": "textures[0].wrapS", "value": "GL_CLAMP"})");
    host.run({Refresh{}});
    EXPECT_EQ(texture().wrapS, Wrap::Clamp);
    EXPECT_FALSE(isDirty(host.session.document));
    click("textures[0].wrapS=GL_MIRRORED_REPEAT");
    EXPECT_TRUE(isDirty(host.session.document));
    receive(R"({"texplorer": 1, "do": "set", "path": "textures[0].wrapT", "value": "GL_CLAMP"})");
    host.run({Refresh{}});
    EXPECT_TRUE(isDirty(host.session.document));
}

TEST_F(BareHostTest, AMessageThatCantBeDoneSaysWhy) {
    const Scene before = scene();
    for (const auto& [message, said] :
         {std::pair("", "JSON object"), std::pair("[]", "JSON object"),
          std::pair(R"({"do": "read"})", "version"),
          std::pair(R"({"texplorer": 2, "do": "read"})", "version"),
          std::pair(R"({"texplorer": 1})", "expected a text"),
          std::pair(R"({"texplorer": 1, "do": "eat"})", "eat"),
          std::pair(R"({"texplorer": 1, "do": "set", "path": 1, "value": ""})", "path"),
          std::pair(R"({"texplorer": 1, "do": "set", "path": "textures[9].wrapS", "value": "GL_CLAMP"})",
                    "textures"),
          std::pair(R"({"texplorer": 1, "do": "load"})", "expected a scene"),
          std::pair(R"({"texplorer": 1, "do": "load", "scene": {"a": 1}})", "a"),
          std::pair(R"({"texplorer": 1, "do": "open", "address": "lesson=x"})", "expected one of")}) {
        const std::string answer = answerMessage(host.session, message);
        EXPECT_THAT(answer, HasSubstr(R"("error":")")) << message;
        EXPECT_THAT(answer, HasSubstr(said)) << message;
    }
    const std::string deep = R"({"texplorer": 1, "do": "load", "scene": )" + std::string(1000000, '[');
    EXPECT_THAT(answerMessage(host.session, deep + std::string(1000000, ']') + "}"), HasSubstr("32 levels"));
    host.run({Refresh{}});
    EXPECT_EQ(scene(), before);
}

TEST_F(BareHostTest, WhatHappensInALessonIsAnEvent) {
    LessonEvents events;
    EXPECT_EQ(events.take(host.session), "");
    ASSERT_TRUE(ui::openAddress(host.session, "lesson=first-texture&step=2"));
    host.run({Refresh{}});
    EXPECT_THAT(events.take(host.session),
                HasSubstr(R"("event":"lesson","lesson":"first-texture","step":2)"));
    EXPECT_EQ(events.take(host.session), "") << "nothing has changed";
    ui::answerQuestion(host.session, 2);
    host.run({Refresh{}});
    EXPECT_THAT(events.take(host.session), HasSubstr(R"("done":true,"stepsDone":1,"answer":3)"));
}

TEST_F(BareHostTest, ThePageIsPartOfALink) {
    host.session.window.page = "https://example.org/";
    host.run({FilesGiven{{named("red.bmp", red)}}});
    const std::string link = ui::sceneLink(host.session).value();
    EXPECT_THAT(link, testing::StartsWith("https://example.org/#texplorer:1:"));
    EXPECT_EQ(parseSceneLink(link).value().textures.front().file, "red.bmp");
}

TEST_F(BareHostTest, WhatTheWindowShowsIsSaid) {
    EXPECT_EQ(spokenBy(host.session).language, "en");
    EXPECT_EQ(spokenBy(host.session).step, std::nullopt);
    EXPECT_EQ(spokenBy(host.session).status, "");
    EXPECT_EQ(spokenBy(host.session, std::array{Sentence("no memory")}).status, "no memory");
    host.run({at("textures[0].wrapS=GL_CLAMP")});
    EXPECT_EQ(spokenBy(host.session).row, "Wrap s: GL_REPEAT");
    host.run({FilesGiven{{named("b.txt", "no image")}}});
    EXPECT_THAT(spokenBy(host.session).status, HasSubstr("b.txt"));
    ui::askLesson(host.session, "first-texture");
    host.run({Refresh{}});
    ui::goToLessonStep(host.session, 1);
    host.run({Refresh{}});
    const SpokenStep asked = spokenBy(host.session).step.value();
    EXPECT_EQ(asked.step, 1U);
    EXPECT_THAT(asked.answers, SizeIs(Gt(2U)));
    EXPECT_EQ(asked.chosen, std::nullopt);
    EXPECT_EQ(asked.verdict, "");
    ui::answerQuestion(host.session, 0);
    host.run({Refresh{}});
    EXPECT_EQ(spokenBy(host.session).step->chosen, 0U);
    EXPECT_THAT(spokenBy(host.session).step->verdict, HasSubstr("Not this one"));
    ui::answerQuestion(host.session, 2);
    host.run({Refresh{}});
    EXPECT_EQ(spokenBy(host.session).step->verdict, host.session.lesson->reason());
}

TEST_F(BareHostTest, TheWindowKeepsItsOwnClipboard) {
    EXPECT_EQ(ImGui::GetClipboardText(), nullptr);
    ImGui::SetClipboardText("from here");
    EXPECT_STREQ(ImGui::GetClipboardText(), "from here");
}

TEST_F(BareHostTest, TheHostHasIndeedNoFilesAndNoThreads) {
    EXPECT_FALSE(readFile("/proc/self/status"));
    EXPECT_THAT(besidesFonts(files.attempts), ElementsAre("/proc/self/status")) << "an attempt is noted";
    EXPECT_THROW(std::thread([] {}).join(), std::system_error);
    std::erase(files.attempts, "/proc/self/status");
}

} // namespace
} // namespace texplorer::stage::bare_host_test
