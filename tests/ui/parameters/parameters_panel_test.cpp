#include "app/ui/model/findings.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/param_widgets.h"
#include "tests/ui/workbench.h"
#include "texplorer/scene/params/params.h"

#include <gmock/gmock.h>

#include <set>
#include <string>

namespace texplorer::ui::parameters_panel_test {
namespace {

using namespace test;

class ParametersPanel : public Workbench {
protected:
    void show(ParameterTab tab) {
        states.parameters.tab = tab;
        frames(2);
    }
    void press(std::string_view name) {
        scrollTo(name);
        click(name);
    }
    void pull(std::string_view name, float way) {
        scrollTo(name);
        drag(place(name), {way, 0});
    }
    void typeInto(std::string_view name, std::string_view text) {
        scrollTo(name);
        doubleClickAt(place(name));
        type(text);
        key(key::enter);
    }
    /// What all tabs have, with what is folded.
    std::set<std::string> namesOfAllTabs() {
        std::set<std::string> names;
        for (const ParameterTabRow& tab : parameterTabRows) {
            show(tab.tab);
            for (const auto& [name, item] : places.items)
                names.insert(name);
        }
        return names;
    }
};

TEST_F(ParametersPanel, AComboChoosesAnEnumerator) {
    choose("textures[0].wrapS", "GL_CLAMP_TO_EDGE");
    EXPECT_EQ(texture().wrapS, Wrap::ClampToEdge);
    EXPECT_EQ(texture().wrapT, Wrap::Repeat);
    EXPECT_EQ(session->document.lastChanged, "textures[0].wrapS");
    choose("textures[0].minFilter", "GL_NEAREST");
    EXPECT_EQ(texture().minFilter, MinFilter::Nearest);
}

TEST_F(ParametersPanel, ADragIsOneStepOfUndo) {
    click("parameters:Texture");
    pull("textures[0].maxAnisotropy", 100); // 0.05 a pixel
    EXPECT_NEAR(texture().maxAnisotropy, 1 + 100 * 0.05F, 0.06F);
    drag(place("textures[0].maxAnisotropy"), {40, 0});
    EXPECT_NEAR(texture().maxAnisotropy, 1 + 140 * 0.05F, 0.12F);
    key('Z', {ctrl});
    EXPECT_NEAR(texture().maxAnisotropy, 1 + 100 * 0.05F, 0.06F);
    key('Z', {ctrl});
    EXPECT_EQ(texture().maxAnisotropy, 1);
    EXPECT_FALSE(session->document.history.canUndo());
    key('Z', {ctrl, shift});
    key('Y', {ctrl});
    EXPECT_NEAR(texture().maxAnisotropy, 1 + 140 * 0.05F, 0.12F);
}

TEST_F(ParametersPanel, ANumberStaysInItsRange) {
    pull("textures[0].maxAnisotropy", 2000);
    EXPECT_EQ(texture().maxAnisotropy, 16);
    drag(place("textures[0].maxAnisotropy"), {-2000, 0});
    EXPECT_EQ(texture().maxAnisotropy, 1);
    moveTo(place("textures[0].maxAnisotropy")); // typed after a click with Ctrl
    setHeld(ctrl, true);
    ImGui::GetIO().MouseDown[0] = true;
    frames(1);
    ImGui::GetIO().MouseDown[0] = false;
    setHeld(ctrl, false);
    frames(2);
    type("1e999");
    key(key::enter);
    EXPECT_EQ(texture().maxAnisotropy, 16);
}

TEST_F(ParametersPanel, AColourIsPickedAndUndoneAtOnce) {
    unit().envMode = EnvMode::Blend;
    press("passes[0].units[0].envColor");
    const std::string picker = "passes[0].units[0].envColor#picker";
    const WidgetPlaces::Item box = places.items.at(picker);
    // The upper right of the picker's square: saturated and bright.
    drag({box.left + 20, box.top + 60}, {60, -40});
    const glm::vec4 picked = unit().envColor;
    EXPECT_GT(picked.r, 0.5F);
    EXPECT_LT(picked.g, picked.r);
    key(key::escape); // closes the picker
    EXPECT_FALSE(has(picker));
    key('Z', {ctrl});
    EXPECT_EQ(unit().envColor, glm::vec4(0));
    EXPECT_FALSE(session->document.history.canUndo());
}

TEST_F(ParametersPanel, ACheckboxSwitches) {
    press("passes[0].units[0].enabled");
    EXPECT_FALSE(unit().enabled);
    click("passes[0].units[0].enabled");
    EXPECT_TRUE(unit().enabled);
}

TEST_F(ParametersPanel, TheSignBesideAChangedValueResetsItToGlsInitialOne) {
    show(ParameterTab::Texture);
    EXPECT_FALSE(has("textures[0].wrapT#reset"));
    choose("textures[0].wrapT", "GL_CLAMP");
    click("textures[0].wrapT#reset");
    EXPECT_EQ(texture().wrapT, Wrap::Repeat);
    EXPECT_FALSE(has("textures[0].wrapT#reset"));
    key('Z', {ctrl});
    EXPECT_EQ(texture().wrapT, Wrap::Clamp);
}

TEST_F(ParametersPanel, ARightClickOpensAMenuThatResets) {
    scrollTo("textures[0].minFilter");
    click("textures[0].minFilter", ImGuiMouseButton_Right);
    click("textures[0].minFilter#menu:reset");
    EXPECT_EQ(texture().minFilter, MinFilter::NearestMipmapLinear);
    click("textures[0].minFilter", ImGuiMouseButton_Right);
    click("textures[0].minFilter#menu:reset");
    key(key::escape);
    key('Z', {ctrl});
    EXPECT_EQ(texture().minFilter, MinFilter::LinearMipmapLinear);
    EXPECT_FALSE(session->document.history.canUndo()) << "resetting what is reset already is no edit";
}

TEST_F(ParametersPanel, TexturesAreAddedBoundAndRemoved) {
    show(ParameterTab::Texture);
    click("add texture");
    ASSERT_EQ(scene().textures.size(), 2U);
    EXPECT_EQ(unit().texture, 1);
    choose("textures[1].wrapS", "GL_CLAMP");
    EXPECT_EQ(scene().textures[1].wrapS, Wrap::Clamp);
    EXPECT_EQ(scene().textures[0].wrapS, Wrap::Repeat);
    press("texture choice");
    click("bind:0");
    EXPECT_EQ(unit().texture, 0);
    click("remove texture");
    ASSERT_EQ(scene().textures.size(), 1U);
    EXPECT_EQ(scene().textures[0].wrapS, Wrap::Clamp);
    EXPECT_EQ(unit().texture, 0);
    EXPECT_TRUE(unit().enabled);
    click("remove texture");
    EXPECT_TRUE(scene().textures.empty());
    EXPECT_FALSE(unit().enabled) << "a scene file refuses a unit without a texture";
    press("passes[0].units[0].enabled");
    EXPECT_TRUE(unit().enabled);
    EXPECT_EQ(scene().textures.size(), 1U) << "it gets one";
}

TEST_F(ParametersPanel, EditsTheChosenUnit) {
    click("unit:1");
    EXPECT_EQ(session->look.selection.unit, 1);
    choose("passes[0].units[1].envMode", "GL_ADD");
    EXPECT_EQ(scene().passes[0].units[1].envMode, EnvMode::Add);
    EXPECT_EQ(unit().envMode, EnvMode::Modulate);
}

TEST_F(ParametersPanel, MatrixStepsAreAddedMovedAndRemoved) {
    open("Texture matrix");
    press("add:translate");
    press("add:rotate");
    ASSERT_EQ(unit().matrix.size(), 2U);
    EXPECT_EQ(unit().matrix[1].amount, glm::vec3(0, 0, 1));
    pull("passes[0].units[0].matrix[1].angleRate", 40);
    EXPECT_NEAR(unit().matrix[1].angleRate, 20, 1);
    press("passes[0].units[0].matrix[1]#up");
    EXPECT_EQ(unit().matrix[0].op, MatrixOp::Rotate);
    press("passes[0].units[0].matrix[1]#remove");
    ASSERT_EQ(unit().matrix.size(), 1U);
    EXPECT_EQ(unit().matrix[0].op, MatrixOp::Rotate);
}

TEST_F(ParametersPanel, ModelsHaveMatrixStepsOfTheirOwn) {
    open("Texture matrix");
    choose("passes[0].units[0].matrixStart", "keep");
    EXPECT_EQ(unit().matrixStart, MatrixStart::Keep);
    EXPECT_FALSE(has("models[0].pushMatrix")) << "there is nothing to push it for";
    press("model's add:scale");
    const auto steps = [this] { return scene().models[0].units[0].matrix; };
    ASSERT_EQ(steps().size(), 1U);
    EXPECT_EQ(steps()[0].amount, glm::vec3(1));
    press("models[0].pushMatrix");
    EXPECT_FALSE(scene().models[0].pushMatrix);
    press("models[0].units[0].matrix[0]#remove");
    EXPECT_TRUE(steps().empty());
    EXPECT_TRUE(unit().matrix.empty());
}

TEST_F(ParametersPanel, PassesAreAddedExchangedSwitchedOffAndRemoved) {
    EXPECT_FALSE(has("pass:0")) << "there is nothing to choose from";
    open("Pass");
    press("add pass");
    ASSERT_EQ(scene().passes.size(), 2U);
    EXPECT_EQ(scene().passes[1].depthFunc, CompareFunc::LessEqual) << "or it would draw nothing";
    Pass like = scene().passes[0];
    like.depthFunc = CompareFunc::LessEqual;
    EXPECT_EQ(scene().passes[1], like);
    EXPECT_EQ(session->look.selection.pass, 1);

    press("passes[1].enabled");
    EXPECT_TRUE(scene().passes[0].enabled);
    EXPECT_FALSE(scene().passes[1].enabled);
    press("pass up");
    EXPECT_FALSE(scene().passes[0].enabled);
    EXPECT_EQ(session->look.selection.pass, 0) << "it stays chosen";

    press("pass:1");
    EXPECT_EQ(session->look.selection.pass, 1);
    press("remove pass");
    ASSERT_EQ(scene().passes.size(), 1U);
    EXPECT_FALSE(scene().passes[0].enabled);
    EXPECT_EQ(session->look.selection.pass, 0);
    press("remove pass");
    EXPECT_EQ(scene().passes.size(), 1U) << "one there is always";
    for (int i = 0; i < 4; ++i)
        key('Z', {ctrl});
    EXPECT_EQ(scene().passes.size(), 1U);
    EXPECT_TRUE(scene().passes[0].enabled);
}

TEST_F(ParametersPanel, AVectorHasADragForEachComponent) {
    open("Light");
    scrollTo("light.position[1]");
    const glm::vec4 before = scene().light.position;
    drag(place("light.position[1]"), {50, 0});
    EXPECT_GT(scene().light.position.y, before.y);
    EXPECT_EQ(scene().light.position.x, before.x);
    EXPECT_EQ(scene().light.position.z, before.z);
}

TEST_F(ParametersPanel, AFileSourceWithoutAFileAsksForOne) {
    choose("textures[0].source", "file");
    EXPECT_EQ(session->asking.dialog, Dialog::OpenImage);
    EXPECT_EQ(texture().source, SourceKind::Pattern);
    key(key::escape);
    EXPECT_EQ(session->asking.dialog, Dialog::None);
    EXPECT_FALSE(session->document.history.canUndo());
}

/// Walks the tables: a new row gets its widget, and a row without one is found here.
TEST_F(ParametersPanel, EveryParameterOfTheSelectionHasItsWidget) {
    unit().matrix.resize(1);
    unit().matrix[0].op = MatrixOp::Rotate;
    scene().models[0].units[0].matrix = unit().matrix;
    unit().envMode = EnvMode::Combine;
    scene().passes[0].fog.enabled = true;
    for (TexGen* each : {&unit().texGenS, &unit().texGenT, &unit().texGenR, &unit().texGenQ})
        each->enabled = true;
    unit().texGenT.mode = TexGenMode::ObjectLinear;
    frames(1);
    scene().models[0].shape = Shape::Sphere;
    session->settings.pinned.clear();
    const std::set<std::string> names = namesOfAllTabs();
    int rows = 0;
    const auto expectRows = [&](const Owner& owner, const StructTable& table) {
        for (const ParamRow& row : table.params) {
            if (!isRelevant(*session, owner, row) || row.key == "texture") // which is "texture choice"
                continue;
            if (row.key.ends_with("Plane") && idleReasonOf(session->document.findings, owner.pathOf(row)))
                continue; // each mode has its own
            const bool vector = row.kind == Kind::Vec3 || row.kind == Kind::Vec4 || row.kind == Kind::Matrix;
            EXPECT_TRUE(names.contains(owner.pathOf(row) + (vector ? "[0]" : ""))) << owner.pathOf(row);
            ++rows;
        }
    };
    Scene& s = scene();
    const std::string first = "passes[0].units[0]";
    expectRows({&s.view, nullptr, "view"}, viewTable());
    expectRows({&s.light, nullptr, "light"}, lightTable());
    expectRows({&s.light.projector, nullptr, "light.projector"}, projectorTable());
    expectRows({&s.material, nullptr, "material"}, materialTable());
    expectRows({s.models.data(), nullptr, "models[0]"}, modelTable());
    expectRows({s.textures.data(), nullptr, "textures[0]"}, textureTable());
    expectRows({s.passes.data(), nullptr, "passes[0]"}, passTable());
    expectRows({&s.passes[0].fog, nullptr, "passes[0].fog"}, fogTable());
    expectRows({&unit(), nullptr, first}, unitTable());
    expectRows({&unit().combine, nullptr, first + ".combine"}, combineTable());
    expectRows({&unit().texGenS, nullptr, first + ".texGenS"}, texGenTable(0));
    expectRows({&unit().texGenT, nullptr, first + ".texGenT"}, texGenTable(1));
    expectRows({&unit().texGenR, nullptr, first + ".texGenR"}, texGenTable(2));
    expectRows({&unit().texGenQ, nullptr, first + ".texGenQ"}, texGenTable(3));
    expectRows({unit().matrix.data(), nullptr, first + ".matrix[0]"}, matrixStepTable());
    expectRows({s.models[0].units[0].matrix.data(), nullptr, "models[0].units[0].matrix[0]"},
               matrixStepTable());
    EXPECT_GT(rows, 50);
    EXPECT_TRUE(names.contains("texture choice"));
}

TEST_F(ParametersPanel, CombineIsEditedWhereTheModeAsksForIt) {
    const std::string path = "passes[0].units[0].combine.";
    const auto inert = [&](const char* key) { return has(path + key + "#inert"); };
    show(ParameterTab::Unit);
    EXPECT_TRUE(has("section:Combine")) << "shut, for the mode is another";
    EXPECT_FALSE(has(path + "rgb"));
    choose("passes[0].units[0].envMode", "GL_COMBINE");
    EXPECT_TRUE(has(path + "rgb"));
    EXPECT_FALSE(inert("source1Rgb"));
    EXPECT_TRUE(inert("source2Rgb")) << "GL_MODULATE has two arguments";
    choose(path + "rgb", "GL_REPLACE");
    EXPECT_EQ(unit().combine.rgb, CombineRgb::Replace);
    EXPECT_TRUE(inert("operand1Rgb"));
    choose(path + "rgb", "GL_INTERPOLATE");
    EXPECT_FALSE(inert("source2Rgb"));
    EXPECT_FALSE(inert("operand2Rgb"));
    choose(path + "source0Rgb", "GL_CONSTANT");
    choose(path + "operand0Rgb", "GL_ONE_MINUS_SRC_ALPHA");
    choose(path + "rgbScale", "4");
    EXPECT_EQ(unit().combine.source0Rgb, CombineSource::Constant);
    EXPECT_EQ(unit().combine.operand0Rgb, OperandRgb::OneMinusSrcAlpha);
    EXPECT_EQ(unit().combine.rgbScale, CombineScale::Four);
    EXPECT_FALSE(inert("alpha"));
    choose(path + "rgb", "GL_DOT3_RGBA");
    EXPECT_TRUE(inert("alpha")) << "the dot product is alpha, too";
    EXPECT_TRUE(inert("source0Alpha"));
    key('Z', {ctrl});
    EXPECT_EQ(unit().combine.rgb, CombineRgb::Interpolate);
}

// OpenGL 2.1, section 3.8.13: on unit 0 GL_PREVIOUS is the primary colour.
TEST_F(ParametersPanel, TheFirstUnitHasNoneBeforeIt) {
    for (Unit& each : scene().passes[0].units)
        each.envMode = EnvMode::Combine;
    show(ParameterTab::Unit);
    EXPECT_TRUE(has("combine:colour of this texture × colour of primary colour (no unit before)"));
    click("unit:1");
    EXPECT_TRUE(has("combine:colour of this texture × colour of previous unit"));
}

TEST_F(ParametersPanel, ALabelALittleTooWideKeepsItsControlBesideIt) {
    show(ParameterTab::Unit);
    const WidgetPlaces::Item& label = places.items.at("passes[0].units[0].envColor#label");
    const WidgetPlaces::Item& color = places.items.at("passes[0].units[0].envColor");
    EXPECT_GT(color.left, label.right);
    EXPECT_LT(color.top, label.bottom);
}

TEST_F(ParametersPanel, CoordinatesAreGeneratedOneByOne) {
    const std::string path = "passes[0].units[0].texGenS.";
    open("Generated coordinates");
    scrollTo(path + "enabled");
    EXPECT_TRUE(has(path + "mode#inert"));
    EXPECT_FALSE(has(path + "eyePlane[0]"));
    click(path + "enabled");
    EXPECT_TRUE(unit().texGenS.enabled);
    EXPECT_FALSE(unit().texGenT.enabled);
    EXPECT_TRUE(has(path + "eyePlane[0]"));
    EXPECT_FALSE(has(path + "objectPlane[0]"));
    choose(path + "mode", "GL_OBJECT_LINEAR");
    EXPECT_FALSE(has(path + "eyePlane[0]"));
    EXPECT_TRUE(has(path + "objectPlane[0]"));
    pull(path + "objectPlane[1]", 50);
    EXPECT_NEAR(unit().texGenS.objectPlane.y, 0.5F, 0.02F);
    choose(path + "mode", "GL_SPHERE_MAP");
    EXPECT_FALSE(has(path + "eyePlane[0]"));
    EXPECT_FALSE(has(path + "objectPlane[0]"));
    press("passes[0].units[0].texGenQ.mode");
    EXPECT_FALSE(has("passes[0].units[0].texGenQ.mode=GL_SPHERE_MAP")) << "q has two modes";
    EXPECT_TRUE(has("passes[0].units[0].texGenQ.mode=GL_OBJECT_LINEAR"));
}

TEST_F(ParametersPanel, ASectionThatIsInUseSaysSoEvenShut) {
    const std::string texGen = "passes[0].units[0].texGenS.enabled";
    show(ParameterTab::Coordinates);
    EXPECT_TRUE(has(texGen));
    EXPECT_FALSE(has("in use:Generated coordinates"));
    EXPECT_FALSE(has("in use:Texture matrix"));
    unit().texGenS.enabled = true;
    unit().matrix.resize(1);
    frames(2);
    EXPECT_TRUE(has("passes[0].units[0].matrix[0].op"));
    EXPECT_TRUE(has("in use:Texture matrix"));
    press("section:Generated coordinates");
    EXPECT_FALSE(has(texGen)) << "the user may shut it";
    EXPECT_TRUE(has("in use:Generated coordinates")) << "and sees it all the same";
    unit().matrix.clear();
    frames(2);
    EXPECT_FALSE(has("in use:Texture matrix"));
}

TEST_F(ParametersPanel, ASectionThatIsNamedComesIntoSight) {
    for (const SectionRow& row : sectionRows) {
        start(defaultScene());
        session->out.wantedSection = row.section;
        frames(1);
        session->out.wantedSection = row.section; // where it is, is known now
        frames(2);
        EXPECT_EQ(states.parameters.tab, row.tab);
        const std::string name = "section:" + std::string(row.title);
        if (has(name)) { // a tab of one section needs no title
            EXPECT_TRUE(places.items.at(name).visible) << name;
        }
    }
}

TEST_F(ParametersPanel, WhatHasNoEffectIsMarkedAndFoldedAndDoesntVanish) {
    const auto inert = [&](const char* key) { return has("textures[0]." + std::string(key) + "#inert"); };
    show(ParameterTab::Texture);
    EXPECT_TRUE(inert("flip")) << "a pattern is upright";
    EXPECT_TRUE(inert("npot")) << "a pattern's size is a power of two";
    EXPECT_TRUE(inert("wrapR")) << "the target is 2D";
    EXPECT_TRUE(inert("borderColor"));
    EXPECT_FALSE(has("textures[0].depthSize"));
    press("textures[0]#no effect");
    scrollTo("textures[0].depthSize");
    EXPECT_TRUE(has("textures[0].depthSize#inert"));
    drag(place("textures[0].depthSize"), {30, 0});
    EXPECT_EQ(texture().depthSize, 286) << "it can be edited all the same";
    choose("textures[0].wrapS", "GL_CLAMP_TO_BORDER");
    EXPECT_FALSE(inert("borderColor"));
    EXPECT_FALSE(inert("internalFormat"));
    choose("textures[0].compression", "driver");
    EXPECT_TRUE(inert("internalFormat"));
    EXPECT_FALSE(inert("mipFilter"));
    choose("textures[0].minFilter", "GL_LINEAR");
    EXPECT_TRUE(inert("mipFilter"));
    choose("textures[0].wrapR", "GL_CLAMP"); // it can be edited all the same
    EXPECT_EQ(texture().wrapR, Wrap::Clamp);
}

TEST_F(ParametersPanel, FogShowsItsSettingsWhereItIsOn) {
    const auto fog = [this]() -> const Fog& { return scene().passes[0].fog; };
    open("Pass");
    scrollTo("passes[0].fog.enabled");
    EXPECT_FALSE(has("passes[0].fog.mode"));
    click("passes[0].fog.enabled");
    EXPECT_TRUE(fog().enabled);
    choose("passes[0].fog.mode", "GL_LINEAR");
    EXPECT_EQ(fog().mode, FogMode::Linear);
    key('Z', {ctrl});
    EXPECT_EQ(fog().mode, FogMode::Exp);
    EXPECT_TRUE(fog().enabled);
    key('Z', {ctrl});
    EXPECT_EQ(fog(), Fog{});
    EXPECT_FALSE(session->document.history.canUndo());
}

TEST_F(ParametersPanel, EveryInternalFormatCanBeChosen) {
    for (const EnumRow& row : internalFormatRows) {
        choose("textures[0].internalFormat", std::string(row.name));
        EXPECT_EQ(rowOf(texture().internalFormat).name, row.name);
    }
}

TEST_F(ParametersPanel, WhatIsWorthKnowingHasASignAndAFix) {
    const std::string sign = "textures[0].internalFormat#problem";
    EXPECT_FALSE(has(sign));
    choose("textures[0].internalFormat", "GL_SRGB8");
    ASSERT_TRUE(has(sign));
    click(sign);
    click("textures[0].internalFormat#fix:Make it GL_RGB");
    EXPECT_EQ(texture().internalFormat, InternalFormat::Rgb);
    EXPECT_FALSE(has(sign));
}

TEST_F(ParametersPanel, WhatIsAskedForIsShownWhereItIs) {
    session->out.wantedParam = "textures[0].wrapS"; // Essentials have it
    frames(2);
    EXPECT_EQ(states.parameters.tab, ParameterTab::Essentials);
    EXPECT_EQ(session->out.wantedParam, "");
    session->out.wantedParam = "passes[0].blendSrc";
    frames(3);
    EXPECT_EQ(states.parameters.tab, ParameterTab::Pass);
    EXPECT_TRUE(places.items.at("passes[0].blendSrc").visible);
    EXPECT_EQ(session->out.wantedParam, "");
    session->out.wantedParam = "textures[0].depthSize"; // folded
    frames(3);
    EXPECT_TRUE(has("textures[0].depthSize"));
    session->out.wantedParam = "nothing.of.the.kind";
    frames(3);
    EXPECT_EQ(session->out.wantedParam, "") << "it is not waited for";
}

TEST_F(ParametersPanel, TwoColumnsWhereThereIsRoom) {
    start(defaultScene(), 2560, 1440);
    session->settings.workspace.seams.parameters = 640;
    show(ParameterTab::Texture);
    const WidgetPlaces::Item& base = places.items.at("textures[0].baseLevel");
    const WidgetPlaces::Item& last = places.items.at("textures[0].maxLevel");
    EXPECT_EQ(base.top, last.top);
    EXPECT_LT(base.right, last.left);
    session->settings.workspace.seams.parameters = 0;
    frames(2);
    EXPECT_LT(places.items.at("textures[0].baseLevel").top, places.items.at("textures[0].maxLevel").top);
}

TEST_F(ParametersPanel, NoLimitCanBeTypedOver) {
    typeInto("textures[0].maxLevel", "3");
    EXPECT_EQ(texture().maxLevel, 3);
    typeInto("textures[0].minLod", "1.5");
    EXPECT_EQ(texture().minLod, 1.5F);
}

TEST_F(ParametersPanel, FitsItsColumnAtEverySize) {
    for (const auto& [width, height, scale] : {std::tuple(1280, 800, 1), std::tuple(1920, 1080, 1),
                                               std::tuple(2560, 1440, 1), std::tuple(2560, 1600, 2)}) {
        start(defaultScene(), width, height, static_cast<float>(scale));
        for (const ParameterTabRow& tab : parameterTabRows) {
            show(tab.tab);
            for (const auto& [name, item] : places.items) {
                if (std::ranges::none_of(std::array{"textures[0]", "passes[0]", "unit:", "parameters:"},
                                         [&](const char* begin) { return name.starts_with(begin); }))
                    continue;
                EXPECT_GE(item.left, static_cast<float>(layout.parameters.x)) << name;
                EXPECT_LE(item.right, static_cast<float>(layout.parameters.right())) << name;
            }
        }
    }
}

TEST_F(ParametersPanel, LargeTextHasItsTabsInAListAndLeavesUnitsTheirNumbers) {
    start(defaultScene(), 1280, 800, 2.5F);
    EXPECT_FALSE(has("parameters:Texture")) << "seven lines of buttons would leave nothing of Essentials";
    click("parameters' tabs");
    click("parameters:Light");
    EXPECT_TRUE(has("section:Light"));
    EXPECT_FALSE(has("parameters:Texture"));
    for (const char* unit : {"unit:0", "unit:1", "unit:2", "unit:3"}) {
        const auto whole = places.items.at(unit);
        const auto toggle = places.items.at(std::string(unit) + " on");
        EXPECT_GE(toggle.left - whole.left, ImGui::CalcTextSize("0").x) << unit;
        EXPECT_LE(toggle.right, whole.right) << unit;
    }
}

TEST_F(ParametersPanel, ATinyWindowStillDraws) {
    for (const int width : {640, 320}) {
        start(defaultScene(), width, width * 5 / 8);
        EXPECT_TRUE(has("view"));
    }
}

} // namespace
} // namespace texplorer::ui::parameters_panel_test
