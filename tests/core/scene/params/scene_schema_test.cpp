#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/params.h"
#include "texplorer/scene/params/scene_schema.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace texplorer::scene_schema_test {
namespace {

// What a validator says of scenes is in tests/end_to_end/texshot/schema_test.py.

/// The rows of a table and of those below it, each table once.
std::size_t countRows(const StructTable& table, std::vector<const StructTable*>& seen) {
    if (std::ranges::find(seen, &table) != seen.end())
        return 0;
    seen.push_back(&table);
    std::size_t count = table.params.size();
    for (const ChildRow& child : table.children)
        count += countRows(*child.table, seen);
    return count;
}

TEST(SceneSchema, DefinesEachStructOnceWithAllOfItsParameters) {
    const nlohmann::json schema = nlohmann::json::parse(sceneSchema());
    std::vector<const StructTable*> tables;
    const std::size_t rows = countRows(sceneTable(), tables);
    EXPECT_EQ(schema["$defs"].size() + 1, tables.size()) << "the scene itself is the root";
    std::size_t titles = 0;
    std::size_t references = 0;
    for (const auto& [name, definition] : schema["$defs"].items()) {
        EXPECT_FALSE(definition["additionalProperties"].get<bool>()) << name;
        for (const auto& [key, member] : definition["properties"].items()) {
            EXPECT_TRUE(member.contains("title")) << name << "." << key;
            const auto& place = member.contains("items") ? member["items"] : member;
            place.contains("$ref") ? ++references : ++titles;
        }
    }
    EXPECT_EQ(titles, rows);
    EXPECT_EQ(references + 7, tables.size()) << "the scene has seven, and two structs have matrix steps";
}

TEST(SceneSchema, SaysWhatTheReaderSays) {
    const nlohmann::json schema = nlohmann::json::parse(sceneSchema());
    EXPECT_EQ(schema["$id"], sceneSchemaId);
    EXPECT_EQ(schema["properties"]["version"]["maximum"], sceneFormatVersion);
    EXPECT_EQ(schema["properties"]["passes"]["minItems"], 1);
    EXPECT_EQ(schema["properties"]["textures"]["maxItems"], maxTextures);
    const nlohmann::json& structs = schema["$defs"];
    EXPECT_EQ(structs["Pass"]["properties"]["units"]["maxItems"], maxUnits);
    EXPECT_EQ(structs["Pass"]["properties"]["units"]["minItems"], 0) << "a file may leave out the last ones";
    EXPECT_EQ(structs["Pass"]["properties"]["models"]["minItems"], 1);
    EXPECT_EQ(structs["View"]["properties"]["fieldOfView"]["minimum"], 1);
    EXPECT_EQ(structs["View"]["properties"]["fieldOfView"]["maximum"], 170);
    EXPECT_EQ(structs["View"]["properties"]["target"]["maxItems"], 3);
    EXPECT_EQ(structs["Combine"]["properties"]["rgbScale"]["enum"],
              nlohmann::json::parse(R"(["1", 1, "2", 2, "4", 4])"));
    EXPECT_EQ(structs["TexGenT"]["properties"]["objectPlane"]["default"], nlohmann::json({0, 1, 0, 0}))
        << "of t, not of s";
}

TEST(SceneSchema, IsNamedByWhatIsWritten) {
    EXPECT_EQ(nlohmann::json::parse(writeScene(defaultScene()))["$schema"], sceneSchemaId);
}

} // namespace
} // namespace texplorer::scene_schema_test
