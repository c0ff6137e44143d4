#include "texplorer/lesson/lesson.h"

#include <fmt/core.h>
#include <gmock/gmock.h>

namespace texplorer::lesson::lesson_json_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string lessonOf(const std::string& steps) {
    return fmt::format(R"({{"lesson": 1, "title": "L", "about": "A", "steps": [{}]}})", steps);
}

/// The first step with these members more.
std::string stepWith(const std::string& members) {
    return lessonOf(R"({"title": "S", "text": "T", "scene": "cube")" + members + "}");
}

std::string predictWith(const std::string& answers, const std::string& right = "0") {
    return stepWith(fmt::format(
        R"(, "predict": {{"question": "Q", "answers": [{}], "right": {}, "reason": "R"}})", answers, right));
}

const std::string twoAnswers = R"({"text": "one"}, {"text": "two", "edits": ["material.color=1,0,0,1"]})";

TEST(LessonJson, IsReadAsItIsWritten) {
    const Result<Lesson> read = parseLesson(R"({
        "lesson": 1, "title": "L", "source": "Chapter 2", "about": "A",
        "steps": [
            {"title": "S1", "text": "T1", "scene": "cube", "edits": ["a.b=c=d", "preset:seam"],
             "look": {"param": "a.b", "tab": "explain", "figure": "edge", "shown": "lambda", "renderer": "fixed,reference",
                      "probe": [0, 999]},
             "try": "Turn it."},
            {"title": "S2", "text": "T2",
             "predict": {"question": "Q", "right": 1, "reason": "R",
                         "answers": [{"text": "one"}, {"text": "two", "edits": ["x="]}]}},
            {"title": "S3", "text": "T3", "scene": "other.json",
             "match": {"task": "M", "edits": ["x=1"]}},
            {"title": "S4", "text": "T4", "fallback": {"text": "F", "edits": ["x=2"]}}]})");
    ASSERT_TRUE(read) << describe(read.error());
    Lesson lesson{"L", "Chapter 2", "A", {}};
    lesson.steps.push_back({"S1",
                            "T1",
                            "cube",
                            {edit::Set{"a.b", "c=d"}, edit::ApplyPreset{"seam"}},
                            {"a.b", "explain", "edge", "lambda", "fixed,reference", 0, 999},
                            Try{"Turn it."}});
    lesson.steps.push_back(
        {"S2", "T2", "", {}, {}, Predict{"Q", {{"one", {}}, {"two", {edit::Set{"x", ""}}}}, 1, "R"}});
    lesson.steps.push_back({"S3", "T3", "other.json", {}, {}, Match{"M", {edit::Set{"x", "1"}}}});
    lesson.steps.push_back({"S4", "T4", "", {}, {}, {}, Fallback{"F", {edit::Set{"x", "2"}}}});
    EXPECT_EQ(*read, lesson);
    EXPECT_THAT(textsOf(lesson), ElementsAre("L", "A", "Chapter 2", "S1", "T1", "Turn it.", "S2", "T2", "Q",
                                             "one", "two", "R", "S3", "T3", "M", "S4", "T4", "F"));
}

struct Refused {
    std::string text;
    ErrorCode code;
    const char* where;
    const char* says;
};

