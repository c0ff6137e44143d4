// What the window says in every language: of each mistake in a scene and each damage of a file nothing stays
// English.

#include "app/ui/files/lessons.h"
#include "app/ui/files/program_file.h"
#include "app/ui/files/recording_file.h"
#include "app/ui/files/scene_files.h"
#include "app/ui/files/scene_saving.h"
#include "app/ui/files/sheet_file.h"
#include "app/ui/model/findings.h"
#include "app/ui/model/kept.h"
#include "tests/core/diagnosis/mistakes.h"
#include "tests/support/sample_jpegs.h"
#include "tests/support/sample_textures.h"
#include "tests/support/temp_dir.h"
#include "tests/ui/drawn_texts.h"
#include "tests/ui/english_words.h"
#include "tests/ui/language/said.h"
#include "tests/ui/workbench.h"
#include "texplorer/diagnosis/applied_texture.h"
#include "texplorer/lesson/example.h"
#include "texplorer/scene/params/json.h"

#include <algorithm>
#include <fstream>
#include <utility>

namespace texplorer::sentences_test {
namespace {

using namespace test;
using namespace ui;

Said findingsAndFixes() {
    Said said;
    for (const Mistake& mistake : mistakes()) {
        Subject subject;
        mistake.spoil(subject);
        for (const Finding& each : subject.findings()) {
            said.add(each.sentence);
            for (const Fix& fix : each.fixes)
                said.add(fix.label);
        }
    }
    for (const DriverFlaw& flaw : driverFlaws()) // some only where something is drawn
        said.add(Sentence(flaw.sentence));
    for (const EnumRow& row : severityRows) {
        said.add(row.label);
        said.add(row.help);
    }
    return said;
}

/// What the reader of every format says of files that are cut or have another byte.
Said damages() {
    Said said;
    const auto read = [&](ByteView file) {
        if (const auto texture = decodeTexture(file); !texture)
            said.add(texture.error().message);
    };
    for (const CodecRow& row : codecRows()) {
        for (const Bytes& file : row.encode ? sampleFiles(row) : sampleJpegs()) {
            for (std::size_t i = 0; i < std::min<std::size_t>(file.size(), 150); ++i) {
                read(ByteView(file).first(i));
                for (const int value : {0, 1, 40, 255}) {
                    Bytes changed = file;
                    changed[i] = static_cast<std::byte>(value);
                    read(changed);
                }
            }
        }
    }
    return said;
}

/// What the reader of scenes says of a text that is cut or has another character, and of values of
/// parameters.
Said refusedScenes() {
    Said said;
    const auto read = [&](const std::string& text) {
        if (const Result<Scene> scene = parseScene(text); !scene)
            said.add(scene.error().message);
    };
    const std::string whole = R"({"version": 1, "light": {"twoSide": true, "position": [1, 2e1, -3, 0.5]},
        "passes": [{"models": [0], "depthFunc": "GL_LESS", "units": [{"texture": 0}, {}]}],
        "models": [{"name": "\u00e9\ud83d\ude00", "shape": "mesh", "slices": 8, "texCoords0": [[0, 1]],
        "mesh": {"positions": [[1, 2, 3]], "indices": [0]}}], "textures": [{"file": "a", "border": null}],
        "timeline": {"keys": [{"time": 1, "path": "light.twoSide", "value": "true"}]}})";
    for (std::size_t i = 0; i < whole.size(); ++i) {
        read(whole.substr(0, i));
        for (const std::string_view other :
             {"", "}", "]", "\"", "x", "9", "-", "\\", "\n", "\xFF", "[", "{", ",1", "\1"})
            read(std::string(whole).replace(i, 1, other));
    }
    const Scene scene = exampleScene(examples().front().file).value();
    forEachParam(scene, [&](const std::string& path, const ParamRow&, const Value&) {
        for (const char* value : {"", "?", "1e30", "-1", "1,2", "\xFF"}) {
            Scene changed = scene;
            if (const Result<void> set = setParam(changed, path, value); !set)
                said.add(set.error().message);
        }
        for (const std::string& wrong : {path + "x", path + "[9]", path + ".x", "x" + path}) {
            Scene changed = scene;
            if (const Result<void> set = setParam(changed, wrong, "1"); !set)
                said.add(set.error().message);
        }
    });
    return said;
}

