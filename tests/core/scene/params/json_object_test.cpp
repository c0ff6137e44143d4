#include "texplorer/scene/params/json_object.h"

#include <gtest/gtest.h>

#include <functional>

namespace texplorer::json_object_test {
namespace {

using Json = nlohmann::json;

/// The first problem that reading an object finds, as "where: message"; empty if there is none.
std::string problemOf(const char* text, const std::function<void(JsonObject&)>& read) {
    const Json json = Json::parse(text);
    std::optional<Error> problem;
    {
        JsonObject object(json, "/it", problem);
        read(object);
    }
    return problem ? describe(*problem) : "";
}

TEST(JsonObject, ReadsWhatItIsAskedFor) {
    std::string text;
    bool flag = false;
    double number = 0;
    std::size_t count = 0;
    int whole = 0;
    std::vector<std::string> places;
    const auto take = [&](const Json& each, const std::string& place) {
        places.push_back(place + "=" + each.dump());
    };
    EXPECT_EQ(
        problemOf(
            R"({"text": "a", "flag": true, "number": 0.5, "count": 3, "whole": -3, "one": 1, "many": [2, 3]})",
            [&](JsonObject& object) {
                object.text("text", text, 1);
                object.flag("flag", flag);
                object.number("number", number, 0, 0.5);
                object.whole("count", count, 3, 3);
                object.whole("whole", whole, -3, 0);
                EXPECT_TRUE(object.oneOrMore("one", 2, take));
                EXPECT_FALSE(object.oneOrMore("none", 2, take));
                object.list("many", 2, 2, take);
            }),
        "");
    EXPECT_EQ(text, "a");
    EXPECT_TRUE(flag);
    EXPECT_EQ(number, 0.5);
    EXPECT_EQ(count, 3U);
    EXPECT_EQ(whole, -3);
    EXPECT_EQ(places, (std::vector<std::string>{"/it/one=1", "/it/many/0=2", "/it/many/1=3"}));
}

TEST(JsonObject, LeavesWhatIsMissing) {
    int whole = 7;
    EXPECT_EQ(problemOf("{}", [&](JsonObject& object) { object.whole("whole", whole, 0, 1); }), "");
    EXPECT_EQ(whole, 7);
}

TEST(JsonObject, SaysWhatWasExpectedAndFoundAndWhere) {
    double number = 0;
    const auto read = [&](JsonObject& object) { object.number("size", number, 1, 8); };
    EXPECT_EQ(problemOf(R"({"size": 9})", read), "/it/size: expected a number from 1 to 8, found 9");
    EXPECT_EQ(problemOf(R"({"size": "9"})", read), "/it/size: expected a number from 1 to 8, found \"9\"");
    EXPECT_EQ(problemOf("[]", read), "/it: expected an object, found a list");
    EXPECT_EQ(number, 0);
}

TEST(JsonObject, RefusesKeysThatAreNotRead) {
    int ignored = 0;
    const auto read = [&](JsonObject& object) { object.whole("size", ignored, 0, 9); };
    EXPECT_EQ(problemOf(R"({"siez": 1})", read), "/it/siez: unknown key; did you mean \"size\"?");
}

TEST(JsonObject, NeedsAKeyAndALengthWhereAsked) {
    const auto read = [](JsonObject& object) {
        object.list("steps", 1, 2, [](const Json&, const std::string&) {});
    };
    EXPECT_EQ(problemOf("{}", read), "/it: expected the key \"steps\"");
    EXPECT_EQ(problemOf(R"({"steps": []})", read), "/it/steps: expected a list of 1 to 2, found 0");
    EXPECT_EQ(problemOf(R"({"steps": [1, 2, 3]})", read), "/it/steps: expected a list of 1 to 2, found 3");
    EXPECT_EQ(problemOf(R"({"steps": 1})", read), "/it/steps: expected a list, found 1");
}

TEST(JsonObject, ReportsTheFirstProblemOnly) {
    int whole = 0;
    EXPECT_EQ(problemOf(R"({"a": -1, "b": -1, "c": 1})",
                        [&](JsonObject& object) {
                            object.whole("b", whole, 0, 1);
                            object.whole("a", whole, 0, 1);
                        }),
              "/it/b: expected a whole number from 0 to 1, found -1");
}

} // namespace
} // namespace texplorer::json_object_test
