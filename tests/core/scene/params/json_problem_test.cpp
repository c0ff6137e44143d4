#include "texplorer/scene/params/json_problem.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <random>
#include <string>

namespace texplorer::json_problem_test {
namespace {

/// What is said of a text that the library refuses, and where; empty: it reads it.
std::string problemOf(const std::string& text) {
    const auto said = [&](const auto& error, std::size_t position) {
        const JsonProblem problem = jsonProblem(text, error.id, position);
        return problem.where.text() + ": " + problem.message.english();
    };
    try {
        return nlohmann::json::parse(text).is_discarded() ? "discarded" : "";
    } catch (const nlohmann::json::parse_error& error) {
        return said(error, error.byte);
    } catch (const nlohmann::json::out_of_range& error) {
        return said(error, 0);
    }
}

TEST(JsonProblem, SaysWhatWasExpectedAndFound) {
    struct Row {
        std::string text;
        std::string problem;
    };
    for (const auto& [text, problem] : {
             Row{"", "line 1, column 1: the file ends; expected a value"},
             Row{" \n", "line 2, column 1: the file ends; expected a value"},
             Row{"{} x", "line 1, column 4: expected the end of the file, found 'x'"},
             Row{"{} {}", "line 1, column 4: expected the end of the file, found '{'"},
             Row{"[NaN]", "line 1, column 2: expected a value, found 'NaN'"},
             Row{"[-Infinity]", "line 1, column 3: expected a digit, found 'Infinity'"},
             Row{"[nul]", "line 1, column 2: expected a value, found 'nul'"},
             Row{"[true/", "line 1, column 6: expected ',' or ']', found '/'"},
             Row{"[\xC3\xA9]", "line 1, column 2: expected a value, found '\xC3\xA9'"},
             Row{"[\x1B]", "line 1, column 2: expected a value, found '\\u001b'"},
             Row{"[", "line 1, column 2: the file ends in the middle of an array; expected a value"},
             Row{"[1,", "line 1, column 4: the file ends in the middle of an array; expected a value"},
             Row{"[1,]", "line 1, column 4: expected a value, found ']'"},
             Row{"[1 2]", "line 1, column 4: expected ',' or ']', found a number"},
             Row{"{", "line 1, column 2: the file ends in the middle of an object; expected a key in quotes"},
             Row{R"({"a")",
                 "line 1, column 5: the file ends in the middle of an object; expected ':' after the key"},
             Row{R"({"a":)", "line 1, column 6: the file ends in the middle of an object; expected a value"},
             Row{R"({"a":1)",
                 "line 1, column 7: the file ends in the middle of an object; expected ',' or '}'"},
             Row{R"({"a":1,})", "line 1, column 8: expected a key in quotes, found '}'"},
             Row{R"({"a" 1})", "line 1, column 6: expected ':' after the key, found a number"},
             Row{R"({"a":1 "b":2})", "line 1, column 8: expected ',' or '}', found a text in quotes"},
             Row{R"({1:2})", "line 1, column 2: expected a key in quotes, found a number"},
             Row{R"({"a":[}])", "line 1, column 7: expected a value, found '}'"},
             Row{"[01]", "line 1, column 3: expected ',' or ']', found a number"},
             Row{"[1.]", "line 1, column 4: expected a digit, found ']'"},
             Row{"[1e", "line 1, column 4: the file ends in the middle of a number; expected a digit"},
             Row{"[1e999]", "line 1, column 1: expected a smaller number"},
             Row{R"(["a)", "line 1, column 4: the file ends in the middle of a text; expected a quote"},
             Row{"[\"a\n\"]", "line 1, column 4: the line ends in the middle of a text; expected a quote"},
             Row{"[\"a\t\"]", "line 1, column 4: expected \\u0009 for a control character in a text"},
             Row{R"(["\x"])", "line 1, column 4: expected an escape such as \\\" or \\u00e9, found 'x'"},
             Row{R"(["\u12g4"])", "line 1, column 7: expected four hexadecimal digits after \\u"},
             Row{R"(["\ud800"])",
                 "line 1, column 3: expected a surrogate pair, such as \\ud83d\\ude00, found one half"},
             Row{R"(["\"])", "line 1, column 6: the file ends in the middle of a text; expected a quote"},
             Row{"[\"a\xFF\"]", "line 1, column 4: expected UTF-8, found the byte FF"},
             Row{"[\"\xC3(\"]", "line 1, column 3: expected UTF-8, found the byte C3"},
             Row{"\xEF\xBB\xBF[",
                 "line 1, column 2: the file ends in the middle of an array; expected a value"},
             Row{R"({"version":1 "a long text"})",
                 "line 1, column 14: expected ',' or '}', found a text in quotes"},
             Row{R"({true:1})", "line 1, column 2: expected a key in quotes, found 'true'"},
             Row{R"({"a":nulx})", "line 1, column 6: expected a value, found 'nulx'"},
             Row{"[\"\xC3\xA9\xF0\x9F\x98\x80\" 1]", "line 1, column 7: expected ',' or ']', found a number"},
             Row{R"(["\u12"])", "line 1, column 7: expected four hexadecimal digits after \\u"},
             Row{R"(["\ud800x"])",
                 "line 1, column 3: expected a surrogate pair, such as \\ud83d\\ude00, found one half"},
             Row{R"(["\ud83d\ud83d"])",
                 "line 1, column 3: expected a surrogate pair, such as \\ud83d\\ude00, found one half"},
             Row{R"(["\udc00"])",
                 "line 1, column 3: expected a surrogate pair, such as \\ud83d\\ude00, found one half"},
             Row{"[\"\\\xC3\xA9\"]",
                 "line 1, column 4: expected an escape such as \\\" or \\u00e9, found '\xC3\xA9'"},
             Row{"[\"\xED\xA0\x80\"]", "line 1, column 3: expected UTF-8, found the byte ED"},
             Row{"\xEF\xBB\xBF", "line 1, column 1: the file ends; expected a value"},
             Row{"{\r\n\"a\" 1}", "line 2, column 5: expected ':' after the key, found a number"},
             Row{R"({"a": [1, true, null, -0.5e+3, "\u00e9\\", {}, []]})", ""},
         })
        EXPECT_EQ(problemOf(text), problem) << text;
}

/// Texts that the library refuses are found wrong by the reading that says why: it has the same grammar.
TEST(JsonProblem, FindsSomethingInEverythingThatTheLibraryRefuses) {
    const std::string good =
        R"({"a": [1, -2.5e3, true, "te\ud83d\udE00xt\n"], "b": {"c": null, "d": []}, "": [[{}]]})";
    const std::string signs = "{}[],:\"\\ 0-.eE1tfnu\n\x1F\x80\xC3/";
    std::mt19937 random(33);
    int refused = 0;
    for (int i = 0; i < 5'000; ++i) {
        std::string text = good;
        for (int changes = 1 + static_cast<int>(random() % 3); changes > 0; --changes) {
            const std::size_t at = random() % text.size();
            if (random() % 3 == 0)
                text.erase(at, 1 + random() % 4);
            else if (random() % 2 == 0)
                text.insert(at, 1, signs[random() % signs.size()]);
            else
                text[at] = signs[random() % signs.size()];
        }
        const std::string problem = problemOf(text);
        refused += problem.empty() ? 0 : 1;
        ASSERT_EQ(problem.find("expected JSON"), std::string::npos) << text;
    }
    EXPECT_GT(refused, 2'500);
}

} // namespace
} // namespace texplorer::json_problem_test
