#include "app/ui/model/preview.h"
#include "app/ui/model/shown_passes.h"
#include "app/ui/widgets/keys.h"
#include "tests/ui/workbench.h"

#include <gmock/gmock.h>

namespace texplorer::ui::model_section_test {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::IsEmpty;

class ModelSection : public Workbench {
protected:
    void startWith(Scene scene, const char* section) {
        start(std::move(scene));
        if (!has("in use:" + std::string(section))) // else it is open
            open(section);
    }
    void press(std::string_view name) {
        scrollTo(name);
        click(name);
    }
    std::vector<std::string> names() {
        std::vector<std::string> all;
        for (const Model& model : scene().models)
            all.push_back(model.name);
        return all;
    }
    /// Three cubes with names, and a pass for the last and the first.
    static Scene three() {
        Scene scene = defaultScene();
        scene.models.assign(3, Model{});
        scene.models[0].name = "a";
        scene.models[1].name = "b";
        scene.models[2].name = "c";
        scene.passes.push_back(scene.passes[0]);
        scene.passes[1].models = {2, 0};
        return scene;
    }
};

TEST_F(ModelSection, AddsAModelLikeTheChosenOneBesideIt) {
    startWith(three(), "Model");
    press("add model");
    EXPECT_THAT(names(), ElementsAre("a", "a", "b", "c"));
    EXPECT_GT(scene().models[1].position.x, scene().models[0].position.x);
    EXPECT_EQ(session->look.selection.model, 1);
    EXPECT_THAT(scene().passes[0].models, IsEmpty());
    EXPECT_THAT(scene().passes[1].models, ElementsAre(3, 0, 1)) << "it names the same ones, and the new one";
    key('Z', {ctrl});
    EXPECT_THAT(names(), ElementsAre("a", "b", "c"));
    EXPECT_THAT(scene().passes[1].models, ElementsAre(2, 0));
}

TEST_F(ModelSection, StaysWhereAFileCanSayIt) {
    Scene scene = three();
    scene.models[0].size = 100;
    scene.models[0].scale.x = 100;
    startWith(scene, "Model");
    press("add model");
    EXPECT_EQ(this->scene().models[1].position.x, 1000);
}

TEST_F(ModelSection, ReordersModelsAndPassesGoOnNamingTheSame) {
    startWith(three(), "Model");
    press("model down");
    EXPECT_THAT(names(), ElementsAre("b", "a", "c"));
    EXPECT_EQ(session->look.selection.model, 1) << "it stays chosen";
    EXPECT_THAT(scene().passes[1].models, ElementsAre(2, 1));
    press("model up");
    EXPECT_THAT(names(), ElementsAre("a", "b", "c"));
    EXPECT_THAT(scene().passes[1].models, ElementsAre(2, 0));
}

TEST_F(ModelSection, RemovesModelsDownToNone) {
    startWith(three(), "Model");
    press("remove model");
    EXPECT_THAT(names(), ElementsAre("b", "c"));
    EXPECT_THAT(scene().passes[1].models, ElementsAre(1));
    press("model down");
    press("remove model");
    EXPECT_THAT(names(), ElementsAre("c"));
    EXPECT_TRUE(scene().passes[1].enabled);
    press("remove model");
    EXPECT_THAT(scene().models, IsEmpty());
    EXPECT_THAT(scene().passes[1].models, IsEmpty());
    EXPECT_FALSE(scene().passes[1].enabled) << "it named the last one alone, and would now draw all";
    EXPECT_TRUE(scene().passes[0].enabled);
    press("add model");
    ASSERT_EQ(scene().models.size(), 1U);
    EXPECT_EQ(scene().models[0].shape, Shape::Cube);
}

TEST_F(ModelSection, ANameAndAnOwnMaterialHaveTheirRows) {
    startWith(three(), "Model");
    press("models[0].name");
    key(ui::key::end);
    type("!");
    key(ui::key::enter);
    EXPECT_EQ(scene().models[0].name, "a!");
    EXPECT_FALSE(has("models[0].material.diffuse"));
    press("models[0].ownMaterial");
    EXPECT_TRUE(scene().models[0].ownMaterial);
    scrollTo("models[0].material.diffuse");
    EXPECT_FALSE(has("models[0].material.shadeModel")) << "glShadeModel is the scene's";
}

TEST_F(ModelSection, ShowsWhatAShapeHas) {
    Scene scene = three();
    scene.models[0].shape = Shape::Torus;
    startWith(scene, "Model");
    EXPECT_TRUE(has("models[0].tubeRadius"));
    EXPECT_FALSE(has("models[0].topRadius"));
    EXPECT_FALSE(has("models[0].lineWidth"));
    this->scene().models[0].shape = Shape::Mesh;
    this->scene().models[0].mesh.primitive = Primitive::LineLoop;
    this->scene().models[0].mesh.positions.resize(4);
    frames(2);
    EXPECT_TRUE(has("models[0].mesh.primitive"));
    EXPECT_TRUE(has("models[0].lineWidth"));
    EXPECT_FALSE(has("models[0].pointSize"));
    EXPECT_FALSE(has("models[0].slices"));
}

TEST_F(ModelSection, APassDrawsTheModelsThatAreTicked) {
    startWith(three(), "Pass");
    EXPECT_FALSE(has("pass models:0")) << "it draws all of them";
    press("pass models:all");
    EXPECT_THAT(scene().passes[0].models, ElementsAre(0, 1, 2));
    press("pass models:1");
    EXPECT_THAT(scene().passes[0].models, ElementsAre(0, 2));
    press("pass models:2 up");
    EXPECT_THAT(scene().passes[0].models, ElementsAre(2, 0));
    press("pass models:1");
    EXPECT_THAT(scene().passes[0].models, ElementsAre(2, 0, 1));
    press("pass models:2");
    press("pass models:0");
    EXPECT_THAT(scene().passes[0].models, ElementsAre(1));
    press("pass models:1");
    EXPECT_THAT(scene().passes[0].models, ElementsAre(1)) << "the last one stays: a pass may be off instead";
    key('Z', {ctrl});
    EXPECT_THAT(scene().passes[0].models, ElementsAre(0, 1));
    press("pass models:all");
    EXPECT_THAT(scene().passes[0].models, IsEmpty());
}

TEST_F(ModelSection, StepsThroughThePasses) {
    Scene scene = three();
    scene.passes.push_back(scene.passes[0]);
    startWith(scene, "Pass");
    EXPECT_EQ(shownPasses(*session), 3U);
    press("step through passes");
    EXPECT_EQ(shownPasses(*session), 1U);
    press("pass:1");
    EXPECT_EQ(shownPasses(*session), 2U);
    Scene stepped;
    EXPECT_EQ(shownScene(*session, stepped).passes.size(), 2U);
    EXPECT_EQ(this->scene().passes.size(), 3U) << "the scene itself stays as it is";
    press("step through passes");
    EXPECT_EQ(shownPasses(*session), 3U);
}

/// The second pass covers the first one's red with green.
TEST_F(ModelSection, AStepLeavesOutWhatComesLater) {
    Scene scene = defaultScene();
    scene.models.assign(2, Model{.shape = Shape::Quad});
    for (std::size_t i = 0; i < 2; ++i) {
        scene.models[i].size = 50;
        scene.models[i].ownMaterial = true;
        scene.models[i].material.color = i == 0 ? glm::vec4(1, 0, 0, 1) : glm::vec4(0, 1, 0, 1);
    }
    scene.view.azimuth = scene.view.elevation = 0;
    scene.passes[0] = Pass{};
    scene.passes[0].models = {0};
    scene.passes.push_back(scene.passes[0]);
    scene.passes[1].models = {1};
    start(scene);
    const auto middle = [&] {
        const Image image = picture();
        const int x = layout.picture.x + layout.picture.width / 2;
        const int y = image.height - 1 - (layout.picture.y + layout.picture.height / 2);
        const std::byte* pixel = image.pixels.data() + 4 * (std::ptrdiff_t{y} * image.width + x);
        return std::array{std::to_integer<int>(pixel[0]), std::to_integer<int>(pixel[1])};
    };
    EXPECT_THAT(middle(), ElementsAre(0, 255));
    press("step through passes");
    EXPECT_THAT(middle(), ElementsAre(255, 0));
}

} // namespace
} // namespace texplorer::ui::model_section_test
