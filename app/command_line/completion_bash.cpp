#include "app/command_line/completion_rows.h"
#include "texplorer/base/sentence_format.h"

#include <fmt/core.h>

namespace texplorer {
namespace {

/// The part that is the same for every program; NAME is replaced by the program's name.
constexpr std::string_view bashAssign = R"bash(
_NAME_assign() # what was typed of PATH=VALUE: the paths that begin so, and after = the values that have names
{
    local typed=$1 rest=${1%%=*} row path number value
    local -a rows numbers=()
    mapfile -t rows < <(_NAME_assigned)
    while [[ $rest == *\[*\]* ]]; do # numbers that are typed already
        rest=${rest#*\[}
        number=${rest%%\]*}
        [[ $number =~ ^[0-9]+$ ]] || number=0
        numbers+=("$number")
    done
    for row in "${rows[@]}"; do
        path=${row%% *}
        for number in "${numbers[@]}"; do path=${path/\[\]/[$number]}; done
        path=${path//\[\]/[0]}
        if [[ $typed == *=* ]]; then
            [[ $path == "${typed%%=*}" && $row == *" "* ]] || continue
            for value in ${row#* }; do
                [[ $value == "${typed#*=}"* ]] && COMPREPLY+=("$path=$value")
            done
        elif [[ $path == "$typed"* ]]; then
            COMPREPLY+=("$path=")
        fi
    done
    [[ ${COMPREPLY[0]} == *= ]] && compopt -o nospace 2>/dev/null
    return 0
}
)bash";

constexpr std::string_view bashMain = R"bash(
_NAME()
{
    local IFS=$' \t\n' commands=COMMANDS
    local offer='' words='' word='' glued='' command='' takes='' many='' prefix='' last cut cur i place=0
    local -a line=()
    COMPREPLY=()
    for ((i = 0; i <= COMP_CWORD; ++i)); do # what COMP_WORDBREAKS has cut is put together again
        word=${COMP_WORDS[i]}
        if [[ $i -gt 1 && ( -n $glued || $word =~ ^[=:]+$ ) ]]; then
            line[${#line[@]} - 1]+=$word
        else
            line+=("$word")
        fi
        glued=''
        [[ $i -gt 0 && $word =~ ^[=:]+$ ]] && glued=yes
    done
    cur=${line[${#line[@]} - 1]}
    last=${COMP_WORDS[COMP_CWORD]}
    [[ $last =~ ^[=:]+$ ]] && last=''
    cut=${cur%"$last"} # stands in the line already

    for ((i = 1; i < ${#line[@]} - 1; ++i)); do
        word=${line[i]}
        if [[ -n $takes && ( -z $many || $word != -* ) ]]; then
            [[ -n $many ]] || takes=''
        elif [[ $word == -?* ]]; then
            takes=''
            many=''
            [[ $word != *=* ]] && _NAME_value "$command" "$word" && takes=$word
        elif [[ -n $commands && -z $command ]]; then
            command=$word
        else
            ((++place))
        fi
    done

    if [[ -n $takes && ( -z $many || $cur != -* ) ]]; then
        _NAME_value "$command" "$takes"
    elif [[ $cur == --*=* ]]; then
        _NAME_value "$command" "${cur%%=*}" || return 0
        prefix=${cur%%=*}=
        cur=${cur#*=}
    elif [[ $cur == -* ]]; then
        offer=words
        words=$(_NAME_options "$command")
    elif [[ -n $commands && -z $command ]]; then
        offer=words
        words=$commands
    else
        _NAME_argument "$command" "$((place + 1))"
    fi

    case $offer in
        files)
            compopt -o filenames 2>/dev/null
            mapfile -t COMPREPLY < <(compgen -f -- "$cur")
            ;;
        folders)
            compopt -o filenames 2>/dev/null
            mapfile -t COMPREPLY < <(compgen -d -- "$cur")
            ;;
        words) mapfile -t COMPREPLY < <(compgen -W "$words" -- "$cur") ;;
        joined)
            compopt -o nospace 2>/dev/null
            mapfile -t COMPREPLY < <(compgen -P "${cur%"${cur##*,}"}" -W "$words" -- "${cur##*,}")
            ;;
        assigned) _NAME_assign "$cur" ;;
    esac
    for i in "${!COMPREPLY[@]}"; do
        word=$prefix${COMPREPLY[i]}
        COMPREPLY[i]=${word#"$cut"}
    done
    return 0
}
complete -F _NAME NAME
)bash";

std::string bashOffer(const CompletionRow& row) {
    switch (row.offered) {
    case Offered::Nothing:
        return "";
    case Offered::Files:
        return " offer=files";
    case Offered::Folders:
        return " offer=folders";
    case Offered::Words:
        return fmt::format(" offer=words words={}", singleQuoted(joined(row.words)));
    case Offered::Joined:
        return fmt::format(" offer=joined words={}", singleQuoted(joined(row.words)));
    case Offered::Assigned:
        return " offer=assigned";
    }
    return {};
}

std::string bashValues(const std::string& name, const std::vector<CompletionTable>& tables) {
    std::string text = fmt::format(
        "\n_{}_value() # COMMAND OPTION: what to offer after it; fails where it takes no value\n{{\n", name);
    text += "    offer=none words='' many=''\n    case \"$1 $2\" in\n";
    for (const CompletionTable& table : tables) {
        for (const CompletionRow& row : table.options) {
            if (row.value.empty())
                continue;
            std::string patterns;
            for (const std::string& option : row.names)
                patterns += fmt::format("{}{}", patterns.empty() ? "" : " | ",
                                        singleQuoted(table.command + " " + option));
            text += fmt::format("        {}){}{} ;;\n", patterns, bashOffer(row),
                                row.takesMany ? " many=yes" : "");
        }
    }
    return text + "        *) return 1 ;;\n    esac\n}\n";
}

std::string bashArguments(const std::string& name, const std::vector<CompletionTable>& tables) {
    std::string text = fmt::format(
        "\n_{}_argument() # COMMAND PLACE: what to offer there\n{{\n    case \"$1 $2\" in\n", name);
    for (const CompletionTable& table : tables) {
        for (std::size_t i = 0; i < table.arguments.size(); ++i) {
            const CompletionRow& row = table.arguments[i];
            const std::string pattern = row.isList ? singleQuoted(table.command + " ") + "*"
                                                   : singleQuoted(fmt::format("{} {}", table.command, i + 1));
            if (row.offered != Offered::Nothing)
                text += fmt::format("        {}){} ;;\n", pattern, bashOffer(row));
        }
    }
    return text + "        *) offer=none ;;\n    esac\n}\n";
}

std::string bashOptions(const std::string& name, const std::vector<CompletionTable>& tables) {
    std::string text = fmt::format("\n_{}_options() # COMMAND: their names\n{{\n    case $1 in\n", name);
    for (const CompletionTable& table : tables) {
        std::string names;
        for (const CompletionRow& row : table.options)
            names += (names.empty() ? "" : " ") + joined(row.names);
        text += fmt::format("        {}) echo {} ;;\n", singleQuoted(table.command), singleQuoted(names));
    }
    return text + "    esac\n}\n";
}

std::string bashAssigned(const std::string& name, const std::vector<Assigned>& assigned) {
    std::string text = fmt::format(
        "\n_{}_assigned() # each path, and the values that have names\n{{\n    cat <<'END'\n", name);
    for (const Assigned& each : assigned)
        text += fmt::format("{}{}{}\n", each.path, each.values.empty() ? "" : " ", joined(each.values));
    return text + "END\n}\n";
}

std::string withNames(std::string_view text, const std::string& name, const std::string& commands) {
    std::string out(text);
    const auto replace = [&out](std::string_view from, const std::string& to) {
        for (std::size_t at = out.find(from); at != std::string::npos; at = out.find(from, at + to.size()))
            out.replace(at, from.size(), to);
    };
    replace("COMMANDS", singleQuoted(commands));
    replace("NAME", name);
    return out;
}

} // namespace

std::string bashCompletion(const CommandLine& line) {
    const std::string name = line.name();
    const std::vector<CompletionTable> tables = completionTables(line);
    const std::vector<Assigned> assigned = assignedBy(line);
    std::vector<std::string> commands;
    for (const auto& command : line.commands())
        commands.push_back(command->name());
    std::string text = fmt::format("# bash completion of {0}, made by \"{0} --completion bash\"\n", name);
    text += bashValues(name, tables) + bashArguments(name, tables) + bashOptions(name, tables);
    if (!assigned.empty())
        text += bashAssigned(name, assigned) + withNames(bashAssign, name, {});
    return text + withNames(bashMain, name, joined(commands));
}

} // namespace texplorer
