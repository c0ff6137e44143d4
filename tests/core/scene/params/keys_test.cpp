#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/keys.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <regex>
#include <set>

namespace texplorer::keys_test {
namespace {

using Visit = std::function<void(const StructTable&)>;

void forEachTable(const StructTable& table, const Visit& visit) {
    visit(table);
    for (const ChildRow& child : table.children)
        forEachTable(*child.table, visit);
}

std::set<std::string> allKeys() {
    std::set<std::string> keys;
    forEachTable(sceneTable(), [&](const StructTable& table) {
        for (const std::string_view key : tableKeys(table))
            keys.insert(std::string(key));
    });
    return keys;
}

TEST(Keys, AreThoseOfTheRows) {
    EXPECT_EQ(keyOf<&Texture::minFilter>(), "minFilter");
    EXPECT_EQ(keyOf<&SamplerState::minFilter>(), "minFilter");
    EXPECT_EQ(keyOf<&Texture::mipmaps>(), "mipmaps");
    EXPECT_EQ(keyOf<&Pass::units>(), "units");
    EXPECT_EQ(keyOf<&Unit::combine>(), "combine");
    EXPECT_EQ(keyOf<&TexGen::eyePlane>(), "eyePlane");
    EXPECT_EQ((pathOf<&Scene::light, &Light::modelAmbient>()), "light.modelAmbient");
    EXPECT_EQ((pathOf<&Unit::texGenR, &TexGen::mode>()), "texGenR.mode");
    EXPECT_EQ(elementOf<&Scene::textures>(3), "textures[3]");
    EXPECT_EQ(findKey(memberId<&Model::texCoords>, 2), "texCoords2");
}

// Members of one type and of the same place in different structs must not be taken for each other.
TEST(Keys, AreFoundForEveryRow) {
    std::map<MemberId, std::set<std::string_view>> keys;
    forEachTable(sceneTable(), [&](const StructTable& table) {
        std::map<MemberId, std::size_t> elements;
        for (const ParamRow& row : table.params) {
            EXPECT_EQ(findKey(row.member, elements[row.member]++), row.key) << table.name;
            keys[row.member].insert(row.key);
        }
        for (const ChildRow& child : table.children) {
            EXPECT_EQ(findKey(child.member), child.key) << table.name;
            keys[child.member].insert(child.key);
        }
    });
    for (const auto& [member, names] : keys) {
        const bool isForUnits =
            member == memberId<&Model::texCoords> || member == memberId<&Model::noTexCoord>;
        EXPECT_EQ(names.size(), isForUnits ? maxUnits : 1U) << *names.begin();
    }
}

/// A literal that is a key, or a path of keys with or without its dots.
bool isMadeOfKeys(const std::string& literal, const std::set<std::string>& keys) {
    static const std::regex path(R"(\.?\w+([.\[]\w*)*)");
    static const std::regex word(R"(\w+)");
    if (!std::regex_match(literal, path))
        return false;
    const std::sregex_iterator first(literal.begin(), literal.end(), word);
    return std::all_of(first, {}, [&](const std::smatch& each) { return keys.contains(each.str()); });
}

/// The literals of a source that say a key again. What a rule is called is none.
std::vector<std::string> typedAgain(const std::filesystem::path& file) {
    const Result<Bytes> bytes = readFile(file);
    EXPECT_TRUE(bytes) << file;
    const std::string text =
        bytes ? std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size()) : "";
    const std::set<std::string> keys = allKeys();
    static const std::regex literal(R"raw((Rule\{)?"((?:\\.|[^"\\\n])*)")raw");
    std::vector<std::string> typed;
    for (std::sregex_iterator at(text.begin(), text.end(), literal), end; at != end; ++at) {
        if (!(*at)[1].matched && isMadeOfKeys((*at)[2], keys))
            typed.push_back(file.filename().string() + ": " + (*at)[2].str());
    }
    return typed;
}

TEST(Keys, AreRecognisedInALiteral) {
    const std::set<std::string> keys = allKeys();
    for (const char* typed :
         {"minFilter", ".texCoords0", "combine.", "light.ambient", "textures[", ".texGenS."})
        EXPECT_TRUE(isMadeOfKeys(typed, keys)) << typed;
    for (const char* other : {"", ".", "[", "the light", "GL_REPEAT", "combine.nothing", "minFilters"})
        EXPECT_FALSE(isMadeOfKeys(other, keys)) << other;
}

/// What writes C or GLSL has the names of their variables, as "position", and words of glTexImage, as
/// "depth".
bool hasWordsOfPrograms(const std::string& file) {
    constexpr std::array<std::string_view, 3> files{"emit_image.cpp", "emit_camera.cpp", "emit_model.cpp"};
    return std::ranges::find(files, file) != files.end() || file.starts_with("glsl_");
}

TEST(Keys, AreNotTypedAgainWhereScenesAreJudged) {
    const std::filesystem::path sources(TEXPLORER_SOURCE_DIR);
    std::vector<std::filesystem::path> files;
    for (const char* folder : {"core/diagnosis", "core/emit"}) {
        for (const auto& entry : std::filesystem::directory_iterator(sources / folder)) {
            const bool isSource = entry.path().extension() == ".cpp" || entry.path().extension() == ".h";
            if (isSource && !hasWordsOfPrograms(entry.path().filename().string()))
                files.push_back(entry.path());
        }
    }
    EXPECT_GT(files.size(), 20U);
    for (const std::filesystem::path& file : files)
        EXPECT_THAT(typedAgain(file), testing::IsEmpty());
}

} // namespace
} // namespace texplorer::keys_test
