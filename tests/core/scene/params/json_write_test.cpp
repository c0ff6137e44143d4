#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/scene/params/params.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

namespace texplorer::json_write_test {
namespace {

TEST(WriteScene, ReadsLikeThis) {
    Scene scene;
    scene.view.background = {0.1F, 0, 0.25F, 1};
    scene.models = {Model{.shape = Shape::Quad}};
    scene.models[0].texCoords[1] = {{0, 0, 0, 1}, {1, 0, 0.5F, 1}, {1, 1, 0, 2}, {-0.0F, 1, 0, 1}};
    scene.textures.emplace_back().file = "a \"b\"\n\xC3\xA9.png";
    scene.passes[0].units[1].enabled = true;
    EXPECT_EQ(writeScene(scene), R"({
  "$schema": "file:///usr/share/texplorer/scene.schema.json",
  "version": 1,
  "view": {
    "azimuth": 0,
    "elevation": 0,
    "roll": 0,
    "distance": 6,
    "target": [0, 0, 0],
    "projection": "perspective",
    "fieldOfView": 40,
    "perspectiveHint": "GL_DONT_CARE",
    "background": [0.1, 0, 0.25, 1]
  },
  "light": {
    "position": [0, 0, 1, 0],
    "ambient": [0, 0, 0, 1],
    "diffuse": [1, 1, 1, 1],
    "specular": [1, 1, 1, 1],
    "modelAmbient": [0.2, 0.2, 0.2, 1],
    "colorControl": "GL_SINGLE_COLOR",
    "localViewer": false,
    "twoSide": false
  },
  "material": {
    "color": [1, 1, 1, 1],
    "colorMaterial": true,
    "ambient": [0.2, 0.2, 0.2, 1],
    "diffuse": [0.8, 0.8, 0.8, 1],
    "specular": [0, 0, 0, 1],
    "emission": [0, 0, 0, 1],
    "shininess": 0,
    "shadeModel": "GL_SMOOTH"
  },
  "models": [
    {
      "name": "",
      "shape": "quad",
      "visible": true,
      "slices": 32,
      "stacks": 16,
      "topRadius": 1,
      "innerRadius": 0,
      "tubeRadius": 0.4,
      "startAngle": 0,
      "sweepAngle": 270,
      "lineWidth": 1,
      "pointSize": 1,
      "position": [0, 0, 0],
      "rotation": [0, 0, 0],
      "rotationOrder": "zyx",
      "spin": [0, 0, 0],
      "size": 1,
      "scale": [1, 1, 1],
      "attachment": "world",
      "ownMaterial": false,
      "texCoords1": [[0, 0], [1, 0, 0.5], [1, 1, 0, 2], [-0.0, 1]],
      "pushMatrix": true
    }
  ],
  "textures": [
    {
      "source": "pattern",
      "pattern": "checker",
      "file": "a \"b\"\n)"
                                 "\xC3\xA9"
                                 R"(.png",
      "depthSize": 256,
      "picture": 1,
      "pictureSize": 256,
      "frames": 1,
      "pictureCall": "glFramebufferTexture2D",
      "flip": "blocks",
      "transparency": "file",
      "stencilColor": [0, 0, 0, 1],
      "internalFormat": "GL_RGBA",
      "border": 0,
      "compression": "file",
      "compressedFormat": "GL_COMPRESSED_RGB_S3TC_DXT1_EXT",
      "compressionQuality": "normal",
      "magFilter": "GL_LINEAR",
      "minFilter": "GL_NEAREST_MIPMAP_LINEAR",
      "wrapS": "GL_REPEAT",
      "wrapT": "GL_REPEAT",
      "wrapR": "GL_REPEAT",
      "borderColor": [0, 0, 0, 0],
      "mipmaps": "none",
      "mipFilter": "box",
      "mipGamma": false,
      "npot": "keep",
      "baseLevel": 0,
      "maxLevel": 1000,
      "minLod": -1000,
      "maxLod": 1000,
      "lodBias": 0,
      "mipCoverage": 0,
      "oversize": "none",
      "maxAnisotropy": 1,
      "compareMode": "GL_NONE",
      "compareFunc": "GL_LEQUAL",
      "depthMode": "GL_LUMINANCE",
      "priority": 1,
      "levels": [],
      "preparation": [],
      "subimages": []
    }
  ],
  "passes": [
    {
      "enabled": true,
      "name": "",
      "picture": 0,
      "lighting": false,
      "depthTest": false,
      "depthFunc": "GL_LESS",
      "alphaTest": false,
      "alphaFunc": "GL_ALWAYS",
      "alphaRef": 0,
      "blend": false,
      "blendSrc": "GL_ONE",
      "blendDst": "GL_ZERO",
      "seamlessCubeMap": false,
      "units": [
        {
          "enabled": false,
          "target": "GL_TEXTURE_2D",
          "texture": 0,
          "envMode": "GL_MODULATE",
          "envColor": [0, 0, 0, 0],
          "lodBias": 0,
          "matrixStart": "glLoadIdentity",
          "matrix": []
        },
        {
          "enabled": true,
          "target": "GL_TEXTURE_2D",
          "texture": 0,
          "envMode": "GL_MODULATE",
          "envColor": [0, 0, 0, 0],
          "lodBias": 0,
          "matrixStart": "glLoadIdentity",
          "matrix": []
        }
      ]
    }
  ]
}
)");
    EXPECT_EQ(parseScene(writeScene(scene)).value(), scene);
}

TEST(WriteScene, LeavesOutTheStateOfAUnitThatNobodyTouched) {
    Scene scene;
    scene.passes[0].units[0].texGenT.enabled = true;
    scene.passes[0].units[1].combine.rgbScale = CombineScale::Two;
    const std::string text = writeScene(scene);
    const auto count = [&](std::string_view key) {
        std::size_t found = 0;
        for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key, at + 1))
            ++found;
        return found;
    };
    EXPECT_EQ(count("\"texGenT\""), 1U);
    EXPECT_EQ(count("\"texGenS\""), 0U);
    EXPECT_EQ(count("\"combine\""), 1U);
    EXPECT_EQ(parseScene(text).value(), scene);
}

