#include "app/command_line/completion.h"

#include "app/command_line/completion_rows.h"

#include <algorithm>

namespace texplorer {
namespace {

/// The first sentence of a help text: "Draw a scene into a picture."
std::string summaryOf(std::string_view help) {
    std::string text(help.substr(0, help.find(". ")));
    std::ranges::replace(text, '\n', ' ');
    while (text.ends_with('.'))
        text.pop_back();
    return text;
}

/// Chosen by the name of the value in help.
Offered offeredFor(const std::string& value, bool isArgument) {
    if (value == "DIR")
        return Offered::Folders;
    return isArgument || value == "FILE" || value == "LIST" || value == "FROM" ? Offered::Files
                                                                               : Offered::Nothing;
}

CompletionRow rowFor(const Option& option) {
    const OptionRules& rules = option.rules();
    CompletionRow row{.names = option.names(), .value = rules.value, .summary = summaryOf(option.help())};
    row.isList = option.isList();
    row.takesMany = row.isList && !rules.oneEach;
    if (option.isFlag())
        return row;
    if (row.value.empty())
        row.value = option.isArgument() ? row.names.front() : "NUMBER";
    row.offered = offeredFor(row.value, option.isArgument());
    if (rules.offers.words) {
        row.words = rules.offers.words();
        row.offered = rules.offers.joined ? Offered::Joined : Offered::Words;
    }
    if (rules.offers.assigned)
        row.offered = Offered::Assigned;
    return row;
}

CompletionTable tableOf(const Command& command, const std::string& name) {
    CompletionTable table{name, summaryOf(command.help()), {}, {}};
    for (const auto* options : {&command.options(), &command.sharedOptions()})
        for (const Option& option : *options)
            (option.isArgument() ? table.arguments : table.options).push_back(rowFor(option));
    return table;
}

} // namespace

std::vector<CompletionTable> completionTables(const CommandLine& line) {
    std::vector<CompletionTable> tables{tableOf(line, {})};
    for (const auto& command : line.commands())
        tables.push_back(tableOf(*command, command->name()));
    return tables;
}

std::vector<Assigned> assignedBy(const CommandLine& line) {
    for (const auto& command : line.commands())
        for (const Option& option : command->options())
            if (option.rules().offers.assigned)
                return option.rules().offers.assigned();
    return {};
}

std::string joined(const std::vector<std::string>& words, std::string_view separator) {
    std::string text;
    for (const std::string& word : words)
        text.append(text.empty() ? "" : separator).append(word);
    return text;
}

std::string singleQuoted(std::string_view text) {
    std::string out = "'";
    for (const char c : text)
        out += c == '\'' ? "'\\''" : std::string(1, c);
    return out + "'";
}

std::string completionScript(const CommandLine& line, Shell shell) {
    switch (shell) {
    case Shell::Bash:
        return bashCompletion(line);
    case Shell::Zsh:
        return zshCompletion(line);
    case Shell::Fish:
        return fishCompletion(line);
    }
    return {};
}

} // namespace texplorer
