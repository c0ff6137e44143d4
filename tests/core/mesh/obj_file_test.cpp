#include "texplorer/base/sentence_format.h"
#include "texplorer/files/file_io.h"
#include "texplorer/mesh/obj_file.h"

#include <fmt/core.h>
#include <gmock/gmock.h>

#include <cmath>
#include <string>

namespace texplorer::obj_file_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::string_view library =
    "newmtl wood\nKd 0.5 0.25 1\nd 0.5\nmap_Kd images\\wood.png\nnewmtl plain\n";

Result<ObjFile> decoded(std::string_view text, std::size_t maxParts = 16) {
    const auto materials = [](const std::string& name) {
        return name == "a.mtl" ? std::optional(std::string(library)) : std::nullopt;
    };
    return decodeObj(viewBytes(text), materials, maxParts);
}
std::string problemOf(std::string_view text, std::size_t maxParts = 16) {
    const Result<ObjFile> read = decoded(text, maxParts);
    return read ? "none" : describe(read.error()).english();
}

constexpr std::string_view square = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

TEST(ObjFiles, HaveVerticesWithCoordinatesAndNormals) {
    const Result<ObjFile> read =
        decoded(std::string(square) + "vn 0 0 2\no board\nf 1/1/1 2/2/1 3/3/1 4/4/1\n");
    ASSERT_TRUE(read) << describe(read.error());
    ASSERT_EQ(read->parts.size(), 1U);
    EXPECT_EQ(read->parts[0].name, "board");
    const MeshData& mesh = read->parts[0].mesh;
    EXPECT_THAT(mesh.positions,
                ElementsAre(glm::vec3(0), glm::vec3(2, 0, 0), glm::vec3(2, 2, 0), glm::vec3(0, 2, 0)));
    EXPECT_THAT(mesh.texCoords, ElementsAre(glm::vec4(0, 0, 0, 1), glm::vec4(1, 0, 0, 1),
                                            glm::vec4(1, 1, 0, 1), glm::vec4(0, 1, 0, 1)));
    EXPECT_THAT(mesh.normals, testing::Each(glm::vec3(0, 0, 1)));
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 0, 2, 3)) << "a fan";
}

TEST(ObjFiles, CountFromTheEndWithNegativeNumbers) {
    const Result<ObjFile> read = decoded(std::string(square) + "f -4/-4 -3/-3 -2/-2\n");
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(read->parts[0].mesh.positions[2], glm::vec3(2, 2, 0));
    EXPECT_EQ(read->parts[0].mesh.texCoords[1], glm::vec4(1, 0, 0, 1));
}

TEST(ObjFiles, WithoutCoordinatesAndNormalsGetNormalsAlone) {
    const Result<ObjFile> read = decoded(std::string(square) + "v 0 0 -2\nf 1 2 3 4\nf 1 5 2\n");
    ASSERT_TRUE(read) << describe(read.error());
    const MeshData& mesh = read->parts[0].mesh;
    EXPECT_TRUE(mesh.texCoords.empty());
    ASSERT_EQ(mesh.positions.size(), 5U);
    EXPECT_EQ(mesh.normals[2], glm::vec3(0, 0, 1));
    // The square's two triangles at (0, 0, 0), 4 + 4 along z, and one of 4 along -y.
    EXPECT_NEAR(mesh.normals[0].z, 8 / std::sqrt(80.0F), 1e-6F);
    EXPECT_NEAR(mesh.normals[0].y, -4 / std::sqrt(80.0F), 1e-6F);
}

TEST(ObjFiles, HaveAPartForEachObjectAndMaterial) {
    const std::string text = "mtllib a.mtl\n" + std::string(square) +
                             "o one\nusemtl wood\nf 1 2 3\nusemtl plain\nf 1 3 4\no two\nf 1 2 4\n";
    const Result<ObjFile> read = decoded(text);
    ASSERT_TRUE(read) << describe(read.error());
    ASSERT_EQ(read->parts.size(), 3U);
    EXPECT_EQ(read->parts[2].name, "two");
    const ObjMaterial& wood = read->materials[static_cast<std::size_t>(read->parts[0].material)];
    EXPECT_EQ(wood.color, glm::vec4(0.5F, 0.25F, 1, 0.5F));
    EXPECT_EQ(wood.image, "images/wood.png");
    EXPECT_EQ(read->parts[1].material, read->parts[2].material);

    const Result<ObjFile> merged = decoded(text, 2);
    ASSERT_TRUE(merged) << describe(merged.error());
    EXPECT_EQ(merged->parts.size(), 2U) << "one for each material";
    EXPECT_THAT(merged->notes, ElementsAre(testing::Property(&Sentence::english, HasSubstr("3 objects"))));
    EXPECT_EQ(problemOf(text, 1), "it uses 2 materials, each of which needs a model; a scene has at most 1");
}

TEST(ObjFiles, WithAPartThatIsTooLargeSaySo) {
    std::string text;
    for (std::size_t i = 0; i < maxFileVertices; ++i)
        text += "v 0 0 1\n";
    for (std::size_t i = 1; i + 2 <= maxFileVertices; i += 3)
        text += fmt::format("f {} {} {}\n", i, i + 1, i + 2);
    EXPECT_EQ(
        problemOf(text + "v 1 0 0\nf 1 1000000 1000001\n"),
        "a part has 1000001 vertices and 1000002 corners of triangles; at most 1000000 and 6000000 are read");
}

