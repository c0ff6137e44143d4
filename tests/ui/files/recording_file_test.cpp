#include "app/ui/files/recording_file.h"
#include "app/ui/model/session.h"
#include "app/ui/state/recording_choice.h"
#include "tests/support/temp_dir.h"
#include "texplorer/codec/png/png.h"
#include "texplorer/codec/png/png_text.h"
#include "texplorer/files/file_io.h"
#include "texplorer/image/convert.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/storage/scene_file.h"

#include <gmock/gmock.h>

#include <stop_token>

namespace texplorer::ui::recording_file_test {
namespace {

using testing::HasSubstr;

Scene turning() {
    Scene scene = defaultScene();
    scene.timeline.keys = {{0, "view.azimuth", "0"}, {2, "view.azimuth", "90"}};
    return scene;
}

FileOrder order(const std::filesystem::path& file, animation::Format format) {
    return fileOrder({{turning(), {}, 0.5, 48, 36}, format, 1, 8}, file);
}

std::string start(const std::filesystem::path& file, std::size_t bytes) {
    const Bytes read = readFileStart(file, bytes).value();
    return {reinterpret_cast<const char*>(read.data()), read.size()};
}

TEST(RecordingFile, AreOfTheFormatThatWasChosen) {
    const test::TempDir folder;
    FileWriting writing(When::AtOnce);
    const auto written = [&](std::string_view name, animation::Format format) {
        writing.write(order(folder / name, format));
        const std::optional<FileNews> news = writing.takeNews();
        EXPECT_EQ(news->text, "Written: " + (folder / name).string());
        EXPECT_TRUE(news->isGood);
        return start(folder / name, 64);
    };
    EXPECT_THAT(written("a.gif", animation::Format::Gif), testing::StartsWith("GIF89a"));
    EXPECT_EQ(written("a.webp", animation::Format::WebP).substr(8, 4), "WEBP");
    EXPECT_THAT(written("a.png", animation::Format::Apng), HasSubstr("acTL"));
    EXPECT_FALSE(writing.takeNews());
}

TEST(RecordingFile, BeginWithTheReferencesPictureOfTheirTime) {
    const test::TempDir folder;
    FileWriting writing(When::AtOnce);
    writing.write(order(folder / "a.png", animation::Format::Apng));
    const Bytes bytes = readFile(folder / "a.png").value();
    const Image first = withoutAlpha(std::get<Image>(decodePng(bytes).value().surface(0, 0)));
    Scene scene = defaultScene();
    scene.view.azimuth = 22.5F; // a quarter of the way
    EXPECT_EQ(first, withoutAlpha(reference::drawReference({scene, {}, 0.5, 48, 36}).value().image));
    const std::optional<std::string> said = findPngText(bytes, sceneKeyword, 1 << 20).value();
    EXPECT_EQ(parseScene(said.value()).value(), turning());
}

TEST(RecordingFile, IsCountedInPictures) {
    const FileOrder asked = order("a.gif", animation::Format::Gif);
    EXPECT_EQ(asked.pictures, 8U);
    std::vector<float> shares;
    ASSERT_TRUE(asked.make({.report = [&](float share) { shares.push_back(share); }}));
    EXPECT_THAT(shares, testing::ElementsAre(0, 0.125F, 0.25F, 0.375F, 0.5F, 0.625F, 0.75F, 0.875F));
}

TEST(RecordingFile, EndsWithTheNextPicture) {
    std::stop_source stop;
    int drawn = 0;
    const Result<MadeFile> made = order("a.gif", animation::Format::Gif)
                                      .make({
                                          .levels = {.stop = stop.get_token()},
                                          .report =
                                              [&](float) {
                                                  if (++drawn == 3)
                                                      stop.request_stop();
                                              },
                                      });
    EXPECT_FALSE(made);
    EXPECT_EQ(drawn, 3);
}

class ChosenRecording : public testing::Test {
protected:
    ChosenRecording() { session.document.scene = turning(); }

    [[nodiscard]] std::string problem() const {
        const Result<Recording> recording = recordingOf(session);
        return recording ? Sentence() : describe(recording.error());
    }

    ServicesAtOnce services;
    Session session{services.lend()};
    RecordingChoice& choice = session.recording;
};

TEST_F(ChosenRecording, IsAsLongAsTheKeyFrames) {
    EXPECT_EQ(recordingOf(session).value().seconds, 2);
    EXPECT_EQ(recordingOf(session).value().pictures(), 50U);
    choice.begin = 0.5F;
    EXPECT_EQ(recordedSeconds(session), 1.5F);
    EXPECT_EQ(recordingOf(session).value().picture.time, 0.5);
    choice.begin = 3;
    EXPECT_EQ(recordedSeconds(session), usualSeconds) << "behind them";
    choice.seconds = 1;
    choice.perSecond = 12.5F;
    EXPECT_EQ(recordingOf(session).value().pictures(), 13U);
    choice.seconds = 0.01F;
    EXPECT_EQ(recordingOf(session).value().pictures(), 1U);
}

TEST_F(ChosenRecording, SaysWhatAFormatCant) {
    EXPECT_EQ(problem(), "");
    choice.format = animation::Format::Gif;
    choice.perSecond = 60;
    EXPECT_THAT(problem(), HasSubstr("up to 50 pictures a second in a GIF, found 60"));
    choice.perSecond = 50;
    EXPECT_EQ(problem(), "");
    choice.format = animation::Format::WebP;
    choice.width = 16384;
    EXPECT_THAT(problem(), HasSubstr("up to 16383 × 16383 pixels in a WebP, found 16384 × 400"));
    choice.width = 640;
    choice.seconds = 3600;
    EXPECT_THAT(problem(), HasSubstr("at most 10000 pictures, found 180000"));
    choice.begin = 1;
    EXPECT_THAT(problem(), HasSubstr("an end within 3600 s, found 3601 s"));
}

TEST_F(ChosenRecording, ItsFileIsNamedForItsFormat) {
    EXPECT_EQ(recordingFileName(session), "scene.webp");
    choice.format = animation::Format::Apng;
    session.document.suggested = "/somewhere/earth.texplorer.json";
    EXPECT_EQ(recordingFileName(session), "earth.png");
    EXPECT_THAT(describe(saveRecording(session, "earth.gif").error()),
                HasSubstr("ends with .png, found \"earth.gif\""));
}

} // namespace
} // namespace texplorer::ui::recording_file_test
