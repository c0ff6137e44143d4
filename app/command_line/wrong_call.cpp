#include "app/command_line/wrong_call.h"

#include "texplorer/text/nearest_name.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer {
namespace {

constexpr std::size_t maxNamed = 3;
constexpr std::size_t minLetters = 2; // shortest beginning of a name that is recognised

/// "a", "a or b", "a, b or c": names that begin with the word, or similar ones.
Sentence oneOf(std::string_view word, const std::vector<std::string_view>& names, std::string_view mark) {
    std::vector<std::string_view> meant;
    if (word.size() >= minLetters)
        std::ranges::copy_if(names, std::back_inserter(meant),
                             [&](std::string_view name) { return name.starts_with(word); });
    if (meant.empty())
        meant = nearestNames(word, names);
    meant.resize(std::min(meant.size(), maxNamed));
    std::vector<Sentence> marked;
    for (const std::string_view name : meant)
        marked.emplace_back(ProperName{fmt::format("{0}{1}{0}", mark, name)});
    const std::size_t last = std::max<std::size_t>(marked.size(), 1) - 1;
    const Sentence first = Sentence::joined("{0}, {1}", std::span(marked).first(last));
    return marked.empty() ? Sentence()
           : last == 0    ? marked.back()
                          : Sentence("{0} or {1}", first, marked.back());
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

Sentence quotedValues(const CLI::App& app, const std::string& option) {
    std::vector<Sentence> values;
    const CLI::Option* found = app.get_option_no_throw(option);
    for (const std::string& value : found != nullptr ? found->results() : std::vector<std::string>())
        values.emplace_back(ProperName{fmt::format("\"{}\"", value)});
    return Sentence::joined("{0} and {1}", values);
}

} // namespace

Sentence meantBy(std::string_view word, const std::vector<std::string_view>& names) {
    return oneOf(word, names, "\"");
}

Sentence optionMeantBy(const CLI::App& app, std::string_view word) {
    const std::string_view asked = word.substr(0, word.find('='));
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
    // CLI11 reports a long name with one dash as short options: "-size".
    const std::string full = asked.starts_with("--") ? std::string(asked) : fmt::format("-{}", asked);
    if (full.size() < 2 + minLetters) // a single letter is similar to everything
        return {};
    return oneOf(full, {names.begin(), names.end()}, "");
}

Error errorFor(const CLI::App& program, const std::string& called, const CLI::ParseError& error) {
    const auto wrong = [](Sentence message, std::string_view option = {}) {
        return Error{ErrorCode::OutOfRange, std::move(message), atOption(std::string(option))};
    };
    const CLI::App& app = calledOf(program);
    const std::string said = error.what();
    const std::vector<std::string> extra = app.remaining(true);
    // Report an unknown option first, even if something else is missing.
    const auto unknown = std::ranges::find_if(
        extra, [](const std::string& word) { return word.size() > 1 && word.starts_with("-"); });
    if (unknown != extra.end() && *unknown != "--") {
        const ProperName name{*unknown};
        const Sentence meant = optionMeantBy(app, *unknown);
        return wrong(meant.empty()
                         ? Sentence("there is no option {0}; see {1} --help", name, ProperName{called})
                         : Sentence("there is no option {0}; did you mean {1}?", name, meant));
    }
    if (const auto* value = dynamic_cast<const WrongValue*>(&error))
        return value->error;
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError) && !extra.empty())
        return wrong(Sentence("expected no further argument, found \"{0}\"; see {1} --help",
                              ProperName{extra.front()}, ProperName{called}));

    // "--size: 1 required TEXT missing"
    if (const std::string_view option = aboutIn(said, ": 1 required ");
        !option.empty() && said.ends_with(" missing"))
        return wrong(N_("expected a value, found none"), option);
    if (const std::string_view option = aboutIn(said, ": At Most 1 required but received "); !option.empty())
        return wrong(Sentence("expected one value, found {0}", quotedValues(app, std::string(option))),
                     option);
    if (const std::string_view option = aboutIn(said, " was given a disallowed flag override");
        !option.empty())
        return wrong(N_("expected no value"), fmt::format("--{}", option));
    if (const std::string_view option = aboutIn(said, " excludes ");
        !option.empty() && error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExcludesError))
        return wrong(Sentence("{0} and {1} exclude each other", ProperName{option},
                              ProperName{std::string_view(said).substr(
                                  option.size() + std::string_view(" excludes ").size())}));
    if (const std::string_view option = aboutIn(said, " requires ");
        !option.empty() && error.get_exit_code() == static_cast<int>(CLI::ExitCodes::RequiresError))
        return wrong(Sentence("{0} requires {1}", ProperName{option},
                              ProperName{std::string_view(said).substr(
                                  option.size() + std::string_view(" requires ").size())}));
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::RequiredError)) {
        if (const std::string_view option = aboutIn(said, " is required"); !option.empty())
            return wrong(Sentence("{0} is missing; see {1} --help", ProperName{option}, ProperName{called}));
    }
    return wrong(said);
}

} // namespace texplorer