TEST(LessonJson, IsRefusedByPlace) {
    constexpr ErrorCode malformed = ErrorCode::Malformed;
    const std::string step = R"({"title": "S", "text": "T", "scene": "cube"})";
    std::string many = step;
    for (std::size_t i = 0; i < maxSteps; ++i)
        many += "," + step;
    const std::vector<Refused> rows{
        {"", malformed, "line 1, column 1", "the file ends"},
        {"{\n\"lesson\": 1,\n\"title\" 3}", malformed, "line 3, column 9", "expected ':' after the key"},
        {"{\"lesson\": 1}\n x", malformed, "line 2, column 2", "expected the end of the file, found 'x'"},
        {R"({"lesson": NaN})", malformed, "line 1, column 12", "expected a value, found 'NaN'"},
        {"[1]", malformed, "", "expected an object"},
        {std::string("{}\0{}", 5), malformed, "line 1, column 3", "a NUL character"},
        {"\xff", malformed, "line 1, column 1", ""},
        {R"({"lesson": 1e400})", malformed, "line 1, column 16", "a smaller number"},
        {R"({"lesson": 1, "lesson": 1})", malformed, "/lesson", R"(each key once, found "lesson" twice)"},
        {lessonOf(step + R"(, {"title": "S", "look": {"probe": [1, 2], "tab": "", "tab": ""}})"), malformed,
         "/steps/1/look/tab", R"(each key once, found "tab" twice)"},
        {std::string(100'000, '['), ErrorCode::TooLarge, "", "levels of brackets"},
        {std::string(maxLessonBytes + 1, ' '), ErrorCode::TooLarge, "", "bytes"},
        {R"({"title": "L", "about": "A"})", malformed, "", R"(expected the key "lesson")"},
        {R"({"lesson": "1", "title": "L"})", malformed, "/lesson", R"(expected version 1, found "1")"},
        {R"({"lesson": 0, "title": "L"})", malformed, "/lesson", "expected version 1, found 0"},
        {R"({"lesson": 1.0, "title": "L"})", malformed, "/lesson", "expected version 1, found 1.0"},
        {R"({"lesson": 2, "title": "L"})", ErrorCode::Unsupported, "/lesson", "expected version 1, found 2"},
        {R"({"lesson": 1, "title": "", "about": "A"})", malformed, "/title",
         R"(a text that isn't empty, found "")"},
        {R"({"lesson": 1, "title": 3, "about": "A"})", malformed, "/title", "a text"},
        {R"({"lesson": 1, "title": "L"})", malformed, "/about", "a text"},
        {R"({"lesson": 1, "title": "L", "about": "A"})", malformed, "", R"(expected the key "steps")"},
        {lessonOf(""), malformed, "/steps", "a list of 1 to 100, found 0"},
        {lessonOf(many), ErrorCode::TooLarge, "/steps", "a list of 1 to 100, found 101"},
        {lessonOf("3"), malformed, "/steps/0", "an object"},
        {lessonOf(step + R"(, {"title": "S"})"), malformed, "/steps/1/text", "a text"},
        {lessonOf(R"({"title": "S", "text": "T"})"), malformed, "/steps/0/scene", "begins with"},
        {stepWith(R"(, "titel": "S")"), malformed, "/steps/0/titel", R"(did you mean "title"?)"},
        {stepWith(R"(, "edits": "a=b")"), malformed, "/steps/0/edits", R"(a list, found "a=b")"},
        {stepWith(R"(, "edits": ["a=b", "ab"])"), malformed, "/steps/0/edits/1", R"(found "ab")"},
        {stepWith(R"(, "edits": ["=b"])"), malformed, "/steps/0/edits/0", "PATH=VALUE"},
        {stepWith(R"(, "edits": ["preset:"])"), malformed, "/steps/0/edits/0", "preset:NAME"},
        {stepWith(R"(, "edits": [3])"), malformed, "/steps/0/edits/0", "preset:NAME, found 3"},
        {stepWith(R"(, "look": 3)"), malformed, "/steps/0/look", "an object"},
        {stepWith(R"(, "look": {"tabs": "x"})"), malformed, "/steps/0/look/tabs", R"(did you mean "tab"?)"},
        {stepWith(R"(, "look": {"probe": [1]})"), malformed, "/steps/0/look/probe", "found [1]"},
        {stepWith(R"(, "look": {"probe": [1, 1000]})"), malformed, "/steps/0/look/probe", "found [1,1000]"},
        {stepWith(R"(, "look": {"probe": [-1, 1]})"), malformed, "/steps/0/look/probe", "0 to 999"},
        {stepWith(R"(, "look": {"probe": [0.5, 1]})"), malformed, "/steps/0/look/probe", "0 to 999"},
        {stepWith(R"(, "try": "")"), malformed, "/steps/0/try", "a text"},
        {stepWith(R"(, "try": "x", "match": {"task": "M", "edits": ["a=b"]})"), malformed, "/steps/0",
         "expected one of try, predict and match"},
        {stepWith(R"(, "match": {"task": "M"})"), malformed, "/steps/0/match", R"(the key "edits")"},
        {stepWith(R"(, "match": {"edits": ["a=b"]})"), malformed, "/steps/0/match/task", "a text"},
        {stepWith(R"(, "predict": {"question": "Q", "right": 0, "reason": "R"})"), malformed,
         "/steps/0/predict", R"(the key "answers")"},
        {predictWith(""), malformed, "/steps/0/predict/answers", "a list of 2 to 4, found 0"},
        {predictWith(R"({"text": "one"})"), malformed, "/steps/0/predict/answers",
         "a list of 2 to 4, found 1"},
        {predictWith(twoAnswers + "," + twoAnswers + "," + twoAnswers), ErrorCode::TooLarge,
         "/steps/0/predict/answers", "a list of 2 to 4, found 6"},
        {predictWith(R"({"text": "one"}, {"text": ""})"), malformed, "/steps/0/predict/answers/1/text",
         "a text that isn't empty"},
        {predictWith(R"({"text": "one"}, "two")"), malformed, "/steps/0/predict/answers/1",
         R"(an object, found "two")"},
        {predictWith(twoAnswers, "2"), malformed, "/steps/0/predict/right", "from 0 to 1, found 2"},
        {predictWith(twoAnswers, "-1"), malformed, "/steps/0/predict/right", "from 0 to 1"},
        {predictWith(twoAnswers, "\"one\""), malformed, "/steps/0/predict/right",
         R"(from 0 to 1, found "one")"},
        {predictWith(twoAnswers, "18446744073709551615"), malformed, "/steps/0/predict/right", "from 0 to 1"},
    };
    for (const Refused& row : rows) {
        SCOPED_TRACE(row.text.substr(0, 300));
        const Result<Lesson> read = parseLesson(row.text);
        ASSERT_FALSE(read);
        EXPECT_EQ(read.error().code, row.code);
        EXPECT_EQ(read.error().where, row.where);
        EXPECT_THAT(read.error().message, HasSubstr(row.says));
    }
    EXPECT_TRUE(parseLesson(predictWith(twoAnswers, "1")));
}

std::string withKeys(const std::string& keys) {
    return R"({"lesson": 1, "title": "L", "about": "A", "steps": [{"title": "S", "text": "T", "scene": "cube"}], "keys": [)" +
           keys + "]}";
}

TEST(LessonJson, HasKeys) {
    const Result<Lesson> read = parseLesson(withKeys(R"(
        {"key": "F", "label": "Filter", "cycle": [{"label": "one", "edits": ["a=b"]}, {"label": "two", "edits": ["a=c"]}]},
        {"key": "Page Up", "label": "Farther", "path": "view.distance", "add": 0.02},
        {"key": "7", "label": "Turn", "path": "models[0].spin", "component": "y", "add": -2})"));
    ASSERT_TRUE(read) << describe(read.error());
    const std::vector<LessonKey> expected{
        {"F", "Filter", Cycle{{{"one", {edit::Set{"a", "b"}}}, {"two", {edit::Set{"a", "c"}}}}}},
        {"Page Up", "Farther", Addition{"view.distance", 0, 0.02F}},
        {"7", "Turn", Addition{"models[0].spin", 1, -2}},
    };
    EXPECT_EQ(read->keys, expected);
    EXPECT_THAT(textsOf(*read), ElementsAre("L", "A", "S", "T", "Filter", "one", "two", "Farther", "Turn"));
}

TEST(LessonJson, RefusesKeysByPlace) {
    const std::string cycle = R"("cycle": [{"label": "one", "edits": ["a=b"]}])";
    const std::string good = R"({"key": "F", "label": "L", )" + cycle + "}";
    struct Row {
        std::string keys;
        const char* where;
        const char* says;
    };
    const std::vector<Row> rows{
        {"3", "/keys/0", "an object"},
        {R"({"label": "L", )" + cycle + "}", "/keys/0/key", "a text"},
        {R"({"key": "f", "label": "L", )" + cycle + "}", "/keys/0/key", "A to Z, 0 to 9 or one of Up, Down"},
        {R"({"key": "Escape", "label": "L", )" + cycle + "}", "/keys/0/key", "Page Up"},
        {good + "," + good, "/keys/1/key", "found F again"},
        {R"({"key": "F", )" + cycle + "}", "/keys/0/label", "a text"},
        {R"({"key": "F", "label": "L"})", "/keys/0", "either cycle, or path and add, found neither"},
        {R"({"key": "F", "label": "L", "path": "a", "add": 1, )" + cycle + "}", "/keys/0",
         "path and add, found both"},
        {R"({"key": "F", "label": "L", "cycle": []})", "/keys/0/cycle", "a list of 1 to 8, found 0"},
        {R"({"key": "F", "label": "L", "cycle": [{"label": "one"}]})", "/keys/0/cycle/0",
         R"(the key "edits")"},
        {R"({"key": "F", "label": "L", "cycle": [{"edits": ["a=b"]}]})", "/keys/0/cycle/0/label", "a text"},
        {R"({"key": "F", "label": "L", "cycle": [{"label": "one", "edits": ["ab"]}]})",
         "/keys/0/cycle/0/edits/0", "PATH=VALUE"},
        {R"({"key": "F", "label": "L", "path": "a"})", "/keys/0/add", "a number other than 0"},
        {R"({"key": "F", "label": "L", "path": "a", "add": 0})", "/keys/0/add",
         "a number other than 0 between -3.4e38 and 3.4e38, found 0"},
        {R"({"key": "F", "label": "L", "path": "a", "add": 1e300})", "/keys/0/add",
         "a number other than 0 between -3.4e38 and 3.4e38, found 1e+300"},
        {R"({"key": "F", "label": "L", "path": "a", "add": "1"})", "/keys/0/add", R"(3.4e38, found "1")"},
        {R"({"key": "F", "label": "L", "path": "a", "add": 1, "component": "s"})", "/keys/0/component",
         R"(one of x, y, z, w, found "s")"},
        {R"({"key": "F", "label": "L", "path": "a", "add": 1, "speed": 3})", "/keys/0/speed", "unknown key"},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.keys);
        const Result<Lesson> read = parseLesson(withKeys(row.keys));
        ASSERT_FALSE(read);
        EXPECT_EQ(read.error().code, ErrorCode::Malformed);
        EXPECT_EQ(read.error().where, row.where);
        EXPECT_THAT(read.error().message, HasSubstr(row.says));
    }
}

TEST(LessonJson, SaysTheFirstOfSeveralProblems) {
    const Result<Lesson> read = parseLesson(lessonOf(R"({"title": "", "text": "", "scene": 3, "more": 1})"));
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().where, "/steps/0/title");
}

} // namespace
} // namespace texplorer::lesson::lesson_json_test
