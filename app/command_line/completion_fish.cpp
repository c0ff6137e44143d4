#include "app/command_line/completion_rows.h"
#include "texplorer/base/sentence_format.h"

#include <fmt/core.h>

namespace texplorer {
namespace {

/// Finds the called command; NAME is replaced by the program's name.
constexpr std::string_view fishCalled = R"fish(
function __NAME_called # COMMAND: whether it is what was called; without one: whether nothing was
    for word in (commandline -opc)[2..]
        string match -q -- '-*' $word; and continue
        test "$word" = "$argv[1]"
        return
    end
    test -z "$argv[1]"
end
)fish";

constexpr std::string_view fishAssign = R"fish(
    set -l typed (string replace -r '^--[a-z-]+=' '' -- (commandline -ct) | string unescape)
    set -l numbers (string match -ra '(?<=\[)[0-9]+(?=\])' -- (string replace -r '=.*' '' -- $typed))
    for row in $rows
        set -l parts (string split ' ' -- $row)
        set -l name $parts[1]
        for number in $numbers
            set name (string replace '[]' "[$number]" -- $name)
        end
        set name (string replace -a '[]' '[0]' -- $name)
        if string match -q -- '*=*' "$typed"
            test "$name" = (string replace -r '=.*' '' -- "$typed"); or continue
            for value in $parts[2..]
                echo $name=$value
            end
        else
            echo $name=
        end
    end
end
)fish";

std::string fishQuoted(std::string_view text) {
    std::string out = "'";
    for (const char c : text) {
        if (c == '\'' || c == '\\')
            out += '\\';
        out += c;
    }
    return out + "'";
}

std::string fishNamed(std::string_view text, const std::string& name) {
    std::string out(text);
    for (std::size_t at = out.find("NAME"); at != std::string::npos; at = out.find("NAME", at + name.size()))
        out.replace(at, 4, name);
    return out;
}

/// The offer for the value of an option, or for an argument.
std::string fishOffer(const std::string& name, const CompletionRow& row) {
    switch (row.offered) {
    case Offered::Nothing:
        return " -x";
    case Offered::Files:
        return " -r -F";
    case Offered::Folders:
        return " -x -a '(__fish_complete_directories)'";
    case Offered::Words:
        return fmt::format(" -x -a {}", fishQuoted(joined(row.words)));
    case Offered::Joined:
        return fmt::format(" -x -a '(__fish_append , {})'", joined(row.words));
    case Offered::Assigned:
        return fmt::format(" -x -a '(__{}_assigned)'", name);
    }
    return {};
}

std::string fishAssigned(const std::string& name, const std::vector<Assigned>& assigned) {
    std::string text = fmt::format("\nfunction __{}_assigned # PATH=VALUE\n    set -l rows", name);
    for (const Assigned& each : assigned)
        text += fmt::format(" \\\n        '{}{}{}'", each.path, each.values.empty() ? "" : " ",
                            joined(each.values));
    return text.append(fishAssign);
}

std::string fishOptions(const std::string& name, const CompletionTable& table, bool hasCommands) {
    const std::string when = hasCommands ? fmt::format(" -n '__{}_called{}'", name,
                                                       table.command.empty() ? "" : " " + table.command)
                                         : "";
    std::string text;
    for (const CompletionRow& row : table.options) {
        text += fmt::format("complete -c {}{}", name, when);
        for (const std::string& option : row.names)
            text += option.starts_with("--") ? " -l " + option.substr(2) : " -s " + option.substr(1);
        if (!row.value.empty())
            text += fishOffer(name, row);
        text += fmt::format(" -d {}\n", fishQuoted(row.summary));
    }
    for (const CompletionRow& row : table.arguments) {
        if (row.offered == Offered::Files || row.offered == Offered::Folders) // the same for all arguments
            text += fmt::format("complete -c {}{} -F\n", name, when);
        else if (row.offered == Offered::Words)
            text += fmt::format("complete -c {}{} -a {}\n", name, when, fishQuoted(joined(row.words)));
    }
    return text;
}

} // namespace

std::string fishCompletion(const CommandLine& line) {
    const std::string name = line.name();
    const std::vector<CompletionTable> tables = completionTables(line);
    const std::vector<Assigned> assigned = assignedBy(line);
    const bool hasCommands = tables.size() > 1;
    std::string text = fmt::format("# fish completion of {0}, made by \"{0} --completion fish\"\n", name);
    if (hasCommands)
        text += fishNamed(fishCalled, name);
    if (!assigned.empty())
        text += fishAssigned(name, assigned);
    text += fmt::format("\ncomplete -c {} -f\n", name);
    for (std::size_t i = 1; i < tables.size(); ++i)
        text += fmt::format("complete -c {0} -n __{0}_called -a {1} -d {2}\n", name, tables[i].command,
                            fishQuoted(tables[i].summary));
    for (const CompletionTable& table : tables)
        text += fishOptions(name, table, hasCommands);
    return text;
}

} // namespace texplorer
