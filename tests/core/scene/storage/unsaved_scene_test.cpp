#include "texplorer/scene/storage/unsaved_scene.h"

#include <gmock/gmock.h>

namespace texplorer::unsaved_scene_test {
namespace {

using testing::HasSubstr;

UnsavedScene someDraft() {
    UnsavedScene draft{"/home/ann/lesson.json", "/home/ann", defaultScene()};
    draft.scene.textures[0].source = SourceKind::File;
    draft.scene.textures[0].file = "pictures/brick.png";
    draft.scene.textures[0].wrapS = Wrap::Clamp;
    draft.fileHash = "99aa06d3014798d86001c324468d497f";
    return draft;
}

TEST(UnsavedText, HoldsTheSceneAndWhereItBelongs) {
    const UnsavedScene draft = someDraft();
    const Result<UnsavedScene> read = parseUnsaved(writeUnsaved(draft));
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(*read, draft);
}

TEST(UnsavedText, OfASceneThatWasNeverSavedHasNoPaths) {
    const UnsavedScene draft{{}, {}, defaultScene()};
    const Result<UnsavedScene> read = parseUnsaved(writeUnsaved(draft));
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(*read, draft);
}

TEST(UnsavedText, OfVersionOneHasNoHash) {
    const Result<UnsavedScene> read =
        parseUnsaved("Texplorer, unsaved scene, version 1\n/a/b.json\n/a\n{\"version\": 1}");
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(read->file, "/a/b.json");
    EXPECT_EQ(read->fileHash, "");
}

TEST(UnsavedText, TakesEveryNameThatAFileSystemKnows) {
    UnsavedScene draft = someDraft();
    draft.file = "/tmp/two\nlines, 100 %41\r\x7F\xFF.json";
    draft.folder = "/tmp/%/\xC3\xA4";
    const std::string text = writeUnsaved(draft);
    EXPECT_THAT(text, HasSubstr("/tmp/two%0Alines, 100 %2541%0D%7F\xFF.json\n"));
    const Result<UnsavedScene> read = parseUnsaved(text);
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(read->file, draft.file);
    EXPECT_EQ(read->folder, draft.folder);
}

struct Bad {
    const char* name;
    std::string text;
    const char* words;
};

void PrintTo(const Bad& bad, std::ostream* out) {
    *out << bad.name;
}

class BadUnsaved : public testing::TestWithParam<Bad> {};

TEST_P(BadUnsaved, IsRefusedInOneSentence) {
    const Result<UnsavedScene> read = parseUnsaved(GetParam().text);
    ASSERT_FALSE(read);
    EXPECT_THAT(describe(read.error()), HasSubstr(GetParam().words));
    EXPECT_EQ(describe(read.error()).english().find('\n'), std::string::npos);
}

const std::string first = "Texplorer, unsaved scene, version 1\n";

INSTANTIATE_TEST_SUITE_P(
    All, BadUnsaved,
    testing::Values(Bad{"Empty", "", "expected an unsaved scene"},
                    Bad{"Foreign", "{\"version\": 1}\n", "expected an unsaved scene"},
                    Bad{"OfTheFuture", "Texplorer, unsaved scene, version 3\n\n\n\n{}", "version 2"},
                    Bad{"Cut", first + "/a.json", "absolute path of the scene file"},
                    Bad{"RelativeFile", first + "a.json\n\n{}", "absolute path of the scene file"},
                    Bad{"RelativeFolder", first + "\nb\n{}", "absolute path of the folder"},
                    Bad{"HalfAnEscape", first + "/a%4\n\n{}", "absolute path of the scene file"},
                    Bad{"EscapeOfNothing", first + "/a%zz\n\n{}", "absolute path of the scene file"},
                    Bad{"SignInAnEscape", first + "/a%-1\n\n{}", "absolute path of the scene file"},
                    Bad{"NulInAPath", first + "/a%00b\n\n{}", "absolute path of the scene file"},
                    Bad{"NoScene", first + "\n\n", "empty"},
                    Bad{"HalfAScene", first + "\n\n{\"textures\": [{\"wrapS\":", "ends"},
                    Bad{"WrongScene", first + "\n\n{\"textures\": [{\"wrapS\": \"GL_NONE\"}]}", "GL_NONE"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(UnsavedText, CutAnywhereIsADraftOrASentence) {
    const std::string text = writeUnsaved(someDraft());
    for (std::size_t length = 0; length + 1 < text.size(); length += 7) { // the last byte ends a line
        const Result<UnsavedScene> read = parseUnsaved(text.substr(0, length));
        EXPECT_FALSE(read) << length;
    }
}

} // namespace
} // namespace texplorer::unsaved_scene_test
