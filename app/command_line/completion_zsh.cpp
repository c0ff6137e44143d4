#include "app/command_line/completion_rows.h"
#include "texplorer/base/sentence_format.h"

#include <fmt/core.h>

namespace texplorer {
namespace {

constexpr std::string_view zshAssign = R"zsh(    local typed=${(Q)PREFIX} row name number rest
    local -a numbers names
    rest=${typed%%=*}
    while [[ $rest == *'['*']'* ]]; do # numbers that are typed already
        rest=${rest#*\[}
        number=${rest%%\]*}
        [[ $number == <-> ]] || number=0
        numbers+=($number)
    done
    for row in $rows; do
        name=${row%% *}
        for number in $numbers; do name=${name/'[]'/[$number]}; done
        name=${name//'[]'/[0]}
        if [[ $typed == *=* ]]; then
            [[ "$name" == "${typed%%=*}" && $row == *' '* ]] || continue
            compset -P '*='
            compadd -- ${(s: :)row#* }
            return
        fi
        names+=("$name=")
    done
    compadd -S '' -- $names
}
)zsh";

/// Escaped for the brackets of _arguments.
std::string zshText(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '[' || c == ']' || c == ':' || c == '\\')
            out += '\\';
        out += c;
    }
    return out;
}

std::string zshAction(const std::string& name, const CompletionRow& row) {
    switch (row.offered) {
    case Offered::Nothing:
        return " ";
    case Offered::Files:
        return "_files";
    case Offered::Folders:
        return "_files -/";
    case Offered::Words:
        return fmt::format("({})", zshText(joined(row.words)));
    case Offered::Joined:
        return fmt::format("_sequence compadd - {}", zshText(joined(row.words)));
    case Offered::Assigned:
        return fmt::format("_{}_assign", name);
    }
    return {};
}

std::string zshOption(const std::string& name, const CompletionRow& row) {
    std::string rest = "[" + zshText(row.summary) + "]";
    if (!row.value.empty())
        rest += fmt::format(":{}:{}", zshText(row.value), zshAction(name, row));
    std::string text;
    for (const std::string& option :
         row.names) { // each name excludes all of them, unless it can be given several times
        std::string spec = row.isList ? "*" : row.names.size() > 1 ? "(" + joined(row.names) + ")" : "";
        spec += option;
        if (!row.value.empty())
            spec += option.starts_with("--") ? "=" : "+";
        text += fmt::format(" \\\n        {}", singleQuoted(spec + rest));
    }
    return text;
}

std::string zshArguments(const std::string& name, const CompletionTable& table) {
    std::string text;
    for (const CompletionRow& row : table.options)
        text += zshOption(name, row);
    for (const CompletionRow& row : table.arguments)
        text += fmt::format(" \\\n        {}",
                            singleQuoted(fmt::format("{}:{}:{}", row.isList ? "*" : "", zshText(row.value),
                                                     zshAction(name, row))));
    return text;
}

std::string zshAssigned(const std::string& name, const std::vector<Assigned>& assigned) {
    std::string text = fmt::format("\n_{}_assign() # PATH=VALUE\n{{\n    local -a rows=(\n", name);
    for (const Assigned& each : assigned)
        text +=
            fmt::format("        '{}{}{}'\n", each.path, each.values.empty() ? "" : " ", joined(each.values));
    return text.append("    )\n").append(zshAssign);
}

/// Completes the command after the program's name, then its options.
std::string zshWithCommands(const std::string& name, const std::vector<CompletionTable>& tables) {
    std::string text;
    std::string described;
    for (std::size_t i = 1; i < tables.size(); ++i) {
        const CompletionTable& table = tables[i];
        text += fmt::format("\n_{}_{}()\n{{\n    _arguments -s{}\n}}\n", name, table.command,
                            zshArguments(name, table));
        described += fmt::format("        {}\n", singleQuoted(table.command + ":" + zshText(table.summary)));
    }
    text += fmt::format(
        "\n_{}()\n{{\n    local curcontext=$curcontext state line\n    local -a commands=(\n{}    )\n", name,
        described);
    text += fmt::format("    _arguments -s -C{} \\\n        '1: :->command' \\\n        '*:: :->words'\n",
                        zshArguments(name, tables.front()));
    return text + fmt::format("    case $state in\n"
                              "        command) _describe command commands ;;\n"
                              "        words)\n"
                              "            curcontext=${{curcontext%:*:*}}:{0}-$words[1]:\n"
                              "            (( $+functions[_{0}_$words[1]] )) && _{0}_$words[1]\n"
                              "            ;;\n"
                              "    esac\n"
                              "}}\n",
                              name);
}

} // namespace

std::string zshCompletion(const CommandLine& line) {
    const std::string name = line.name();
    const std::vector<CompletionTable> tables = completionTables(line);
    const std::vector<Assigned> assigned = assignedBy(line);
    std::string text =
        fmt::format("#compdef {0}\n# zsh completion of {0}, made by \"{0} --completion zsh\"\n", name);
    if (!assigned.empty())
        text += zshAssigned(name, assigned);
    if (tables.size() > 1)
        text += zshWithCommands(name, tables);
    else
        text +=
            fmt::format("\n_{}()\n{{\n    _arguments -s{}\n}}\n", name, zshArguments(name, tables.front()));
    return text + fmt::format("\n_{} \"$@\"\n", name);
}

} // namespace texplorer
