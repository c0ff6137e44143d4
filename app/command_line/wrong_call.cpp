#include "app/command_line/wrong_call.h"

#include "texplorer/text/nearest_name.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer {
namespace {

constexpr std::size_t maxNamed = 3;
constexpr std::size_t minLetters = 2; // shortest beginning of a name that is recognised

std::vector<std::string_view> meantBy(std::string_view word, const std::vector<std::string_view>& names) {
    std::vector<std::string_view> meant;
    if (word.size() >= minLetters)
        std::ranges::copy_if(names, std::back_inserter(meant),
                             [&](std::string_view name) { return name.starts_with(word); });
    if (meant.empty())
        meant = nearestNames(word, names);
    meant.resize(std::min(meant.size(), maxNamed));
    return meant;
}

/// "a", "a or b", "a, b or c"
std::string oneOf(const std::vector<std::string_view>& names, std::string_view mark) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += fmt::format("{}{}{}{}",
                            i == 0                  ? ""
                            : i + 1 == names.size() ? " or "
                                                    : ", ",
                            mark, names[i], mark);
    return text;
}

/// The innermost command that was called.
const CLI::App& calledOf(const CLI::App& program) {
    const CLI::App* app = &program;
    for (std::vector<CLI::App*> called = app->get_subcommands(); !called.empty();
         called = app->get_subcommands())
        app = called.front();
    return *app;
}

/// The option that a message of CLI11 names before `rest`. Empty: another message.
std::string_view aboutIn(std::string_view said, std::string_view rest) {
    const std::size_t at = said.find(rest);
    return at == std::string_view::npos ? std::string_view() : said.substr(0, at);
}

std::string quotedValues(const CLI::App& app, const std::string& option) {
    std::string text;
    const CLI::Option* found = app.get_option_no_throw(option);
    for (const std::string& value : found != nullptr ? found->results() : std::vector<std::string>())
        text += fmt::format("{}\"{}\"", text.empty() ? "" : " and ", value);
    return text;
}

} // namespace

std::string didYouMean(std::string_view word, const std::vector<std::string_view>& names) {
    const std::vector<std::string_view> meant = meantBy(word, names);
    return meant.empty() ? std::string() : fmt::format("; did you mean {}?", oneOf(meant, "\""));
}

std::string didYouMeanOption(const CLI::App& app, std::string_view word) {
    const std::string_view asked = word.substr(0, word.find('='));
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
    // CLI11 reports a long name with one dash as short options: "-size".
    const std::string full = asked.starts_with("--") ? std::string(asked) : fmt::format("-{}", asked);
    if (full.size() < 2 + minLetters) // a single letter is similar to everything
        return {};
    const std::vector<std::string_view> meant =
        meantBy(full, std::vector<std::string_view>(names.begin(), names.end()));
    return meant.empty() ? std::string() : fmt::format("; did you mean {}?", oneOf(meant, ""));
}

Sentence sentenceFor(const CLI::App& program, const std::string& called, const CLI::ParseError& error) {
    const CLI::App& app = calledOf(program);
    const std::string said = error.what();
    const std::vector<std::string> extra = app.remaining(true);
    // Report an unknown option first, even if something else is missing.
    const auto unknown = std::ranges::find_if(
        extra, [](const std::string& word) { return word.size() > 1 && word.starts_with("-"); });
    if (unknown != extra.end() && *unknown != "--") {
        const std::string meant = didYouMeanOption(app, *unknown);
        return Sentence("there is no option {0}{1}", *unknown,
                        meant.empty() ? fmt::format("; see {} --help", called) : meant);
    }
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError) && !extra.empty())
        return Sentence("expected no further argument, found \"{0}\"; see {1} --help", extra.front(), called);

    // "--size: 1 required TEXT missing"
    if (const std::string_view option = aboutIn(said, ": 1 required ");
        !option.empty() && said.ends_with(" missing"))
        return Sentence("{0}: expected a value, found none", option);
    if (const std::string_view option = aboutIn(said, ": At Most 1 required but received "); !option.empty())
        return Sentence("{0}: expected one value, found {1}", option, quotedValues(app, std::string(option)));
    if (const std::string_view option = aboutIn(said, " was given a disallowed flag override");
        !option.empty())
        return Sentence("--{0}: expected no value", option);
    if (const std::string_view option = aboutIn(said, " excludes ");
        !option.empty() && error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExcludesError))
        return Sentence("{0} and {1} exclude each other", option,
                        said.substr(option.size() + std::string_view(" excludes ").size()));
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::RequiredError)) {
        if (const std::string_view option = aboutIn(said, " is required"); !option.empty())
            return Sentence("{0} is missing; see {1} --help", option, called);
    }
    return said;
}

} // namespace texplorer