// A model: unchanged parts of its material and mesh are left out.
TEST(WriteScene, WritesVerticesAMatrixAndTheModelsOfAPassLikeThis) {
    Scene scene;
    scene.models = {Model{.name = "a \"b\"", .shape = Shape::Mesh}, Model{}};
    scene.models[0].mesh = {.primitive = Primitive::LineLoop,
                            .positions = {{0, 0.5F, -0.0F}, {1, 1e-45F, 3e38F}},
                            .colors = {{0, 0.5F, 1, 1}, {0, 0, 0, 0.25F}},
                            .texCoords = {{0, 1, 0, 1}, {0, 1, 0, 2}},
                            .indices = {1, 0, 1}};
    scene.models[1].material.shininess = 8;
    scene.passes[0].models = {1, 0};
    scene.passes[0].units[0].matrix = {{.op = MatrixOp::Load}};
    const std::string text = writeScene(scene);
    for (const char* expected : {R"(
      "mesh": {
        "primitive": "GL_LINE_LOOP",
        "file": "",
        "part": 0,
        "positions": [[0, 0.5, -0.0], [1, 1e-45, 3e+38]],
        "colors": [[0, 0.5, 1], [0, 0, 0, 0.25]],
        "texCoords": [[0, 1], [0, 1, 0, 2]],
        "indices": [1, 0, 1]
      }
    },
)",
                                 R"(
      "material": {
        "color": [1, 1, 1, 1],
        "colorMaterial": true,
        "ambient": [0.2, 0.2, 0.2, 1],
        "diffuse": [0.8, 0.8, 0.8, 1],
        "specular": [0, 0, 0, 1],
        "emission": [0, 0, 0, 1],
        "shininess": 8
      }
    }
)",
                                 R"(
      "models": [1, 0],
)",
                                 R"(
              "op": "load",
)",
                                 R"(
              "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
)"})
        EXPECT_NE(text.find(expected), std::string::npos) << expected << "in\n" << text;
    EXPECT_EQ(parseScene(text).value(), scene);
}

