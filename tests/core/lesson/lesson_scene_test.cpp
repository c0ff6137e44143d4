#include "tests/support/small_bmp.h"
#include "tests/support/temp_dir.h"
#include "texplorer/files/file_io.h"
#include "texplorer/lesson/example.h"
#include "texplorer/lesson/lesson_check.h"
#include "texplorer/lesson/lesson_scene.h"
#include "texplorer/lesson/match.h"
#include "texplorer/scene/params/json.h"

#include <fmt/core.h>
#include <gmock/gmock.h>

namespace texplorer::lesson::lesson_scene_test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;

auto placed(const testing::Matcher<std::string>& text) {
    return Field(&Error::where, testing::Property(&Location::text, text));
}

Step stepOf(std::string scene, std::vector<Edit> edits = {}) {
    return {"S", "T", std::move(scene), std::move(edits), {}, {}};
}

class LessonScenes : public testing::Test {
protected:
    LessonScenes() { fs::create_directory(path); }

    void write(const std::string& name, std::string_view text) const {
        ASSERT_TRUE(writeFileAtomically(path / name, viewBytes(text)));
    }
    /// A scene with an image of a file.
    void writePictured(const std::string& name, const std::string& image) const {
        Scene scene = defaultScene();
        scene.textures[0].source = SourceKind::File;
        scene.textures[0].file = image;
        write(name, writeScene(scene));
    }
    [[nodiscard]] Result<LessonScene> start(std::size_t step = 0) const {
        return startOf(folder, lesson, step);
    }
    [[nodiscard]] std::vector<Error> problems() const { return checkLesson(folder, lesson); }

    texplorer::test::TempDir parent;
    fs::path path = parent / "mine";
    LessonFolder folder = LessonFolder::onDisk(path);
    Lesson lesson{"L", "", "A", {stepOf("cube")}};
};

TEST_F(LessonScenes, AreExamplesByTheirName) {
    EXPECT_EQ(start()->scene, exampleScene("cube.json").value());
}

TEST_F(LessonScenes, AreFilesOfTheFolderBeforeExamples) {
    Scene mine = defaultScene();
    mine.material.shininess = 77;
    write("cube", writeScene(mine));
    EXPECT_EQ(start()->scene, mine);
}