class Sentences : public Workbench, public testing::WithParamInterface<Language> {
protected:
    /// Adds what the window shows; the same text once.
    void look() {
        frames(3); // a tooltip is as large as its text a frame later
        for (std::string& text : drawnTexts())
            seen_.insert(std::move(text));
    }
    void lookAt(const std::string& name) {
        if (has(name) && places.items.find(name)->second.visible) {
            moveTo(place(name));
            look();
        }
    }
    [[nodiscard]] std::string englishSeen() const {
        std::string list;
        for (const std::string& text : seen_) {
            const bool isDriver = text.starts_with("none"); // its made-up name
            if (const std::string words = englishWords(text); !words.empty() && !isDriver)
                list += "\n  " + words + ": " + text;
        }
        return list;
    }

private:
    std::set<std::string> seen_;
};

TEST_P(Sentences, OfFindingsAndFixesAreTranslated) {
    std::set<std::string, std::less<>> gaps;
    speak(GetParam(), &gaps);
    const Said said = findingsAndFixes();
    EXPECT_TRUE(said.english().empty()) << said.english();
    EXPECT_THAT(gaps, testing::IsEmpty());
    EXPECT_TRUE(said.unsaidOf("core/diagnosis/").empty()) << said.unsaidOf("core/diagnosis/");
}

TEST_P(Sentences, OfDamagedFilesAreTranslated) {
    std::set<std::string, std::less<>> gaps;
    speak(GetParam(), &gaps);
    const Said said = damages();
    EXPECT_TRUE(said.english().empty()) << said.english();
    EXPECT_THAT(gaps, testing::IsEmpty());
}

TEST_P(Sentences, OfScenesThatCanNotBeReadAreTranslated) {
    std::set<std::string, std::less<>> gaps;
    speak(GetParam(), &gaps);
    const Said said = refusedScenes();
    EXPECT_TRUE(said.english().empty()) << said.english();
    EXPECT_THAT(gaps, testing::IsEmpty());
    EXPECT_GT(said.sentences().size(), 30U);
}

TEST_P(Sentences, OfFilesAreTranslated) {
    speak(GetParam());
    const TempDir folder;
    std::ofstream(folder / "broken.json") << "{";
    std::ofstream(folder / "broken.png") << "\x89PNG\r\n";
    std::ofstream(folder / "nothing.txt") << "nothing";
    std::filesystem::create_directory(folder / "folder.json");
    Said said;
    const auto note = [&](const auto& result) {
        if (!result)
            said.add(describe(result.error()));
        frames(2); // a worker's answer is in the notice
        said.add(session->look.notice.text);
        for (const Error& each : std::exchange(session->asking.refused, {}))
            said.add(describe(each));
        session->look.notice = {};
    };
    for (const char* name : {"broken.json", "broken.png", "nothing.txt", "folder.json", "gone.json"}) {
        note(openFile(*session, folder / name));
        note(openFiles(*session, {folder / name, folder / name}));
        note(openLessonNamed(*session, folder / name));
    }
    note(openSceneLink(*session, "texplorer:1:?"));
    for (const char* name : {"gone/a.json", "folder.json", "broken.json", "written.json"})
        note(saveScene(*session, folder / name));
    for (const char* name : {"gone/a.c", "folder.json", "a.c"})
        note(saveProgram(*session, folder / name));
    for (const char* name : {"gone/a.png", "folder.json", "a.png"})
        note(saveSheet(*session, folder / name));
    for (const char* name : {"gone/a.gif", "folder.json", "a.gif"})
        note(saveRecording(*session, folder / name));
    keepAsA(*session);
    note(Result<void>());
    EXPECT_TRUE(said.english().empty()) << said.english();
    EXPECT_GT(said.sentences().size(), 10U);
}

TEST_P(Sentences, OfFindingsAreShown) {
    speak(GetParam());
    Said said;
    for (const Mistake& mistake : mistakes()) {
        Subject subject;
        mistake.spoil(subject);
        std::vector<Finding> findings = subject.findings(); // also those of another driver
        std::erase_if(findings, [&](const Finding& each) {
            return each.rule != mistake.rule || each.path != mistake.path;
        });
        if (findings.empty() || !said.add(findings.front().sentence))
            continue;
        session->document.scene = subject.scene;
        session->document.images = subject.images;
        frames(1);
        session->document.findings = findings;
        reveal(*session, mistake.path);
        look();
        lookAt(std::string(mistake.path) + "#problem");
        lookAt(std::string(mistake.path) + "#label");
    }
    EXPECT_GT(said.sentences().size(), 100U);
    EXPECT_TRUE(englishSeen().empty()) << englishSeen();
}

INSTANTIATE_TEST_SUITE_P(All, Sentences, testing::Values(Language::Chinese, Language::Russian),
                         [](const auto& each) { return std::string(rowOf(each.param).name); });

} // namespace
} // namespace texplorer::sentences_test
