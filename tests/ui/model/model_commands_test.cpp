#include "app/ui/model/model_commands.h"
#include "core/scene/animation.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/trigonometric.hpp>
#include <gmock/gmock.h>

#include <regex>

namespace texplorer::ui::model_commands_test {
namespace {

using testing::Contains;
using testing::Not;
using testing::StartsWith;

std::vector<std::string> texts(const std::vector<Command>& commands) {
    std::vector<std::string> found;
    for (const Command& each : commands)
        found.push_back(each.text);
    return found;
}

/// What the calls make of a matrix; GLM does the arithmetic.
glm::mat4 multiplied(glm::mat4 matrix, const std::vector<Command>& commands) {
    for (const Command& each : commands) {
        const std::string name = each.text.substr(0, each.text.find('('));
        std::vector<float> n;
        const std::regex number("-?[0-9][-+.e0-9]*");
        const std::string arguments = each.text.substr(std::min(each.text.find('('), each.text.size()));
        for (auto it = std::sregex_iterator(arguments.begin(), arguments.end(), number);
             it != std::sregex_iterator(); ++it)
            n.push_back(std::stof(it->str()));
        if (name == "glTranslatef")
            matrix = glm::translate(matrix, {n.at(0), n.at(1), n.at(2)});
        else if (name == "glRotatef")
            matrix = glm::rotate(matrix, glm::radians(n.at(0)), {n.at(1), n.at(2), n.at(3)});
        else if (name == "glScalef")
            matrix = glm::scale(matrix, {n.at(0), n.at(1), n.at(2)});
        else if (name == "glLoadIdentity")
            matrix = glm::mat4(1);
        else if (name == "glMultMatrixf")
            matrix *= glm::make_mat4(n.data());
        else if (name == "glLoadMatrixf")
            matrix = glm::make_mat4(n.data());
    }
    return matrix;
}

float farthest(const glm::mat4& a, const glm::mat4& b) {
    float most = 0;
    for (int i = 0; i < 16; ++i)
        most = std::max(most, std::abs(a[i / 4][i % 4] - b[i / 4][i % 4]));
    return most;
}

TEST(ModelCommands, PlaceAModelAsItIsDrawn) {
    for (const EnumRow& order : rotationOrderRows) {
        for (const EnumRow& attachment : attachmentRows) {
            Scene scene = defaultScene();
            Model model;
            model.position = {1, -2, 0.5F};
            model.rotation = {10, 20, -35};
            model.rotationOrder = static_cast<RotationOrder>(order.value);
            model.attachment = static_cast<Attachment>(attachment.value);
            model.size = 1.5F;
            model.scale = {1, 0.5F, 2};
            scene.models = {model};
            const glm::mat4 made = multiplied(viewMatrix(scene.view), modelCommands(scene, 0));
            EXPECT_LT(farthest(made, modelViewMatrix(scene.view, model, 0)), 1e-5F)
                << order.name << ", " << attachment.name;
        }
    }
}

TEST(ModelCommands, DrawShapesWithGluAndMeshesWithArrays) {
    Scene scene;
    const auto of = [&](Model model) {
        scene.models = {std::move(model)};
        return texts(modelCommands(scene, 0));
    };
    EXPECT_THAT(of({.shape = Shape::Sphere, .slices = 9, .stacks = 7}),
                Contains("gluSphere(quadric, 1, 9, 7);"));
    EXPECT_THAT(of({.shape = Shape::Cylinder, .slices = 9, .stacks = 7, .topRadius = 0}),
                Contains("gluCylinder(quadric, 1, 0, 2, 9, 7);"));
    EXPECT_THAT(of({.shape = Shape::PartialDisk, .innerRadius = 0.5F, .startAngle = 10, .sweepAngle = 90}),
                Contains("gluPartialDisk(quadric, 0.5, 1, 32, 16, 10, 90);"));
    // Ten rings of patches of 5 stacks each, and two poles.
    EXPECT_THAT(of({.shape = Shape::Teapot, .slices = 7, .stacks = 5}),
                Contains("glDrawElements(GL_TRIANGLES, 2058, GL_UNSIGNED_INT, indices);"));
    EXPECT_THAT(of({.shape = Shape::Cube}), Contains("glDrawArrays(GL_QUADS, 0, 24);"));
    Model lines{.shape = Shape::Mesh, .lineWidth = 3};
    lines.mesh.primitive = Primitive::LineStrip;
    lines.mesh.positions.resize(5);
    EXPECT_THAT(of(lines), testing::IsSupersetOf({"glLineWidth(3);", "glDrawArrays(GL_LINE_STRIP, 0, 5);"}));
    lines.mesh.indices = {0, 1, 2};
    EXPECT_THAT(of(lines), Contains("glDrawElements(GL_LINE_STRIP, 3, GL_UNSIGNED_INT, indices);"));
    EXPECT_THAT(of(lines), Not(Contains("glPointSize(1);")));
}

TEST(ModelCommands, SetAnOwnMaterial) {
    Scene scene = defaultScene();
    EXPECT_THAT(texts(modelCommands(scene, 0)), Not(Contains("glEnable(GL_COLOR_MATERIAL);")));
    scene.models[0].ownMaterial = true;
    EXPECT_THAT(texts(modelCommands(scene, 0)), Contains("glEnable(GL_COLOR_MATERIAL);"));
    EXPECT_THAT(texts(modelCommands(scene, 1)), Contains("glEnable(GL_COLOR_MATERIAL);"))
        << "or it would have that of the model before";
}

TEST(StepCommands, MakeTheTextureMatrix) {
    Unit unit;
    unit.matrix = {{.op = MatrixOp::Translate, .amount = {0.25F, 0.5F, 0}},
                   {.op = MatrixOp::Rotate, .amount = {0, 0, 1}, .angle = 30, .pivot = {0.5F, 0.5F, 0}},
                   {.op = MatrixOp::Scale, .amount = {2, 3, 1}, .pivot = {0.5F, 0, 0}},
                   {.op = MatrixOp::Multiply,
                    .matrix = glm::mat4(1, 0, 0, 0, 0.5F, 1, 0, 0, 0, 0, 1, 0, 0.125F, 0, 0, 1)}};
    for (const bool loads : {false, true}) {
        if (loads)
            unit.matrix.insert(unit.matrix.begin() + 2, {.op = MatrixOp::Load, .matrix = glm::mat4(2)});
        glm::mat4 made(1);
        for (const MatrixStep& step : unit.matrix)
            made = multiplied(made, stepCommands(step, "step", Light{}));
        EXPECT_LT(farthest(made, textureMatrix(unit.matrix, 0, Light{})), 1e-5F) << loads;
    }
}

// glTranslatef and glScalef, gluPerspective or glOrtho, glMultMatrixf: what the light sees, from 0 to 1.
TEST(StepCommands, OfTheLightsViewAreThoseOfACamera) {
    const MatrixStep step{.op = MatrixOp::Projector};
    Light light;
    light.position = {1, 2, 3, 1};
    light.projector = {{0, 0, -6}, 40, 2, 15};
    const std::vector<std::string> positional = texts(stepCommands(step, "step", light));
    ASSERT_EQ(positional.size(), 5U);
    EXPECT_EQ(positional[1], "glTranslatef(0.5, 0.5, 0.5);");
    EXPECT_EQ(positional[2], "glScalef(0.5, 0.5, 0.5);");
    EXPECT_EQ(positional[3], "gluPerspective(40, 1, 2, 15);");
    EXPECT_THAT(positional[4], StartsWith("glMultMatrixf({"));
    light.position.w = 0;
    light.projector.fieldOfView = 90; // half way between near and far it shows as much to each side
    EXPECT_EQ(texts(stepCommands(step, "step", light))[3], "glOrtho(-8.5, 8.5, -8.5, 8.5, 2, 15);");
}

TEST(Commands, SetHowDepthsAreComparedOfDepthTexturesAlone) {
    Scene scene = defaultScene();
    scene.textures[0].compareMode = CompareMode::RToTexture;
    const char* call = "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);";
    EXPECT_THAT(texts(commandsOf(scene)), Not(Contains(call)));
    scene.textures[0].internalFormat = InternalFormat::DepthComponent16;
    EXPECT_THAT(texts(commandsOf(scene)), Contains(call));
}

TEST(Commands, NameTheModelsOfAPassAndFollowItsUnits) {
    Scene scene = defaultScene();
    scene.passes.push_back(scene.passes[0]);
    scene.passes[1].models = {1, 0};
    scene.passes[0].units[0].matrix = {{.op = MatrixOp::Translate, .amount = {0.5F, 0, 0}}};
    const std::vector<std::string> all = texts(commandsOf(scene));
    const auto at = [&](const std::string& text) { return std::ranges::find(all, text) - all.begin(); };
    EXPECT_THAT(all, Contains("passes[1] draws models[1], models[0]"));
    EXPECT_THAT(all, Contains("passes[0].units[0].matrix[0]"));
    EXPECT_LT(at("passes[0].units[0]"), at("passes[0].units[0].matrix[0]"));
    EXPECT_LT(at("passes[0].units[0].matrix[0]"), at("passes[1].units[0]"));
    EXPECT_LT(at("passes[0].units[0].matrix[0]"), at("glActiveTexture(GL_TEXTURE0);"));
    EXPECT_LT(at("glActiveTexture(GL_TEXTURE0);"), at("glMatrixMode(GL_TEXTURE);"));
    EXPECT_LT(at("glMatrixMode(GL_TEXTURE);"), at("glTranslatef(0.5, 0, 0);"));
    const auto step = std::ranges::find(all, "glTranslatef(0.5, 0, 0);");
    EXPECT_NE(std::find(step, all.end(), "glMatrixMode(GL_MODELVIEW);"), all.end()) << "models come next";
    EXPECT_LT(at("passes[1] draws models[1], models[0]"), at("models[0]"));
    scene.models[1].visible = false;
    EXPECT_THAT(texts(commandsOf(scene)), Not(Contains("models[1]"))) << "nothing draws it";
}

} // namespace
} // namespace texplorer::ui::model_commands_test