TEST_F(LessonScenes, GoOnWithTheStepBefore) {
    lesson.steps = {stepOf("cube", {edit::Set{"material.shininess", "5"}}),
                    stepOf("", {edit::Set{"material.color", "1,0,0,1"}}), stepOf(""), stepOf("checker"),
                    stepOf("", {edit::ApplyPreset{"seam"}})};
    EXPECT_EQ(start(2)->scene.material.shininess, 5);
    EXPECT_EQ(start(2)->scene.material.color, glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(start(3)->scene, exampleScene("checker.json").value());
    EXPECT_NE(start(4)->scene, start(3)->scene);
}

TEST_F(LessonScenes, AreEditedAltogetherOrNotAtAll) {
    Scene scene = defaultScene();
    const Result<void> made = makeEdits(
        scene, std::vector<Edit>{edit::Set{"material.shininess", "5"}, edit::Set{"material.nothing", "1"}},
        "edits");
    ASSERT_FALSE(made);
    EXPECT_THAT(made.error().where.text(), HasSubstr("edits/1"));
    EXPECT_EQ(scene, defaultScene());
    const Result<void> preset = makeEdits(scene, std::vector<Edit>{edit::ApplyPreset{"none"}});
    ASSERT_FALSE(preset);
    EXPECT_EQ(preset.error().code, ErrorCode::NotFound);
}

TEST_F(LessonScenes, ThatAreNotThereAreRefusedByPlace) {
    lesson.steps.push_back(stepOf("nothing"));
    EXPECT_EQ(start(1).error().code, ErrorCode::NotFound);
    EXPECT_EQ(start(1).error().where, "/steps/1/scene");
    for (const char* name : {"../cube", "../mine/cube", "/etc/passwd", "..", "."}) {
        lesson.steps[1].scene = name;
        ASSERT_FALSE(start(1)) << name;
        EXPECT_THAT(start(1).error().where.text(), HasSubstr("/steps/1/scene")) << name;
    }
    write("broken.json", "{");
    lesson.steps[1].scene = "broken.json";
    EXPECT_THAT(start(1).error().where.text(), HasSubstr("/steps/1/scene"));
    lesson.steps[1] = stepOf("cube", {edit::Set{"material.color", "red"}});
    EXPECT_THAT(start(1).error().where.text(), HasSubstr("/steps/1/edits/0"));
}

TEST_F(LessonScenes, CheckKeysWithTheStepsThatHaveThem) {
    lesson.keys = {{"A", "a", Cycle{{{"one", {edit::Set{"textures[0].wrapS", "GL_CLAMP"}}}}}},
                   {"B", "b", Cycle{{{"one", {edit::Set{"passes[1].blend", "true"}}}}}},
                   {"C", "c", Addition{"view.distance", 0, 1}},
                   {"D", "d", Addition{"view.distance", 1, 1}}};
    EXPECT_THAT(problems(), ElementsAre(placed(HasSubstr("/keys/1/cycle/0/edits/0")),
                                        placed(HasSubstr("/keys/3: view.distance"))));
    lesson.steps.push_back(stepOf("texbind")); // which has two passes
    EXPECT_THAT(problems(), ElementsAre(placed(HasSubstr("/keys/3"))));
}

TEST_F(LessonScenes, HaveTheImagesOfTheFolder) {
    write("red.bmp", texplorer::test::onePixelBmp({'\0', '\0', '\xff'}));
    writePictured("s.json", "red.bmp");
    lesson.steps = {stepOf("s.json")};
    ASSERT_TRUE(start()) << describe(start().error());
    EXPECT_TRUE(start()->images.holds("red.bmp"));
    EXPECT_THAT(problems(), IsEmpty());
}

TEST_F(LessonScenes, WithoutTheirImageAreRefusedByPlace) {
    writePictured("s.json", "missing.png");
    lesson.steps = {stepOf("s.json")};
    EXPECT_THAT(problems(), ElementsAre(AllOf(Field(&Error::code, ErrorCode::NotFound),
                                              placed(HasSubstr("/steps/0/scene")))));
    EXPECT_THAT(describe(problems()[0]), HasSubstr("missing.png"));
    write("missing.png", "no image");
    EXPECT_THAT(problems(), ElementsAre(placed(HasSubstr("/steps/0/scene"))));
}

TEST_F(LessonScenes, AreRefusedOnceForAllStepsThatGoOnWithThem) {
    const Edit unknown = edit::Set{"textures[0].wrapQ", "1"};
    const Step own = stepOf("", {unknown});
    const Step wrong = stepOf("cube", {unknown});
    lesson.steps = {wrong, stepOf(""), own, wrong, stepOf("")};
    EXPECT_THAT(problems(),
                ElementsAre(placed(HasSubstr("/steps/0/edits/0")), placed(HasSubstr("/steps/3/edits/0"))));

    writePictured("s.json", "missing.png");
    lesson.steps = {stepOf("s.json"), stepOf(""), own, stepOf(""), stepOf("s.json"), stepOf("")};
    EXPECT_THAT(problems(),
                ElementsAre(placed(HasSubstr("/steps/0/scene")), placed(HasSubstr("/steps/2/edits/0")),
                            placed(HasSubstr("/steps/4/scene"))));
}

TEST_F(LessonScenes, HaveNoImagesOfOtherFolders) {
    ASSERT_TRUE(writeFileAtomically(parent / "red.bmp",
                                    viewBytes(texplorer::test::onePixelBmp({'\0', '\0', '\xff'}))));
    fs::create_symlink("../red.bmp", path / "link.bmp");
    lesson.steps = {stepOf("s.json")};
    const std::string absolute = (parent / "red.bmp").string();
    for (const std::string& file : {std::string("../red.bmp"), std::string("link.bmp"), absolute}) {
        SCOPED_TRACE(file);
        writePictured("s.json", file);
        ASSERT_FALSE(start());
        EXPECT_EQ(start().error().code, ErrorCode::OutOfRange);
        EXPECT_THAT(start().error().where.text(), HasSubstr("/steps/0/scene: " + file));
        // The picture of a level is an image as well.
        Scene scene = defaultScene();
        scene.textures[0].mipmaps = MipPolicy::Given;
        scene.textures[0].minFilter = MinFilter::LinearMipmapLinear;
        scene.textures[0].levels = {{SourceKind::File, Pattern::Checker, file}};
        write("s.json", writeScene(scene));
        ASSERT_FALSE(start());
        EXPECT_EQ(start().error().code, ErrorCode::OutOfRange);
    }
}

/// Those of the program, by a decoder that has seen none of their files as files.
TEST(BuiltInScenes, HaveTheImagesOfTheirLesson) {
    const LessonFolder folder = LessonFolder::builtIn("dds").value();
    const Lesson lesson = readLesson(folder).value();
    const LessonScene start = startOf(folder, lesson, 0).value();
    const auto image = start.images.contentOf("dxt1.dds");
    ASSERT_TRUE(image);
    EXPECT_EQ(image->levels, 8);
    const auto bytes = start.images.fileInMemory("dxt1.dds");
    ASSERT_TRUE(bytes);
    EXPECT_EQ(bytes->size(), 11064U) << "128 of header, and 8192 + 2048 + 512 + 128 + 32 + 8 + 8 + 8";
    EXPECT_FALSE(start.images.fileInMemory("dxt3.dds")) << "no step before has it";
}

/// Each of the tutorial's three remedies brings the picture back, and nothing else that is near does.
TEST(BuiltInScenes, AcceptEveryRemedyForMissingMipmaps) {
    const LessonFolder folder = LessonFolder::builtIn("dds").value();
    const Lesson lesson = readLesson(folder).value();
    const auto step = static_cast<std::size_t>(
        std::ranges::find(lesson.steps, "no-mipmaps.json", &Step::scene) - lesson.steps.begin());
    ASSERT_LT(step, lesson.steps.size());
    const LessonScene start = startOf(folder, lesson, step).value();
    const LessonScene target = withEdits(start, std::get<Match>(lesson.steps[step].task).edits).value();
    const auto passes = [&](const Edit& edit) {
        return gradeMatch(withEdits(start, {edit})->scene, target.scene, start.images)->passed;
    };
    EXPECT_TRUE(passes(edit::Set{"textures[0].minFilter", "GL_LINEAR"}));
    EXPECT_TRUE(passes(edit::Set{"textures[0].maxLevel", "0"}));
    EXPECT_TRUE(passes(edit::Set{"textures[0].mipmaps", "generated"}));
    EXPECT_FALSE(passes(edit::Set{"textures[0].magFilter", "GL_NEAREST"}));
    EXPECT_FALSE(passes(edit::Set{"textures[0].maxLevel", "1"}));
}

/// The same picture by each way of turning it, and not by none.
TEST(BuiltInScenes, AreTurnedByEachCure) {
    const LessonFolder folder = LessonFolder::builtIn("dds").value();
    const Lesson lesson = readLesson(folder).value();
    const LessonScene start = startOf(folder, lesson, 0).value();
    const auto drawn = [&](const std::vector<Edit>& edits) {
        return drawSmall(withEdits(start, edits).value()).value();
    };
    const Image upright = drawn({edit::Set{"textures[0].flip", "blocks"}});
    EXPECT_TRUE(areAlike(drawn({edit::Set{"textures[0].flip", "pixels"}}), upright));
    EXPECT_TRUE(areAlike(drawn({edit::Set{"textures[0].flip", "coordinates"}}), upright));
    EXPECT_TRUE(areAlike(drawn({edit::Set{"passes[0].units[0].matrix[0].amount", "1,-1,1"}}), upright));
    EXPECT_FALSE(areAlike(drawn({}), upright));
}

class Photographs : public testing::Test {
protected:
    [[nodiscard]] LessonScene night() const {
        const LessonFolder folder = LessonFolder::builtIn("earth", installed.path()).value();
        const Lesson lesson = readLesson(folder).value();
        const auto step = static_cast<std::size_t>(
            std::ranges::find(lesson.steps, "night.json", &Step::scene) - lesson.steps.begin());
        return startOf(folder, lesson, step).value();
    }
    void install(const char* name, std::string_view bytes) const {
        ASSERT_TRUE(writeFileAtomically(installed / name, viewBytes(bytes)));
    }

    texplorer::test::TempDir installed;
};

TEST_F(Photographs, AreReadWhereTheyAreInstalled) {
    install("earth.jpg", texplorer::test::onePixelBmp({'\0', '\0', '\xff'})); // by its content
    install("night.jpg", texplorer::test::onePixelBmp({'\xff', '\0', '\0'}));
    const LessonScene step = night();
    EXPECT_EQ(step.scene.textures[0].file, (installed / "earth.jpg").string());
    EXPECT_TRUE(step.images.holds(step.scene.textures[0].file));
    EXPECT_THAT(step.scene.textures[1].preparation, IsEmpty()) << "that makes lights of the pattern";
    EXPECT_THAT(imageNotes(step),
                ElementsAre(AllOf(HasSubstr(installed.path().string()), HasSubstr("earth.jpg, night.jpg"))));
}

TEST_F(Photographs, AreReplacedByPatternsWhereThereAreNone) {
    install("earth.jpg", "no image");
    const LessonScene step = night();
    for (const Texture& texture : step.scene.textures) {
        EXPECT_EQ(texture.source, SourceKind::Pattern);
        EXPECT_EQ(texture.pattern, Pattern::Planet);
    }
    EXPECT_EQ(step.scene.textures[1].preparation.size(), 3U);
    EXPECT_THAT(imageNotes(step), ElementsAre(HasSubstr("Computed pictures replace earth.jpg, night.jpg")));
}

TEST_F(LessonScenes, TakeNoPhotographsForAFolderOfTheirOwn) {
    Scene scene = defaultScene();
    scene.textures[0].source = SourceKind::File;
    scene.textures[0].file = "earth.jpg";
    write("s.json", writeScene(scene));
    lesson.steps = {stepOf("s.json")};
    EXPECT_EQ(folder.installed("earth.jpg"), "");
    ASSERT_TRUE(start());
    EXPECT_EQ(start()->scene.textures[0].source, SourceKind::Pattern);
    write("earth.jpg", texplorer::test::onePixelBmp({'\0', '\0', '\xff'}));
    EXPECT_EQ(start()->scene.textures[0].file, "earth.jpg") << "but it may have one itself";
    fs::remove(path / "earth.jpg");
    ASSERT_TRUE(writeFileAtomically(parent / "earth.jpg", viewBytes("x")));
    fs::create_symlink("../earth.jpg", path / "earth.jpg");
    EXPECT_EQ(start().error().code, ErrorCode::OutOfRange);
}

TEST_F(LessonScenes, LeaveImagesThatAreReadLater) {
    writePictured("s.json", "red.bmp");
    lesson.steps = {stepOf("s.json")};
    EXPECT_TRUE(startOf(folder, lesson, 0, StepImages::Leave));
    EXPECT_FALSE(start());
    writePictured("s.json", "../red.bmp");
    EXPECT_FALSE(startOf(folder, lesson, 0, StepImages::Leave));
}

/// NeHe's rule: units > 1 ? two : one.
TEST_F(LessonScenes, FallBackWhereTheyUseMoreUnitsThanThereAre) {
    lesson.steps = {stepOf("nehe-bumps-2-units"), stepOf("", {edit::Set{"material.shininess", "5"}}),
                    stepOf("cube")};
    lesson.steps[0].fallback = Fallback{"One unit.", {edit::Set{"passes[0].units[1].enabled", "false"}}};
    for (const std::size_t step : {0U, 1U}) {
        const LessonScene two = startOf(folder, lesson, step, StepImages::Read, 2).value();
        EXPECT_EQ(unitsUsed(two.scene), 2);
        EXPECT_EQ(two.fallback, "");
        const LessonScene one = startOf(folder, lesson, step, StepImages::Read, 1).value();
        EXPECT_EQ(unitsUsed(one.scene), 1);
        EXPECT_EQ(one.fallback, "One unit.");
        EXPECT_EQ(one.scene.material.shininess, two.scene.material.shininess);
    }
    EXPECT_EQ(startOf(folder, lesson, 2, StepImages::Read, 1)->fallback, "");
    EXPECT_THAT(problems(), IsEmpty());
}

TEST_F(LessonScenes, AreCheckedForFallbacksThatAreNone) {
    lesson.steps = {stepOf("nehe-bumps-2-units"), stepOf("nehe-bumps-2-units"), stepOf("cube")};
    lesson.steps[0].fallback = Fallback{"F {s}", {edit::Set{"material.shininess", "5"}}};
    lesson.steps[1].fallback = Fallback{"F", {edit::Set{"no", "5"}}};
    lesson.steps[2].fallback = Fallback{"F", {edit::Set{"material.shininess", "5"}}};
    std::vector<std::string> found;
    for (const Error& problem : problems())
        found.push_back(describe(problem));
    EXPECT_THAT(found, ElementsAre(HasSubstr("/steps/0/fallback/text"), HasSubstr("found one with 2"),
                                   HasSubstr("/steps/1/fallback/edits/0"), HasSubstr("it is not needed")));
}

/// What differs lies at the sides, which a picture that is higher than wide hasn't.
TEST_F(LessonScenes, AreCheckedForATaskThatIsMetInSomePicture) {
    Scene scene;
    scene.view.projection = Projection::Orthographic;
    scene.view.fieldOfView = 90;
    scene.view.distance = 1;
    scene.models.resize(1);
    scene.models[0].shape = Shape::Quad;
    scene.models[0].scale = {0.2F, 0.2F, 1};
    scene.models[0].position = {0, 0, 0};
    write("s.json", writeScene(scene));
    lesson.steps = {stepOf("s.json")};
    lesson.steps[0].task = Match{"M", {edit::Set{"models[0].visible", "false"}}};
    EXPECT_THAT(problems(), IsEmpty());
    scene.models[0].position = {1.1F, 0, 0};
    write("s.json", writeScene(scene));
    EXPECT_THAT(problems(),
                ElementsAre(AllOf(placed("/steps/0/match"), Field(&Error::message, HasSubstr("144 × 192")))));
}

TEST_F(LessonScenes, AreCheckedForEverythingThatCanBeWrong) {
    lesson.steps = {stepOf("cube"), stepOf(""), stepOf(""), stepOf(""), stepOf(""), stepOf("")};
    lesson.steps[0].look = {"textures[9].wrapS", "explian", "edges", "levels", "fixed,software", -1, -1};
    lesson.steps[1].task = Predict{
        "Q",
        {{"a", {edit::Set{"view.background", "1,0,0,1"}}}, {"b", {edit::Set{"view.background", "1,0,0,1"}}}},
        0,
        "{colour}"};
    lesson.steps[2].task = Predict{"Q", {{"a", {edit::Set{"no", "1"}}}, {"b", {}}}, 0, "R"};
    lesson.steps[3].task = Match{"M", {edit::Set{"material.name", "x"}}};
    lesson.steps[4].task = Match{"M", {edit::Set{"textures[0].priority", "0.5"}}};
    lesson.steps[5].task =
        Match{"M", {edit::Set{"textures[0].source", "file"}, edit::Set{"textures[0].file", "none.png"}}};
    std::vector<std::string> places;
    for (const Error& problem : problems())
        places.push_back(problem.where.text());
    EXPECT_THAT(places, ElementsAre(HasSubstr("/steps/0/look/param"), "/steps/0/look/tab",
                                    "/steps/0/look/figure", "/steps/0/look/shown", "/steps/0/look/renderer",
                                    "/steps/1/predict/answers/1", HasSubstr("/steps/1/predict/reason"),
                                    HasSubstr("/steps/2/predict/answers/0/edits/0"),
                                    HasSubstr("/steps/3/match/edits/0"), "/steps/4/match",
                                    "/steps/5/match: none.png"));
}

} // namespace
} // namespace texplorer::lesson::lesson_scene_test