TEST(WriteScene, FillsTheLinesOfALongList) {
    Scene scene;
    scene.models = {Model{.shape = Shape::Mesh}};
    scene.models[0].mesh.positions.assign(13, {1, 0.5F, 0});
    scene.models[0].mesh.indices.assign(40, 10);
    const std::string text = writeScene(scene);
    // 10 columns and 7 elements of 11 with their separators are 100; an eighth one would end at 113.
    EXPECT_NE(text.find(R"(
        "positions": [
          [1, 0.5, 0], [1, 0.5, 0], [1, 0.5, 0], [1, 0.5, 0], [1, 0.5, 0], [1, 0.5, 0], [1, 0.5, 0],
          [1, 0.5, 0], [1, 0.5, 0], [1, 0.5, 0], [1, 0.5, 0], [1, 0.5, 0], [1, 0.5, 0]
        ],
        "indices": [
          10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10,
          10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10
        ]
)"),
              std::string::npos)
        << text;
    EXPECT_EQ(parseScene(text).value(), scene);
}

TEST(WriteScene, KeepsTheLargestMeshReadable) {
    Scene scene;
    scene.models = {Model{.shape = Shape::Mesh}};
    MeshData& mesh = scene.models[0].mesh;
    for (int i = 0; i < static_cast<int>(maxMeshVertices); ++i) {
        const float u = static_cast<float>(i % 256) / 255;
        const float v = static_cast<float>(i / 256) / 255; // NOLINT(bugprone-integer-division): rows
        mesh.positions.emplace_back(u, std::sin(6 * u) * v, v);
        mesh.normals.emplace_back(v, u, 1 - v);
        mesh.colors.emplace_back(u, v, u * v, 1);
        mesh.texCoords.emplace_back(u, v, 0, 1);
    }
    for (int i = 0; i < static_cast<int>(maxMeshIndices); ++i)
        mesh.indices.push_back(i % static_cast<int>(maxMeshVertices));
    const std::string text = writeScene(scene);
    EXPECT_LE(text.size(), maxSceneBytes);
    EXPECT_EQ(parseScene(text).value(), scene);
    std::size_t longest = 0;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = text.find('\n', from);
        longest = std::max(longest, end - from);
        from = end + 1;
    }
    EXPECT_LE(longest, 110U);
}

TEST(WriteScene, LeavesOutListsThatDoNotFitTheirMesh) {
    Scene scene;
    scene.models = {Model{.shape = Shape::Mesh}};
    MeshData& mesh = scene.models[0].mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}};
    mesh.normals = {{0, 0, 1}};
    mesh.colors.resize(3);
    mesh.texCoords.resize(1);
    mesh.indices = {0, 2};
    const std::string text = writeScene(scene);
    for (const char* key : {"normals", "colors", "texCoords", "indices"})
        EXPECT_EQ(text.find(key), std::string::npos) << key;
    const Scene read = parseScene(text).value();
    EXPECT_EQ(read.models[0].mesh.positions, mesh.positions);
    EXPECT_TRUE(read.models[0].mesh.indices.empty());
}

TEST(WriteScene, LeavesOutCoordinatesThatDoNotFitTheirMesh) {
    Scene scene;
    scene.models = {Model{.shape = Shape::Sphere}};
    scene.models[0].texCoords[0].resize(24);
    EXPECT_EQ(writeScene(scene).find("texCoords"), std::string::npos);
    EXPECT_TRUE(parseScene(writeScene(scene)));
}

TEST(WriteScene, IsJsonEvenForAFileNameThatIsNotUtf8) {
    Scene scene;
    scene.textures.emplace_back().file = "\xff.png";
    EXPECT_EQ(parseScene(writeScene(scene)).value().textures[0].file, "\xEF\xBF\xBD.png");
}

/// Scenes made only from the tables: any number in range, any choice, any allowed count.
class RandomScenes {
public:
    explicit RandomScenes(std::uint32_t seed)
        : random_(seed) {}

