#include "texplorer/scene/params/json_problem.h"

#include "texplorer/scene/params/param_text.h"
#include "texplorer/text/printable.h"
#include "texplorer/text/utf8.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace texplorer {

namespace {

/// What was being read, and what may come there.
struct Expectation {
    std::string_view context;
    std::string_view inside;
    std::string_view expected;
};

constexpr std::array places{
    Expectation{"object key", "an object", "a key in quotes"},
    Expectation{"object separator", "an object", "':' after the key"},
    Expectation{"object", "an object", "',' or '}'"},
    Expectation{"array", "an array", "',' or ']'"},
    Expectation{"value", "", "a value"},
};

constexpr std::string_view beforeContext = "syntax error while parsing ";
constexpr std::string_view unexpected = "unexpected ";
constexpr std::string_view theEnd = "end of input";
constexpr std::string_view emptyInput = "empty"; // "attempting to parse an empty input", nlohmann 3.11.3

/// "string literal" is the library's name for it.
std::string foundText(std::string_view token) {
    if (token == "string literal")
        return "a text in quotes";
    if (token == "number literal")
        return "a number";
    if (const std::size_t at = token.find(" literal"); at != std::string_view::npos)
        token = token.substr(0, at);
    return printable(token);
}

bool isLetter(char each) {
    return (each >= 'a' && each <= 'z') || (each >= 'A' && each <= 'Z');
}

} // namespace

std::string wordAt(std::string_view text, std::size_t position) {
    const std::size_t at = std::min(text.size(), std::max<std::size_t>(position, 1) - 1);
    std::size_t begin = at;
    std::size_t end = at;
    while (begin > 0 && isLetter(text[begin - 1]))
        --begin;
    while (end < text.size() && isLetter(text[end]))
        ++end;
    std::string_view word = text.substr(begin, end - begin);
    constexpr std::array<std::string_view, 3> words{"true", "false", "null"};
    if (word.empty() || std::ranges::find(words, word) != words.end()) // then it is the sign after it
        word = text.substr(at, std::max<std::size_t>(firstCharacter(text.substr(at)).bytes, 1));
    return word.empty() ? std::string() : fmt::format("'{}'", shortened(word));
}

Sentence readableProblem(std::string_view said, std::string_view found) {
    const bool isAfterTheEnd = said.ends_with(theEnd);
    said = said.substr(0, said.find("; last read")); // which may be long, and not even UTF-8
    if (!said.starts_with(beforeContext) && said.find(emptyInput) != std::string_view::npos)
        return Sentence("the file ends; expected {0}", places.back().expected);
    const std::size_t dash = said.find(" - ");
    if (!said.starts_with(beforeContext) || dash == std::string_view::npos)
        return printable(said);
    const std::string_view context = said.substr(beforeContext.size(), dash - beforeContext.size());
    std::string_view problem = said.substr(dash + 3);
    const auto place = std::ranges::find(places, context, &Expectation::context);
    if (place == places.end())
        return printable(said);
    if (problem == "invalid literal") // neither a word nor a sign that JSON has
        return isAfterTheEnd ? Sentence("expected the end of the file, found {0}", ProperName{found})
                             : Sentence("expected {0}, found {1}", place->expected, ProperName{found});
    if (!problem.starts_with(unexpected)) // "invalid string: missing closing quote"
        return printable(problem);
    problem.remove_prefix(unexpected.size());
    const std::size_t semicolon = problem.find("; expected ");
    const std::string_view token = problem.substr(0, semicolon);
    if (semicolon != std::string_view::npos && problem.substr(semicolon).ends_with(theEnd))
        return Sentence("expected the end of the file, found {0}", foundText(token));
    if (token != theEnd)
        return Sentence("expected {0}, found {1}", place->expected, foundText(token));
    return place->inside.empty()
               ? Sentence("the file ends; expected {0}", place->expected)
               : Sentence("the file ends in the middle of {0}; expected {1}", place->inside, place->expected);
}

Sentence mistakeIn(int exception, std::string_view said, std::string_view found) {
    constexpr int numberOverflow = 406;
    if (exception == numberOverflow)
        return "expected a smaller number";
    const std::size_t syntax = said.find("syntax error");
    return readableProblem(syntax == std::string_view::npos ? said : said.substr(syntax), found);
}

} // namespace texplorer
