// Walks every parameter table: texts are there, keys are unique, and a row reads and writes its member alone.

#include "texplorer/scene/params/params.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <map>
#include <set>

namespace texplorer::params_test {
namespace {

using Params = std::map<std::string, std::string>;

constexpr std::size_t fullCount = 24; ///< vertices of the cube, and of the mesh that fullScene has

/// A scene in which every row of every table occurs.
Scene fullScene() {
    Scene scene;
    scene.models.resize(1);
    scene.models[0].mesh.positions.resize(fullCount);
    scene.textures.resize(1);
    scene.textures[0].levels.resize(1);
    scene.textures[0].preparation.resize(1);
    scene.textures[0].subimages.resize(1);
    for (Unit& unit : scene.passes.front().units)
        unit.matrix.resize(1);
    for (ModelUnit& unit : scene.models[0].units)
        unit.matrix.resize(1);
    return scene;
}

Params paramsOf(const Scene& scene) {
    Params params;
    forEachParam(scene, [&](const std::string& path, const ParamRow& row, const Value& value) {
        EXPECT_TRUE(params.emplace(path, formatValue(row, value)).second) << path << " occurs twice";
    });
    return params;
}

/// Every value worth trying: both ends of a range, each choice.
std::vector<Value> valuesOf(const ParamRow& row) {
    const float min = row.range.min;
    const float max = row.range.max;
    switch (row.kind) {
    case Kind::Bool:
        return {true, false};
    case Kind::Int:
        return {static_cast<int>(min), static_cast<int>(max)};
    case Kind::Float:
        return {min, max};
    case Kind::Vec3:
        return {glm::vec3(min), glm::vec3(max), glm::vec3(min, max, min)};
    case Kind::Vec4:
    case Kind::Color:
        return {glm::vec4(min), glm::vec4(max), glm::vec4(min, max, max, min)};
    case Kind::Enum: {
        std::vector<Value> values;
        for (const EnumRow& choice : row.choices)
            values.emplace_back(EnumValue{choice.value});
        return values;
    }
    case Kind::Text:
        return {std::string("textures/wood.bmp"), std::string()};
    case Kind::Matrix: {
        glm::mat4 mixed(min);
        mixed[0] = glm::vec4(max, 0.25F, 1e-7F, 1);
        return {glm::mat4(glm::vec4(min), glm::vec4(max), glm::vec4(0), glm::vec4(1)), mixed};
    }
    case Kind::PointList:
        return {std::vector(fullCount, glm::vec3(1e-7F, -2, 3e38F)), std::vector<glm::vec3>{}};
    case Kind::ColorList:
        return {std::vector(fullCount, glm::vec4(0.25F, 1e-7F, 0, 1)),
                std::vector(fullCount, glm::vec4(max, min, min, min)), std::vector<glm::vec4>{}};
    case Kind::TexCoordList:
        return {TexCoords(fullCount, glm::vec4(0.25F, 1e-7F, 0, 1)), TexCoords{}};
    case Kind::IndexList: // the first one of anything exists
        return {std::vector<int>{0}, std::vector<int>{}};
    }
    return {};
}

struct Table {
    const char* name;
    const StructTable& (*table)();
};

class ParamTables : public testing::TestWithParam<Table> {
protected:
    const StructTable& table_ = GetParam().table();
};

TEST_P(ParamTables, KeysAreUniqueIdentifiersThatFindTheirRow) {
    std::set<std::string_view> keys;
    const auto check = [&](std::string_view key) {
        EXPECT_TRUE(keys.insert(key).second) << key;
        ASSERT_FALSE(key.empty());
        EXPECT_TRUE(std::islower(static_cast<unsigned char>(key.front()))) << key;
        EXPECT_TRUE(std::ranges::all_of(key, [](unsigned char c) { return std::isalnum(c) != 0; })) << key;
    };
    for (const ParamRow& row : table_.params) {
        check(row.key);
        EXPECT_EQ(findParam(table_, row.key), &row);
        EXPECT_EQ(findChild(table_, row.key), nullptr);
    }
    for (const ChildRow& child : table_.children) {
        check(child.key);
        EXPECT_EQ(findChild(table_, child.key), &child);
    }
    EXPECT_EQ(findParam(table_, "nonsense"), nullptr);
    EXPECT_EQ(findParam(table_, ""), nullptr);
}

TEST_P(ParamTables, LabelsFitTheirPanelAndHelpsAreSentences) {
    EXPECT_EQ(table_.name, GetParam().name);
    std::set<std::string_view> labels;
    for (const ParamRow& row : table_.params) {
        EXPECT_FALSE(row.label.empty()) << row.key;
        EXPECT_LE(row.label.size(), 24U) << row.key;
        EXPECT_TRUE(labels.insert(row.label).second) << row.key << ": two rows share a label";
        EXPECT_FALSE(row.group.empty()) << row.key;
        EXPECT_LE(row.group.size(), 24U) << row.key;
        EXPECT_GE(row.help.size(), 20U) << row.key;
        EXPECT_LE(row.help.size(), 160U) << row.key << ": a tooltip, not an essay";
        EXPECT_THAT(std::string(row.help), testing::EndsWith(".")) << row.key;
    }
}

TEST_P(ParamTables, RowsOfOneGroupFollowEachOther) {
    std::set<std::string_view> closed;
    std::string_view group;
    for (const ParamRow& row : table_.params) {
        if (row.group != group) {
            EXPECT_TRUE(closed.insert(row.group).second) << row.group << " begins twice, at " << row.key;
            group = row.group;
        }
    }
}

TEST_P(ParamTables, CallsAreGlCallsWithTheirParenthesesClosed) {
    for (const ParamRow& row : table_.params) {
        if (row.glCall.empty())
            continue;
        EXPECT_TRUE(row.glCall.starts_with("gl")) << row.glCall;
        EXPECT_TRUE(row.glCall.ends_with(")")) << row.glCall;
        EXPECT_EQ(std::ranges::count(row.glCall, '('), std::ranges::count(row.glCall, ')')) << row.glCall;
        const bool hasPlace = row.glCall.find("{}") != std::string_view::npos;
        EXPECT_TRUE(hasPlace || (row.kind == Kind::Bool && row.glCall.starts_with("glEnable(")))
            << row.key << ": the value has no place in " << row.glCall;
    }
}

TEST_P(ParamTables, NumbersHaveARangeAndEnumsHaveChoices) {
    for (const ParamRow& row : table_.params) {
        const bool number = row.kind == Kind::Int || row.kind == Kind::Float || row.kind == Kind::Vec3 ||
                            row.kind == Kind::Vec4 || row.kind == Kind::Color || row.kind == Kind::Matrix ||
                            row.kind == Kind::ColorList || row.kind == Kind::IndexList;
        if (number) {
            EXPECT_LT(row.range.min, row.range.max) << row.key;
            EXPECT_GT(row.range.step, 0) << row.key;
        }
        EXPECT_EQ(row.kind == Kind::Enum, !row.choices.empty()) << row.key;
    }
}

TEST_P(ParamTables, ListsHaveALimit) {
    for (const ParamRow& row : table_.params) {
        const bool list = row.kind == Kind::PointList || row.kind == Kind::ColorList ||
                          row.kind == Kind::TexCoordList || row.kind == Kind::IndexList;
        EXPECT_EQ(row.maxCount > 0, list) << row.key;
    }
    for (const ChildRow& child : table_.children) {
        EXPECT_FALSE(child.label.empty()) << child.key;
        EXPECT_LE(child.minCount, child.maxCount) << child.key;
        EXPECT_GE(child.maxCount, 1U) << child.key;
        ASSERT_NE(child.table, nullptr) << child.key;
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, ParamTables,
    testing::Values(Table{"Scene", sceneTable}, Table{"View", viewTable}, Table{"Light", lightTable},
                    Table{"Material", materialTable}, Table{"Model", modelTable}, Table{"Mesh", meshTable},
                    Table{"Emboss", embossTable}, Table{"Texture", textureTable}, Table{"Pass", passTable},
                    Table{"Unit", unitTable}, Table{"MatrixStep", matrixStepTable},
                    Table{"Combine", combineTable},
                    Table{"TexGenS", []() -> const StructTable& { return texGenTable(0); }},
                    Table{"TexGenT", []() -> const StructTable& { return texGenTable(1); }},
                    Table{"TexGenR", []() -> const StructTable& { return texGenTable(2); }},
                    Table{"TexGenQ", []() -> const StructTable& { return texGenTable(3); }}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Params, EveryDefaultIsAccepted) {
    for (const Scene& scene : {fullScene(), defaultScene()})
        forEachParam(scene, [](const std::string& path, const ParamRow& row, const Value& value) {
            const auto checked = checkValue(row, value);
            EXPECT_TRUE(checked) << path << ": " << describe(checked.error());
        });
}

TEST(Params, EveryRowReadsBackWhatItWritesAndChangesNothingElse) {
    Scene scene = fullScene();
    scene.models[0].shape = Shape::Cube; // as many vertices as valuesOf gives
    std::vector<std::pair<std::string, const ParamRow*>> rows;
    forEachParam(scene, [&](const std::string& path, const ParamRow& row, const Value&) {
        rows.emplace_back(path, &row);
    });
    ASSERT_EQ(rows.size(), 9U + (8 + 4) + 8 + (29 + 7 + 8 + 4 * 7) + (38 + 14 + 3 + 14 + 9) + (14 + 6) +
                               4 * (7 + 16 + 4 * 4 + 3 + 7));

    for (const auto& [path, row] : rows) {
        for (const Value& value : valuesOf(*row)) {
            ASSERT_TRUE(checkValue(*row, value)) << path;
            const std::string text = formatValue(*row, value);
            const auto parsed = parseValue(*row, text);
            ASSERT_TRUE(parsed) << path << " = " << text << ": " << describe(parsed.error());
            EXPECT_EQ(*parsed, value) << path << " = " << text;

            Scene changed = scene;
            const auto set = setParam(changed, path, text);
            ASSERT_TRUE(set) << describe(set.error());
            EXPECT_EQ(getParam(changed, path).value_or("nothing"), text);
            Params expected = paramsOf(scene);
            expected[path] = text;
            EXPECT_EQ(paramsOf(changed), expected) << path;
            EXPECT_EQ(changed == scene, paramsOf(changed) == paramsOf(scene)) << path;
        }
    }
}

// Shading is the whole scene's.
TEST(Params, TheMaterialOfAModelHasAllRowsButShading) {
    const StructTable& scenes = materialTable();
    const StructTable& models = modelMaterialTable();
    EXPECT_EQ(models.name, scenes.name);
    ASSERT_EQ(models.params.size() + 1, scenes.params.size());
    for (const ParamRow& row : models.params)
        EXPECT_EQ(&row, findParam(scenes, row.key)) << row.key;
    EXPECT_EQ(findParam(models, "shadeModel"), nullptr);
}

TEST(Params, AMemberThatIsOneStructIsReset) {
    Model model;
    const ChildRow& mesh = *findChild(modelTable(), "mesh");
    EXPECT_FALSE(mesh.indexed);
    EXPECT_TRUE(mesh.isDefault(&model, 0));
    model.mesh.indices = {1};
    EXPECT_FALSE(mesh.isDefault(&model, 0));
    EXPECT_EQ(mesh.at(&model, 0), &model.mesh);
    mesh.resize(&model, 0);
    EXPECT_EQ(model, Model{});
}

// What is longer than a row says is no value of it.
TEST(Params, ListsAreNoLongerThanTheirLimit) {
    const ParamRow& models = *findParam(passTable(), "models");
    EXPECT_TRUE(checkValue(models, std::vector<int>(maxModels, 0)));
    EXPECT_FALSE(checkValue(models, std::vector<int>(maxModels + 1, 0)));
    const ParamRow& positions = *findParam(meshTable(), "positions");
    EXPECT_TRUE(checkValue(positions, std::vector<glm::vec3>(maxMeshVertices)));
    const auto longer = checkValue(positions, std::vector<glm::vec3>(maxMeshVertices + 1));
    ASSERT_FALSE(longer);
    EXPECT_EQ(longer.error().code, ErrorCode::TooLarge);
    EXPECT_EQ(longer.error().message, "expected at most 65536 elements, found 65537");
}

TEST(Params, ListsGrowWithDefaultsAndFixedArraysAreReset) {
    Scene scene;
    const ChildRow& textures = *findChild(sceneTable(), "textures");
    textures.resize(&scene, 2);
    ASSERT_EQ(textures.size(&scene), 2U);
    EXPECT_EQ(textures.at(&scene, 1), &scene.textures[1]);
    EXPECT_TRUE(textures.isDefault(&scene, 1));
    scene.textures[1].baseLevel = 3;
    EXPECT_FALSE(textures.isDefault(&scene, 1));

    Pass pass;
    for (Unit& unit : pass.units)
        unit.enabled = true;
    findChild(passTable(), "units")->resize(&pass, 1);
    EXPECT_TRUE(pass.units[0].enabled);
    EXPECT_EQ(pass.units[1], Unit{});
    EXPECT_EQ(pass.units[3], Unit{});
}

} // namespace
} // namespace texplorer::params_test
