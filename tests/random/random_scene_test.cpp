#include "tests/random/random_scene.h"
#include "tests/random/random_skip.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/params.h"
#include "texplorer/texture/image_source.h"

#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

namespace texplorer::random::random_scene_test {
namespace {

const std::vector<std::string> files{"one.dds", "two.png"};

TEST(RandomScene, IsTheSameForTheSameNumber) {
    for (int number = 0; number < 20; ++number) {
        EXPECT_EQ(randomScene(1, number, files).scene, randomScene(1, number, files).scene);
        EXPECT_NE(randomScene(1, number, files).scene, randomScene(2, number, files).scene);
        EXPECT_NE(randomScene(1, number, files).scene, randomScene(1, number + 1, files).scene);
    }
}

TEST(RandomScene, CanBeKeptInAFile) {
    for (int number = 0; number < 60; ++number) {
        const Scene scene = randomScene(1, number, files).scene;
        const Result<Scene> read = parseScene(writeScene(scene));
        ASSERT_TRUE(read) << number << ": " << describe(read.error());
        EXPECT_EQ(*read, scene) << number;
    }
}

TEST(RandomScene, OfOrdinaryTemperStaysWithinAHundredSteps) {
    int ordinary = 0;
    for (int number = 0; number < 30; ++number) {
        const auto [temper, scene] = randomScene(1, number, files);
        if (temper != Temper::Ordinary)
            continue;
        ++ordinary;
        EXPECT_LE(scene.view.fieldOfView, 40 + 25) << number;
        EXPECT_LE(scene.textures.size(), 4U) << number;
        for (const Model& model : scene.models)
            EXPECT_LE(std::abs(model.position.x), 3) << number;
    }
    EXPECT_GT(ordinary, 3);
}

// Features that a driver may draw differently, in any model and any list.
TEST(RandomScene, ThatIsComparableHasNoneOfWhatDiffers) {
    int meshes = 0;
    for (int number = 0; number < 200; ++number) {
        const RandomScene random = randomScene(1, number, files);
        if (random.temper != Temper::Comparable)
            continue;
        const auto expectQ = [number](const std::vector<MatrixStep>& steps) {
            for (const MatrixStep& step : steps)
                EXPECT_EQ(glm::transpose(step.matrix)[3], glm::vec4(0, 0, 0, 1)) << number;
        };
        for (const Model& model : random.scene.models) {
            for (const ModelUnit& unit : model.units)
                expectQ(unit.matrix);
            meshes += model.shape == Shape::Mesh ? 1 : 0;
            EXPECT_GE(model.lineWidth, 3) << number;
            EXPECT_EQ(std::lround(model.lineWidth) % 2, 1) << number;
            EXPECT_EQ(model.pointSize, std::round(model.pointSize)) << number;
            EXPECT_FALSE(drawsAPartTwice(model)) << number;
            for (const glm::vec4& each : model.mesh.texCoords)
                EXPECT_EQ(each.q, 1) << number;
        }
        for (const Pass& pass : random.scene.passes) {
            for (const Unit& unit : pass.units)
                expectQ(unit.matrix);
        }
    }
    EXPECT_GT(meshes, 10);
}

TEST(RandomScenes, DrawSomePartsTwice) {
    Model model{.shape = Shape::Mesh};
    model.mesh.primitive = Primitive::TriangleStrip;
    model.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    EXPECT_FALSE(drawsAPartTwice(model));
    model.mesh.indices = {0, 1, 2, 0}; // 0 1 2, then 2 1 0
    EXPECT_TRUE(drawsAPartTwice(model));
    model.shape = Shape::Quad; // whose vertices these aren't
    EXPECT_FALSE(drawsAPartTwice(model));
    model.shape = Shape::Mesh;
    model.mesh.primitive = Primitive::LineLoop;
    model.mesh.indices = {0, 1};
    EXPECT_TRUE(drawsAPartTwice(model));
    model.mesh.indices = {0, 1, 2};
    EXPECT_FALSE(drawsAPartTwice(model));
    model.shape = Shape::Torus;
    EXPECT_FALSE(drawsAPartTwice(model));
    model.stacks = 2;
    EXPECT_TRUE(drawsAPartTwice(model));
}

TEST(RandomScene, WithoutFilesNamesNone) {
    for (int number = 0; number < 30; ++number) {
        for (const FileName& name : fileNamesOf(randomScene(1, number, {}).scene)) {
            EXPECT_FALSE(name.used) << name.path;
            EXPECT_EQ(name.file, "");
        }
    }
}

TEST(RandomScene, HasFogThatAFileCanHold) {
    const Scene scene = randomScene(90210, 111, {}).scene; // seen from nearby
    EXPECT_TRUE(parseScene(writeScene(scene)));
}

/// The values that occurred, of every row and of every list.
struct Seen {
    std::map<const ParamRow*, std::set<float>> numbers;
    std::map<const ParamRow*, std::set<std::uint32_t>> choices;
    std::map<const ParamRow*, std::set<std::string>> texts;
    std::map<const ChildRow*, std::set<std::size_t>> counts;

