#include "app/render/shader_log.h"

#include <gmock/gmock.h>

namespace texplorer::render::shader_log_test {
namespace {

using testing::ElementsAre;

TEST(ShaderLog, LogsOfAllDriversNameTheFileAndTheLine) {
    glsl::StageSource stage;
    stage.text = "one\ntwo\n";
    stage.lines = {{"vertex.glsl", 5}, {"lighting.glsl", 17}};
    using Message = view::ShaderMessage;
    const auto at = std::optional(view::ShaderStage::Vertex);
    EXPECT_THAT(translateLog("0:2(5): error: `n' undeclared\n\n", stage),
                ElementsAre(Message{std::nullopt, 2, "lighting.glsl:17: error: `n' undeclared"}));
    EXPECT_THAT(translateLog("0(1) : error C1008: undefined \"n\"\r\n", stage, at),
                ElementsAre(Message{at, 1, "vertex.glsl:5: error C1008: undefined \"n\""}));
    EXPECT_THAT(translateLog("ERROR: 0:2: 'n' : undeclared", stage, at),
                ElementsAre(Message{at, 2, "lighting.glsl:17: 'n' : undeclared"}));
    EXPECT_THAT(translateLog("error: linking", stage, at), ElementsAre(Message{at, 0, "error: linking"}));
    for (const char* odd :
         {"error: linking", "0:3(1): x", "0:0(1): x", "0:", "0(", "0:2(", "ERROR: ", "99999999999:1"})
        EXPECT_EQ(translateLog(odd, stage).size(), 1U) << odd;
}

} // namespace
} // namespace texplorer::render::shader_log_test
