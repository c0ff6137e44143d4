#include "app/screenshot/output/json_text.h"
#include "app/screenshot/output/message_ids.h"

#include <gmock/gmock.h>

#include <limits>
#include <string>
#include <vector>

namespace texplorer::screenshot::json_text_test {
namespace {

using Json = nlohmann::ordered_json;

Json documentOf(Json results) {
    return Json::parse(documentText(std::move(results)));
}

TEST(JsonText, HasOneShape) {
    noteCommand("info");
    const Json document = documentOf(Json::array({{{"file", "a.bmp"}}}));
    std::vector<std::string> keys;
    for (const auto& [key, value] : document.items())
        keys.push_back(key);
    EXPECT_THAT(keys, testing::ElementsAre("texshot", "schema", "command", "results", "problems"));
    EXPECT_EQ(document["command"], "info");
    EXPECT_EQ(document["results"], Json::parse(R"([{"file": "a.bmp"}])"));
}

TEST(JsonText, GivesAFloatItsFewestDigits) {
    const Json results =
        documentOf(Json::array({0.1F, 1.0F / 3, 2.0F, 0.1, 1e10F, -0.0F, 16777216.0F}))["results"];
    EXPECT_EQ(results.dump(), "[0.1,0.33333334,2.0,0.1,10000000000.0,-0.0,16777216.0]");
    const float inf = std::numeric_limits<float>::infinity();
    EXPECT_EQ(
        documentOf(Json::array({inf, std::numeric_limits<double>::quiet_NaN(), 1.0 / 3}))["results"].dump(),
        "[null,null,0.3333333333333333]");
}

TEST(JsonText, NamesAMessageByItsId) {
    const Sentence sentence("expected {0} of these words", 3);
    EXPECT_EQ(messageJson(sentence).dump(),
              R"({"id":null,"message":"expected 3 of these words","arguments":[3]})");
    const Json opened = messageJson(Sentence("can't be opened: {0}", "No such file"));
    ASSERT_TRUE(opened["id"].is_number_integer());
    EXPECT_EQ(opened["id"], messageJson(Sentence("can't be opened: {0}", "Is a directory"))["id"]);
    EXPECT_EQ(opened["arguments"], Json::array({"No such file"}));
    EXPECT_EQ(idOf(Sentence::plural("{0} byte", "{0} bytes", 1)),
              idOf(Sentence::plural("{0} byte", "{0} bytes", 2)))
        << "the forms of a plural are one message";
}

TEST(JsonText, HasArgumentsOfEachKind) {
    const Sentence inner("can't be opened: {0}", "x");
    const Json arguments = messageJson(
        Sentence("{0} {1} {2:.2f} {3} {4:04X}", -7, ProperName{"12"}, 0.25, inner, 255))["arguments"];
    EXPECT_EQ(arguments[0], -7);
    EXPECT_EQ(arguments[1], "12") << "a name stays a text";
    EXPECT_EQ(arguments[2], 0.25);
    EXPECT_EQ(arguments[3]["message"], "can't be opened: x");
    EXPECT_EQ(arguments[3]["id"], *idOf(inner));
    EXPECT_EQ(arguments[4], 255) << "however it is written";
}

TEST(JsonText, TellsAProblemFromItsPlace) {
    const Error error{ErrorCode::NotFound, Sentence("can't be opened: {0}", "x"),
                      atPointer("/steps/0") / inFile("a: b.json") / atLine(2, 5)};
    const Json problem = problemJson(within(inFile("lesson.json"), error));
    EXPECT_EQ(
        problem["where"].dump(),
        R"([{"file":"lesson.json"},{"pointer":"/steps/0"},{"file":"a: b.json"},{"line":2,"column":5}])");
    EXPECT_EQ(problem["message"], "can't be opened: x");
    EXPECT_EQ(problem["code"], "NotFound");
    EXPECT_EQ(problemJson({ErrorCode::OutOfRange, "x", {}})["where"], Json::array());
    EXPECT_EQ(problemJson({ErrorCode::OutOfRange, "x", atLine(3)})["where"].dump(), R"([{"line":3}])");
    EXPECT_EQ(problemJson({ErrorCode::OutOfRange, "x", "view.azimuth"})["where"].dump(),
              R"([{"parameter":"view.azimuth"}])");
    EXPECT_EQ(problemJson({ErrorCode::OutOfRange, "x", atOption("--size")})["where"].dump(),
              R"([{"option":"--size"}])");
}

TEST(JsonText, ReplacesWhatIsNotUtf8) {
    EXPECT_EQ(documentOf(Json::array({"caf\xE9"}))["results"][0], "caf\xEF\xBF\xBD");
}

TEST(JsonText, HasADocumentOnlyOfACallThatFailed) {
    EXPECT_EQ(errorText(), "");
    noteError({ErrorCode::TooLarge, "a test's own sentence", {}});
    const Json document = Json::parse(errorText());
    EXPECT_EQ(document["results"], Json::array());
    EXPECT_EQ(document["problems"][0]["message"], "a test's own sentence");
    EXPECT_EQ(document["problems"][0]["id"], nullptr);
}

TEST(MessageIds, AreOfTextsAsTheyAre) {
    EXPECT_NE(idOf(Sentence("the file does not begin with \"BM\"")), std::nullopt) << "escaped in the file";
    EXPECT_EQ(idOf(Sentence("")), std::nullopt);
}

} // namespace
} // namespace texplorer::screenshot::json_text_test
