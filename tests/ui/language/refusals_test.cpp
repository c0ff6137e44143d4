// What programs can't say, in every language: such sentences come from core/emit and name a parameter.

#include "app/ui/files/program_file.h"
#include "app/ui/language/translate.h"
#include "tests/support/temp_dir.h"
#include "tests/ui/workbench.h"
#include "texplorer/emit/program.h"

namespace texplorer::refusals_test {
namespace {

using namespace ui;
using testing::HasSubstr;
using testing::Not;

struct Refusal {
    const char* name;
    emit::Flavour flavour;
    void (*edit)(Scene& scene);
};

void showDepths(Scene& scene, InternalFormat format) {
    scene.textures[0].source = SourceKind::LightDepth;
    scene.textures[0].internalFormat = format;
}

constexpr std::array refusals{
    Refusal{"border", emit::Flavour::Glsl, [](Scene& scene) { scene.textures[0].border = 1; }},
    Refusal{"wrap", emit::Flavour::Glsl,
            [](Scene& scene) {
                scene.textures[0].pattern = Pattern::CubeFaces;
                scene.textures[0].magFilter = MagFilter::Linear;
                scene.textures[0].wrapS = Wrap::Clamp;
                scene.passes[0].units[0].target = Target::CubeMap;
            }},
    Refusal{
        "key frames", emit::Flavour::Fixed,
        [](Scene& scene) {
            scene.timeline.keys = {{0, "textures[0].pattern", "brick"}, {1, "textures[0].pattern", "planet"}};
        }},
    Refusal{"depths", emit::Flavour::Fixed, [](Scene& scene) { showDepths(scene, InternalFormat::Rgba); }},
};

Scene edited(const Refusal& refusal) {
    Scene scene = defaultScene();
    refusal.edit(scene);
    return scene;
}

class Refusals : public test::Workbench, public testing::WithParamInterface<Language> {
protected:
    /// No word of it is English but names of parameters and of OpenGL.
    static void expectTranslated(const Sentence& english, std::string_view sentence) {
        const std::string shown = tr(english);
        EXPECT_THAT(shown, Not(HasSubstr(std::string(sentence)))) << shown;
        for (const char* word : {" has ", " no ", " the ", " of ", " can't "})
            EXPECT_THAT(shown, Not(HasSubstr(word))) << shown;
    }
};

TEST_P(Refusals, AreSpoken) {
    speak(GetParam());
    for (const Refusal& refusal : refusals) {
        emit::TextureCodes codes;
        const auto lines = emit::program(refusal.flavour, edited(refusal), {}, {}, codes);
        ASSERT_FALSE(lines) << refusal.name;
        EXPECT_FALSE(lines.error().where.empty()) << refusal.name;
        expectTranslated(lines.error().message, lines.error().message);
        expectTranslated(describe(lines.error()), lines.error().message);
    }
}

TEST_P(Refusals, AreSpokenWhereTheyAreShown) {
    const test::TempDir folder;
    std::set<std::string, std::less<>> gaps;
    speak(GetParam(), &gaps);
    for (const Refusal& refusal : refusals) {
        start(edited(refusal));
        session->asking.flavour = refusal.flavour;
        ASSERT_TRUE(saveProgram(*session, folder / "a.c"));
        session->window.wantedTab = Tab::Commands;
        frames(3);
        EXPECT_FALSE(session->look.notice.isGood) << refusal.name;
        expectTranslated(session->look.notice.text, "The program can't be written");
        ASSERT_TRUE(has("notice"));
    }
    for (const std::string& gap : gaps)
        EXPECT_THAT(gap, Not(testing::AnyOf(HasSubstr("program"), HasSubstr("profile"))));
}

INSTANTIATE_TEST_SUITE_P(All, Refusals, testing::Values(Language::Chinese, Language::Russian),
                         [](const auto& each) { return std::string(rowOf(each.param).name); });

} // namespace
} // namespace texplorer::refusals_test
