#include "tests/support/temp_dir.h"
#include "tests/ui/workbench.h"
#include "texplorer/files/file_io.h"
#include "texplorer/glsl/shader_pieces.h"

#include <gmock/gmock.h>

namespace texplorer::ui::glsl_tab_test {
namespace {

using namespace test;

using testing::Contains;
using testing::HasSubstr;

class GlslTab : public Workbench {
protected:
    /// The picture without OpenGL's shaders has no source: they are made while they draw.
    void look(const testing::Matcher<std::vector<Sentence>>& problems = testing::IsEmpty()) {
        session->window.wantedTab = Tab::Glsl;
        frames(3); // the tab comes to the front
        for (int i = 0; i < 3; ++i)
            static_cast<void>(picture(problems));
    }
    std::string copied(const char* stage) {
        states.details.glsl.stage =
            std::string_view(stage) == "Vertex" ? view::ShaderStage::Vertex : view::ShaderStage::Fragment;
        const ImVec2 at = place("glsl:copy");
        ImGui::GetIO().MousePos = at;
        static_cast<void>(picture());
        static_cast<void>(picture());
        ImGui::GetIO().MouseDown[0] = true;
        static_cast<void>(picture());
        ImGui::GetIO().MouseDown[0] = false;
        static_cast<void>(picture());
        return ImGui::GetClipboardText();
    }
};

TEST_F(GlslTab, ShowsAndCopiesWhatRuns) {
    look();
    EXPECT_TRUE(has("glsl:1"));
    EXPECT_THAT(copied("Fragment"), HasSubstr("color = color * texel0;"));
    EXPECT_THAT(copied("Vertex"), HasSubstr("gl_Position"));
    unit().envMode = EnvMode::Replace;
    EXPECT_THAT(copied("Fragment"), testing::Not(HasSubstr("color * texel0")));
}

TEST_F(GlslTab, SaysThatThereIsNoneWhereNothingIsDrawn) {
    session->window.wantedTab = Tab::Glsl;
    frames(3);
    EXPECT_FALSE(has("glsl:1"));
    EXPECT_FALSE(has("glsl:copy"));
}

TEST_F(GlslTab, ShowsTheLineOfAMistakeAndWhatTheCompilerSays) {
    const texplorer::test::TempDir folder;
    for (glsl::ShaderFile file : glsl::embeddedShaderFiles()) {
        const std::string good = "gl_Position = modelViewProjection";
        if (const std::size_t at = file.text.find(good); at != std::string::npos)
            file.text.replace(at, good.size(), "gl_Position = modelVewProjection");
        ASSERT_TRUE(writeFileAtomically(folder.path() / file.name, viewBytes(file.text)));
    }
    shaders = folder.path();
    look(Contains(HasSubstr("modelVewProjection")));
    EXPECT_EQ(states.details.glsl.stage, view::ShaderStage::Vertex)
        << "it leads to the stage with the mistake";
    ASSERT_TRUE(has("message:0"));
    ASSERT_FALSE(states.details.glsl.shownLog.empty());
    EXPECT_THAT(states.details.glsl.shownLog.front().sentence, HasSubstr("vertex.glsl:"));
    EXPECT_TRUE(has("glsl:" + std::to_string(states.details.glsl.shownLog.front().line)));
}

} // namespace
} // namespace texplorer::ui::glsl_tab_test