    Scene next() {
        Scene scene;
        fill(sceneTable(), &scene);
        // Relations that the tables do not contain.
        for (Model& model : scene.models)
            if (below(3) == 0)
                fit(model.mesh);
        for (Model& model : scene.models)
            if (!model.mesh.positions.empty())
                model.mesh.file.clear(); // it would have them
        for (KeyFrame& key : scene.timeline.keys) {
            key.path = below(2) == 0 ? "view.background" : "view.distance";
            key.value = key.path == "view.distance"
                            ? formatNumber(in({0.1F, 1000, 0.1F, {}}))
                            : fmt::format("{},0,{},1", formatNumber(in({})), formatNumber(in({})));
        }
        for (Pass& pass : scene.passes)
            for (std::size_t i = 0; i < scene.models.size(); ++i)
                if (below(2) == 0)
                    pass.models.insert(pass.models.begin() +
                                           static_cast<std::ptrdiff_t>(below(pass.models.size() + 1)),
                                       static_cast<int>(i));
        for (Model& model : scene.models)
            for (auto& coords : model.texCoords)
                if (below(2) == 0)
                    for (std::size_t i = vertexCountOf(model); i > 0; --i)
                        coords.emplace_back(anyFloat(), anyFloat(), below(2) == 0 ? 0 : anyFloat(),
                                            below(2) == 0 ? 1 : anyFloat());
        for (Pass& pass : scene.passes)
            for (Unit& unit : pass.units) {
                unit.enabled = unit.enabled && !scene.textures.empty();
                if (unit.enabled)
                    unit.texture = static_cast<int>(below(scene.textures.size()));
            }
        return scene;
    }

private:
    std::size_t below(std::size_t count) { return random_() % count; }

    /// Every finite float is equally likely.
    float anyFloat() {
        for (;;)
            if (const float number = std::bit_cast<float>(static_cast<std::uint32_t>(random_()));
                std::isfinite(number))
                return number;
    }

    float in(const Range& range) {
        const float part = static_cast<float>(random_()) / static_cast<float>(std::mt19937::max());
        return std::clamp(range.min + part * (range.max - range.min), range.min, range.max);
    }

    void fit(MeshData& mesh) {
        const std::size_t count = below(9);
        const auto fill = [&](auto& list, const auto& make) {
            for (std::size_t i = 0; i < count; ++i)
                list.push_back(make());
        };
        const auto point = [&] { return glm::vec3(anyFloat(), anyFloat(), anyFloat()); };
        const auto share = [&] { return in({0, 1, 0.1F, {}}); };
        fill(mesh.positions, point);
        if (below(2) == 0)
            fill(mesh.normals, point);
        if (below(2) == 0)
            fill(mesh.colors,
                 [&] { return glm::vec4(share(), share(), share(), below(2) == 0 ? 1 : share()); });
        if (below(2) == 0)
            fill(mesh.texCoords, [&] {
                return glm::vec4(anyFloat(), anyFloat(), below(2) == 0 ? 0 : anyFloat(),
                                 below(2) == 0 ? 1 : anyFloat());
            });
        for (std::size_t i = below(20); count > 0 && i > 0; --i)
            mesh.indices.push_back(static_cast<int>(below(count)));
    }

    Value value(const ParamRow& row) {
        switch (row.kind) {
        case Kind::Bool:
            return below(2) == 0;
        case Kind::Int:
            if (row.range.max == maxSubdivision) // meshes small enough to be written three hundred times
                return static_cast<int>(row.range.min) + static_cast<int>(below(6));
            return static_cast<int>(in(row.range));
        case Kind::Float:
            return in(row.range);
        case Kind::Vec3:
            return glm::vec3(in(row.range), in(row.range), in(row.range));
        case Kind::Vec4:
        case Kind::Color:
            return glm::vec4(in(row.range), in(row.range), in(row.range), in(row.range));
        case Kind::Enum:
            return EnumValue{row.choices[below(row.choices.size())].value};
        case Kind::Text: {
            static constexpr std::array<std::string_view, 8> pieces{
                "a", "/", "\\", "\"", "\n", "\x7f", "\xC3\xA9", "\xF0\x9F\xA7\xB1"};
            std::string text;
            for (std::size_t i = below(12); i > 0; --i)
                text += pieces[below(pieces.size())];
            return text;
        }
        case Kind::Matrix: {
            glm::mat4 matrix;
            for (int i = 0; i < 16; ++i)
                matrix[i / 4][i % 4] = in(row.range);
            return matrix;
        }
        case Kind::PointList:
            return std::vector<glm::vec3>{};
        case Kind::ColorList:
        case Kind::TexCoordList:
            return TexCoords{};
        case Kind::IndexList:
            return std::vector<int>{};
        }
        return {};
    }

