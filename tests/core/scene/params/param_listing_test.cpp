#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/param_listing.h"
#include "texplorer/scene/params/params.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cctype>
#include <map>
#include <set>
#include <sstream>

namespace texplorer::param_listing_test {
namespace {

using testing::HasSubstr;

/// The path of every parameter of a scene that has one of everything, without its numbers.
std::set<std::string> allPaths() {
    Scene scene;
    scene.models.resize(1);
    scene.textures.resize(1);
    scene.textures[0].levels.resize(1);
    scene.textures[0].preparation.resize(1);
    scene.textures[0].subimages.resize(1);
    scene.passes[0].units[0].matrix.resize(1);
    scene.models[0].units[0].matrix.resize(1);
    scene.timeline.keys.resize(1);
    std::set<std::string> paths;
    forEachParam(scene, [&](const std::string& path, const ParamRow&, const Value&) {
        std::string schema;
        for (const char c : path) // only a number between brackets follows one
            if (!(std::isdigit(static_cast<unsigned char>(c)) != 0 && schema.ends_with('[')))
                schema += c;
        paths.insert(schema);
    });
    return paths;
}

TEST(ListParams, HasEveryParameterOnceWithItsHelpAndEveryChoice) {
    const std::string text = listParams();
    std::multiset<std::string> listed;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(line.size(), 120U) << line;
        EXPECT_FALSE(line.ends_with(' ')) << line;
        if (!line.empty() && line.front() != ' ' && line.find("of them") == std::string::npos)
            listed.insert(line.substr(0, line.find(' ')));
    }
    const auto paths = allPaths();
    EXPECT_EQ(listed, std::multiset<std::string>(paths.begin(), paths.end()));
    EXPECT_EQ(paths.size(), 231U);
    EXPECT_TRUE(text.ends_with("\n"));
    EXPECT_FALSE(text.ends_with("\n\n"));
}

TEST(ListParams, ReadsLikeThis) {
    const std::string text = listParams();
    EXPECT_THAT(text, HasSubstr("\ntextures[]   0 to 64 of them, counted from 0\n"));
    EXPECT_THAT(text, HasSubstr("\npasses[].units[]   always 4 of them, counted from 0\n"));
    EXPECT_THAT(text, HasSubstr("\ntextures[].magFilter = GL_LINEAR\n"));
    EXPECT_THAT(text, HasSubstr("\n"
                                "      GL_NEAREST  Reads the one texel"));
    EXPECT_THAT(text, HasSubstr("\n    Accepts a number from 1 to 16.\n"));
    EXPECT_THAT(text, HasSubstr("\n    glDepthFunc({})\n"));
    EXPECT_THAT(text, HasSubstr("\n    One element is models[].texCoords0[].\n"));
    EXPECT_THAT(text, HasSubstr("\npasses[].units[].matrix[].matrix = 1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1\n"));
    EXPECT_THAT(text, HasSubstr("\n    Accepts 16 numbers, each from -1e+06 to 1e+06.\n"));
    EXPECT_THAT(text, HasSubstr("\npasses[].models\n"));
    EXPECT_THAT(text, HasSubstr("\n    Accepts whole numbers, each from 0 to 15.\n"));
    EXPECT_THAT(text, HasSubstr("\nmodels[].mesh.positions\n"));
    EXPECT_THAT(text, HasSubstr("\n    Accepts 3 finite numbers for each vertex.\n"));
}

TEST(ListParamsJson, HasEveryParameterOnceWithAllThatItsRowSays) {
    const auto json = nlohmann::json::parse(listParamsJson());
    EXPECT_EQ(json.at("version"), 1);
    std::multiset<std::string> listed;
    for (const auto& param : json.at("parameters")) {
        const std::string path = param.at("path");
        listed.insert(path);
        for (const char* key : {"kind", "group", "label", "help", "glCall"})
            EXPECT_TRUE(param.at(key).is_string()) << path;
        const std::string kind = param.at("kind");
        EXPECT_EQ(param.contains("choices"), kind == "enum") << path;
        EXPECT_EQ(param.contains("range"), (std::set<std::string>{"int", "float", "vec3", "vec4", "color",
                                                                  "matrix", "colors", "indices"})
                                               .contains(kind))
            << path;
    }
    const auto paths = allPaths();
    EXPECT_EQ(listed, std::multiset<std::string>(paths.begin(), paths.end()));
}

TEST(ListParamsJson, HasShortNumbersAndTypedDefaults) {
    const std::string text = listParamsJson();
    EXPECT_EQ(text.find("0.20000000"), std::string::npos);
    const auto json = nlohmann::json::parse(text);
    const auto find = [&](std::string_view path) {
        for (const auto& param : json.at("parameters"))
            if (param.at("path") == path)
                return param;
        return nlohmann::json();
    };
    EXPECT_EQ(find("light.modelAmbient").at("default"), nlohmann::json({0.2, 0.2, 0.2, 1}));
    EXPECT_EQ(find("textures[].maxLevel").at("default"), 1000);
    EXPECT_EQ(find("passes[].blend").at("default"), false);
    EXPECT_EQ(find("textures[].wrapS").at("default"), "GL_REPEAT");
    EXPECT_EQ(find("textures[].wrapS").at("choices").size(), 5U);
    EXPECT_EQ(find("view.fieldOfView").at("range").at("unit"), "deg");
    EXPECT_EQ(find("passes[].units[].matrix[].rate").at("kind"), "vec3");
    EXPECT_EQ(find("passes[].units[].matrix[].matrix").at("default"),
              nlohmann::json({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}));
    EXPECT_EQ(find("passes[].models").at("default"), nlohmann::json::array());
    EXPECT_EQ(find("models[].material.ambient").at("default"), nlohmann::json({0.2, 0.2, 0.2, 1}));
    EXPECT_EQ(json.at("lists").size(), 11U);
    EXPECT_EQ(json.at("lists")[2].at("path"), "models[].units[].matrix[]");
    EXPECT_EQ(json.at("lists")[10].at("path"), "timeline[]");
    EXPECT_EQ(json.at("lists")[9].at("path"), "passes[].units[].matrix[]");
    EXPECT_EQ(json.at("lists")[9].at("maxCount"), 32);
}

TEST(ListParamsJson, NamesEveryKind) {
    const auto json = nlohmann::json::parse(listParamsJson());
    std::map<std::string, std::string> kinds; // with a row that has it
    for (const auto& param : json.at("parameters"))
        kinds.emplace(param.at("kind"), param.at("path"));
    EXPECT_EQ(kinds.size(), 13U);
    EXPECT_EQ(kinds["points"], "models[].mesh.positions");
    EXPECT_EQ(kinds["colors"], "models[].mesh.colors");
    EXPECT_EQ(kinds["indices"], "models[].noTexCoord0");
    EXPECT_EQ(kinds["matrix"], "models[].units[].matrix[].matrix");
    EXPECT_EQ(kinds["text"], "models[].name");
}

TEST(ListParams, GivesWhatASceneHasThatDoesNotSayIt) {
    // What a file that names no more than its elements becomes.
    Scene scene = parseScene(R"({"version": 1, "models": [{"units": [{"matrix": [{}]}]}],
                                       "textures": [{"levels": [{}], "preparation": [{}], "subimages": [{}]}],
                                       "passes": [{"units": [{"matrix": [{}]}]}]})")
                      .value();
    scene.timeline.keys.resize(1); // a file's has to name its parameter
    const auto json = nlohmann::json::parse(listParamsJson());
    const std::string text = "\n" + listParams();
    for (const auto& param : json.at("parameters")) {
        std::string path = param.at("path");
        const std::string listed = path;
        for (std::size_t at = path.find("[]"); at != std::string::npos; at = path.find("[]"))
            path.replace(at, 2, "[0]");
        const std::string value = getParam(scene, path).value();
        EXPECT_THAT(text, HasSubstr("\n" + listed + (value.empty() ? "\n" : " = " + value + "\n")));
    }
    EXPECT_THAT(text, HasSubstr("\nview.elevation = 18\n"));
    EXPECT_THAT(text, HasSubstr("\nmodels[].position = 0,0,0\n"));
}