    void walk(const StructTable& table, void* owner) {
        for (const ParamRow& row : table.params)
            std::visit([&](const auto& value) { take(row, value); }, row.read(owner));
        for (const ChildRow& child : table.children) {
            counts[&child].insert(child.size(owner));
            for (std::size_t i = 0; i < child.size(owner); ++i)
                walk(*child.table, child.at(owner, i));
        }
    }

private:
    void take(const ParamRow& row, bool value) { numbers[&row].insert(value ? 1.0F : 0.0F); }
    void take(const ParamRow& row, int value) { numbers[&row].insert(static_cast<float>(value)); }
    void take(const ParamRow& row, float value) { numbers[&row].insert(value); }
    void take(const ParamRow& row, glm::vec3 value) { numbers[&row].insert({value.x, value.y, value.z}); }
    void take(const ParamRow& row, glm::vec4 value) {
        numbers[&row].insert({value.x, value.y, value.z, value.w});
    }
    void take(const ParamRow& row, EnumValue value) { choices[&row].insert(value.number); }
    void take(const ParamRow& row, const std::string& value) { texts[&row].insert(value); }
    void take(const ParamRow& row, const glm::mat4& value) {
        for (int column = 0; column < 4; ++column)
            take(row, value[column]);
    }
    template<class Element>
    void take(const ParamRow& row, const SharedList<Element>& value) {
        for (const Element& each : value)
            take(row, each);
    }
};

/// Whether the row of a list has no limits: values per vertex take the whole range of a float.
bool isUnlimited(const ParamRow& row) {
    return row.kind == Kind::PointList || row.kind == Kind::TexCoordList;
}

// A value that never occurs is never tested.
TEST(RandomScenes, ReachEveryChoiceAndBothEndsOfEveryRow) {
    Seen seen;
    for (int number = 0; number < 400; ++number) {
        Scene scene = randomScene(1, number, files).scene;
        seen.walk(sceneTable(), &scene);
    }
    for (const auto& [row, numbers] : seen.numbers) {
        if (row->kind == Kind::Bool) {
            EXPECT_EQ(numbers, (std::set{0.0F, 1.0F})) << row->key;
        } else if (isUnlimited(*row)) {
            EXPECT_EQ(*numbers.rbegin(), std::numeric_limits<float>::max()) << row->key;
            EXPECT_EQ(*numbers.begin(), -3e38F) << row->key;
        } else {
            EXPECT_EQ(*numbers.begin(), row->range.min) << row->key;
            if (row->member == memberId<&MeshData::indices> ||
                row->member == memberId<&Model::noTexCoord>) // of meshes of few vertices
                EXPECT_GT(*numbers.rbegin(), 40);
            else
                EXPECT_EQ(*numbers.rbegin(), row->range.max) << row->key;
        }
        const bool isWhole =
            row->kind == Kind::Int || row->kind == Kind::Bool || row->kind == Kind::IndexList;
        const bool takesDenormals = !isWhole && row->range.min <= 0;
        if (takesDenormals) {
            EXPECT_TRUE(std::ranges::any_of(numbers, [](float each) {
                return std::fpclassify(each) == FP_SUBNORMAL;
            })) << row->key;
        }
    }
    for (const auto& [row, choices] : seen.choices)
        EXPECT_EQ(choices.size(), row->choices.size()) << row->key;
    for (const auto& [row, texts] : seen.texts) {
        if (row->member == memberId<&Texture::file> || row->member == memberId<&GivenLevel::file> ||
            row->member == memberId<&ImageStep::file> || row->member == memberId<&Subimage::file>)
            EXPECT_EQ(texts, std::set<std::string>(files.begin(), files.end()));
        else if (row->member == memberId<&MeshData::file>)
            EXPECT_EQ(texts, std::set<std::string>{""});
        else if (row->member == memberId<&KeyFrame::path> || row->member == memberId<&KeyFrame::value>)
            EXPECT_GT(texts.size(), 1000U) << row->key;
        else
            EXPECT_TRUE(texts.size() > 5 && texts.contains("two\nlines")) << row->key;
    }
    for (const auto& [child, counts] : seen.counts) {
        EXPECT_EQ(*counts.begin(), child->minCount) << child->key;
        EXPECT_EQ(*counts.rbegin(), child->maxCount) << child->key;
    }
    // 33 rows of a texture, 24 of a model …: as many as the tables have, with those of the four coordinates
    // counted separately and those of a material once.
    EXPECT_EQ(seen.choices.size() + seen.numbers.size() + seen.texts.size(), [] {
        std::size_t count = 0;
        for (const StructTable* table :
             {&viewTable(),    &lightTable(),   &projectorTable(),  &materialTable(),   &modelTable(),
              &meshTable(),    &textureTable(), &givenLevelTable(), &imageStepTable(),  &subimageTable(),
              &passTable(),    &fogTable(),     &unitTable(),       &matrixStepTable(), &combineTable(),
              &embossTable(),  &uploadTable(),  &keyFrameTable(),   &texGenTable(0),    &texGenTable(1),
              &texGenTable(2), &texGenTable(3)})
            count += table->params.size();
        return count;
    }());
}

} // namespace
} // namespace texplorer::random::random_scene_test