TEST(ObjFiles, BeyondWhatMemoryAllowsSaySo) {
    const auto repeated = [](std::string_view text, std::size_t count) {
        std::string all;
        for (std::size_t i = 0; i < count; ++i)
            all += text;
        return all;
    };
    const std::string fan = "f" + repeated(" 1", 1002) + "\n"; // of 1000 triangles
    EXPECT_EQ(problemOf("v 0 0 0\n" + repeated(fan, 6001)),
              "line 6002: triangles: at most 6000000 are read, found 6001000");
    EXPECT_EQ(problemOf("f" + repeated(" 1", std::size_t{1} << 20)),
              "line 1: bytes of a line: at most 1048576 are read, found 2097153");
    EXPECT_EQ(problemOf("usemtl " + repeated("m", 1025)),
              "line 1: bytes of a name: at most 1024 are read, found 1025");
    EXPECT_EQ(problemOf(repeated("g a\n", 65537)),
              "line 65537: objects, groups and uses of materials: at most 65536 are read, found 65537");
}

TEST(ObjFiles, ThatAreWrongSayWhere) {
    const auto of = [](const char* line) { return problemOf(std::string(square) + line); };
    EXPECT_EQ(of("f 1 2 3\nf 1 2 9\n"), "line 10: expected v from 1 to 4, found 9");
    EXPECT_EQ(of("f 1/1 2/7 3/3\n"), "line 9: expected vt from 1 to 4, found 7");
    EXPECT_EQ(of("f 1//1 2//1 3//1\n"), "line 9: expected vn 1 in an earlier line, found no vn");
    EXPECT_EQ(of("f 0 1 2\n"), "line 9: expected v, v/vt, v//vn or v/vt/vn, found \"0\"");
    EXPECT_EQ(of("f 1 2 4294967297\n"), "line 9: expected v, v/vt, v//vn or v/vt/vn, found \"4294967297\"");
    EXPECT_EQ(of("f 1 2\n"), "line 9: expected a polygon of at least 3 vertices, found 2");
    EXPECT_EQ(of("f 1 2 3x\n"), "line 9: expected v, v/vt, v//vn or v/vt/vn, found \"3x\"");
    EXPECT_EQ(problemOf("v 1e999 0 0\n"), "line 1: expected a finite number, found \"1e999\"");
    EXPECT_EQ(problemOf("v nan 0 0\n"), "line 1: expected a finite number, found \"nan\"");
    EXPECT_EQ(problemOf("v 1,5 0 0\n"), "line 1: expected a finite number, found \"1,5\"");
    EXPECT_EQ(problemOf("v 1 2\n"), "line 1: expected 3 numbers after v, found 2");
    EXPECT_EQ(problemOf("\x89PNG\r\n\x1A\n"), "line 2: expected text, found the byte 26");
    for (const std::string_view text : {"", "v 0 0 0\n", "hello\n", "mtllib b.mtl\n"})
        EXPECT_EQ(problemOf(text), "expected polygons (lines that begin with f), found none") << text;
}

TEST(ObjFiles, HaveCommentsContinuationsAndAByteOrderMark) {
    const Result<ObjFile> read =
        decoded("\xEF\xBB\xBFv 0 0 0 # first\r\nv 1 0 \\\n0\nv 1 +1.5e0 0\nf 1 2 \\\r\n3 # a\n");
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_THAT(read->parts[0].mesh.positions,
                ElementsAre(glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(1, 1.5F, 0)));
    EXPECT_EQ(problemOf("v 0 0 \\\n0\nf 1 2 9\n"), "line 3: expected v from 1 to 1, found 2");
}

TEST(ObjFiles, ReadALibraryOnceAndNameWhatIsMissing) {
    int count = 0;
    const auto materials = [&](const std::string& name) {
        ++count;
        return name == "a.mtl" ? std::optional(std::string(library)) : std::nullopt;
    };
    const std::string text =
        "mtllib a.mtl\nmtllib a.mtl\nmtllib none.mtl\n" + std::string(square) + "usemtl gold\nf 1 2 3\n";
    const Result<ObjFile> read = decodeObj(viewBytes(text), materials, 16);
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(count, 2);
    ASSERT_EQ(read->notes.size(), 2U);
    EXPECT_EQ(read->notes[0].english(),
              "the material library none.mtl can't be read: drawn without its materials");
    EXPECT_EQ(read->notes[1].english(), "the material gold is in no library");
}

// Their squares are beyond a float's range.
TEST(ObjFiles, OfHugeAndTinyNumbersHaveNormals) {
    for (const char* side : {"1e30", "1e-30"}) {
        const std::string text = std::string("v 0 0 0\nv 0 ") + side + " 0\nv 0 0 " + side + "\nf 1 2 3\n";
        const Result<ObjFile> read = decoded(text);
        ASSERT_TRUE(read) << describe(read.error());
        EXPECT_EQ(read->parts[0].mesh.normals[0], glm::vec3(1, 0, 0)) << side;
    }
}

// The library reads the first material of what it was given.
TEST(ObjFiles, WithAnEmptyLibraryOfMaterialsAreRead) {
    const auto none = [](const std::string&) { return std::optional(std::string()); };
    const std::string text = "mtllib empty.mtl\n" + std::string(square) + "usemtl x\nf 1 2 3\n";
    const Result<ObjFile> read = decodeObj(viewBytes(text), none, 16);
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(read->materials[0].image, "");
}

} // namespace
} // namespace texplorer::obj_file_test