TEST(ListParams, AFilterLeavesParametersAndTheListsThatTheyLieIn) {
    const ParamFilter matrices = [](const std::string& path, const ParamRow&) {
        return path == "passes[].units[].matrix[].angle" || path == "view.azimuth";
    };
    const auto listed = nlohmann::json::parse(listParamsJson(matrices));
    std::vector<std::string> paths;
    std::vector<std::string> lists;
    for (const auto& each : listed["parameters"])
        paths.push_back(each["path"]);
    for (const auto& each : listed["lists"])
        lists.push_back(each["path"]);
    EXPECT_THAT(paths, testing::ElementsAre("view.azimuth", "passes[].units[].matrix[].angle"));
    EXPECT_THAT(lists, testing::ElementsAre("passes[]", "passes[].units[]", "passes[].units[].matrix[]"));
    const std::string text = listParams(matrices);
    EXPECT_THAT(text, HasSubstr("passes[].units[]   always 4 of them"));
    EXPECT_THAT(text, testing::EndsWith("\n"));
    EXPECT_THAT(text, testing::Not(HasSubstr("textures[]")));
}

TEST(ListParams, WhatTheFilterLeavesEmptyIsEmpty) {
    const ParamFilter nothing = [](const std::string&, const ParamRow&) { return false; };
    EXPECT_EQ(listParams(nothing), "");
    EXPECT_EQ(listParamsJson(nothing), "");
}

} // namespace
} // namespace texplorer::param_listing_test