    void fill(const StructTable& table, void* owner) {
        for (const ParamRow& row : table.params)
            row.write(owner, value(row));
        for (const ChildRow& child : table.children) {
            if (child.indexed && child.minCount != child.maxCount)
                child.resize(owner, child.minCount + below(std::min<std::size_t>(child.maxCount, 3)));
            for (std::size_t i = 0; i < child.size(owner); ++i)
                if (below(8) != 0) // some stay as they are by default
                    fill(*child.table, child.at(owner, i));
        }
    }

    std::mt19937 random_;
};

TEST(SceneJson, RandomScenesComeBackExactly) {
    RandomScenes scenes(20240229);
    for (int i = 0; i < 300; ++i) {
        const Scene scene = scenes.next();
        forEachParam(scene, [](const std::string& path, const ParamRow& row, const Value& value) {
            ASSERT_TRUE(checkValue(row, value)) << path << ": the generator is wrong";
        });
        const std::string text = writeScene(scene);
        const auto read = parseScene(text);
        ASSERT_TRUE(read) << "scene " << i << ": " << describe(read.error()) << "\n" << text;
        ASSERT_EQ(*read, scene) << "scene " << i << "\n" << text;
        ASSERT_EQ(writeScene(*read), text) << "scene " << i;
    }
}

TEST(ShortScene, SaysOnlyWhatDiffersFromAFileThatSaysNothing) {
    EXPECT_EQ(writeShortScene(defaultScene()), "{\n  \"version\": 1\n}\n");
    Scene scene = defaultScene();
    scene.view.distance = 9;
    scene.light.twoSide = true;
    EXPECT_EQ(writeShortScene(scene), R"({
  "version": 1,
  "view": {
    "distance": 9
  },
  "light": {
    "twoSide": true
  }
}
)");
}

TEST(ShortScene, AListIsWholeAndItsElementsSayWhatDiffersFromNewOnes) {
    Scene scene = defaultScene();
    scene.textures.assign(2, Texture{});
    scene.textures[1].wrapS = Wrap::Clamp;
    const std::string text = writeShortScene(scene);
    EXPECT_NE(text.find(R"("textures": [
    {},
    {
      "wrapS": "GL_CLAMP"
    }
  ])"),
              std::string::npos)
        << text;
    EXPECT_EQ(parseScene(text), scene);
}

TEST(ShortScene, RandomScenesComeBackExactly) {
    RandomScenes scenes(20261123);
    for (int i = 0; i < 200; ++i) {
        const Scene scene = scenes.next();
        const std::string text = writeShortScene(scene);
        const auto read = parseScene(text);
        ASSERT_TRUE(read) << "scene " << i << ": " << describe(read.error()) << "\n" << text;
        ASSERT_EQ(*read, scene) << "scene " << i << "\n" << text;
        ASSERT_LE(text.size(), writeScene(scene).size());
    }
}

TEST(ShortScene, EachParameterOfTheDefaultSceneMaySayItself) {
    std::vector<std::string> paths;
    forEachParam(defaultScene(), [&](const std::string& path, const ParamRow& row, const Value&) {
        if (row.kind == Kind::Bool || row.kind == Kind::Enum)
            paths.push_back(path);
    });
    for (const std::string& path : paths) {
        Scene scene = defaultScene();
        const ParamRow& row = *paramAt(scene, path)->row;
        for (const EnumRow& choice : row.choices)
            if (setParam(scene, path, choice.name) && scene != defaultScene())
                break;
        if (row.kind == Kind::Bool)
            static_cast<void>(setParam(scene, path, *getParam(scene, path) == "true" ? "false" : "true"));
        ASSERT_EQ(parseScene(writeShortScene(scene)), scene) << path << "\n" << writeShortScene(scene);
    }
}

} // namespace
} // namespace texplorer::json_write_test
