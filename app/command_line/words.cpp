// --completion and --manual: written from the same tables as --help.

#include "app/command_line/choice_argument.h"
#include "app/command_line/completion.h"
#include "app/command_line/manual.h"

#include <fmt/format.h>

#include <algorithm>

namespace texplorer {
namespace {

Result<std::string> completionFor(const CommandLine& line, const std::string& name) {
    const auto* const row = std::ranges::find(shellRows, name, &ShellRow::name);
    if (row == shellRows.end())
        return refuseChoice(namesIn(shellRows), name, completionOption);
    return completionScript(line, row->shell);
}

} // namespace

void CommandLine::addWords() {
    option(completionOption, completion_,
           fmt::format("Print a completion script for a shell, one of {}, and end.",
                       fmt::format("{}", fmt::join(namesIn(shellRows), ", "))),
           {.value = "SHELL", .offers = {.words = [] { return namesIn(shellRows); }}});
    option(manualOption, manual_,
           fmt::format("Print a manual page for \"man -l\", and end: {}; \"{}\" prints the names.",
                       commands().empty() ? name() : fmt::format("{0}, or {0}-COMMAND", name()), manualList),
           {.value = "PAGE", .offers = {.words = [this] { return manualPages(*this); }}});
}

/// They are allowed only alone, instead of a command.
std::optional<Result<std::string>> CommandLine::wordsAskedFor(int argc, const char* const* argv) const {
    if (argc < 2)
        return std::nullopt;
    const std::string first = argv[1];
    const std::string asked = first.substr(0, first.find('='));
    const bool declared =
        std::ranges::any_of(options(), [&](const Option& each) { return each.name() == asked; });
    if (!declared || (asked != completionOption && asked != manualOption))
        return std::nullopt;
    const bool hasValue = asked.size() < first.size();
    const int wanted = hasValue ? 2 : 3;
    if (argc < wanted)
        return fail(ErrorCode::OutOfRange, "expected a value, found none", atOption(asked));
    if (argc > wanted)
        return fail(ErrorCode::OutOfRange,
                    Sentence("expected no further argument, found \"{0}\"", argv[wanted]), atOption(asked));
    const std::string value = hasValue ? first.substr(asked.size() + 1) : argv[2];
    return asked == completionOption ? completionFor(*this, value) : manualPage(*this, value);
}

} // namespace texplorer
