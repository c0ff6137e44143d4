#pragma once

// A program's command line: what it takes is declared, then parsed. Its --help and the sentences about wrong
// calls are the same in every program.

#include "app/command_line/help_sections.h"
#include "app/command_line/offers.h"
#include "core/base/result.h"

#include <concepts>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CLI { // CLI11, which command_line.cpp and help_format.cpp alone include: it takes seconds to
                // compile
class App;
class Option;
} // namespace CLI

namespace texplorer {

class Option;

/// What may be said about an option beside its names.
struct OptionRules {
    std::string value = {};       ///< what help calls its value: "FILE"
    std::string environment = {}; ///< the variable that does the same
    bool required = false;
    bool showsDefault = false; ///< help says the value that it has when it is declared
    bool oneEach = false;      ///< of a list: takes one value each time that it is given, not all that follow
    const Option* needs = nullptr;    ///< without which it is refused
    const Option* excludes = nullptr; ///< with which it is refused
    std::function<std::string(const std::string&)> check =
        {};             ///< of a value: what is wrong with it; empty: nothing
    Offers offers = {}; ///< what a shell offers while one types the value
};

/// An option, flag or positional argument. Its command keeps it.
class Option {
public:
    Option(CLI::Option& option, OptionRules rules)
        : option_(&option)
        , rules_(std::move(rules)) {}

    /// "--out" of "-o,--out".
    [[nodiscard]] std::string name() const;

    /// Whether the command line itself has it: what an environment variable says may go unused.
    [[nodiscard]] bool isGiven() const;

    // What was declared, for who writes it down: help, manuals, completion.

    /// "-o" and "--out"; "FILE" of an argument.
    [[nodiscard]] std::vector<std::string> names() const;
    [[nodiscard]] bool isArgument() const; ///< has no dashes: its place tells what it is
    [[nodiscard]] bool isFlag() const;     ///< takes no value
    [[nodiscard]] bool isList() const;     ///< may be given again
    [[nodiscard]] std::string help() const;
    [[nodiscard]] std::string initial() const; ///< the value that help says it has; empty: none
    [[nodiscard]] const OptionRules& rules() const { return rules_; }

private:
    friend class Command;
    CLI::Option* option_;
    OptionRules rules_;
};

/// What a program takes, or one of its commands ("texshot shot"). Values are filled in while the line is
/// parsed; they must live until then, and keep what they have where the line doesn't say otherwise.
class Command {
public:
    Command(const Command&) = delete;
    Command& operator=(const Command&) = delete;
    ~Command() = default;

    [[nodiscard]] std::string name() const;
    [[nodiscard]] std::string help() const;
    [[nodiscard]] std::string version() const; ///< of the program: "texshot 0.1.0"
    [[nodiscard]] std::string group() const;   ///< the title that it stands under in the program's help

    /// `names`: "--size", "-o,--out", or "FILE" for an argument that has no dashes.
    const Option& option(const std::string& names, std::string& value, const std::string& help,
                         const OptionRules& rules = {});

    /// May be given again: each value joins the others. So do several with commas between them, where
    /// offers.joined says so: of names that have none.
    const Option& option(const std::string& names, std::vector<std::string>& values, const std::string& help,
                         const OptionRules& rules = {});

    const Option& flag(const std::string& names, bool& value, const std::string& help,
                       const OptionRules& rules = {});

    /// A whole number from `low` to `high`, which help says.
    template<std::integral T>
    const Option& number(const std::string& names, T& value, long long low, long long high,
                         const std::string& help, const OptionRules& rules = {}) {
        return numberOption(
            names, [&value](long long number) { value = static_cast<T>(number); }, std::to_string(value), low,
            high, help, rules);
    }

    /// The paragraphs below the options in --help, one a line.
    void footer(const std::string& text);
    [[nodiscard]] std::string footer() const;

    /// How it is called, where that isn't its options and arguments in their order: "IN OUT", "IN... -o DIR".
    void usage(std::vector<std::string> lines);
    [[nodiscard]] const std::vector<std::string>& usage() const { return sections_.usage; }

    /// Calls that can be made as they stand, in this order in an empty folder: each a line of a shell.
    void examples(std::vector<std::string> lines);
    [[nodiscard]] const std::vector<std::string>& examples() const { return sections_.examples; }

    /// A table below the options: what is written in a file that the command reads, and what it says there.
    void table(HelpTable table);
    [[nodiscard]] const std::vector<HelpTable>& tables() const { return sections_.tables; }

    /// A command of this one, which from then on needs one of them.
    Command& command(const std::string& name, const std::string& help);
    [[nodiscard]] const std::vector<std::unique_ptr<Command>>& commands() const { return commands_; }

    /// What the command does, and the program's exit status.
    void onCall(std::function<int()> action);

    /// Does that, or what the command below it does that was called. After a parse that gave nothing to
    /// print.
    [[nodiscard]] int run() const;

    /// All that were declared for it so far, without those that every command has.
    [[nodiscard]] const std::deque<Option>& options() const { return options_; }

    /// --help, --version and the flags that every command has.
    [[nodiscard]] const std::deque<Option>& sharedOptions() const { return shared_; }

protected:
    /// A flag of every command.
    struct SharedFlag {
        std::string names;
        bool* value;
        std::string help;
        std::string excludes; ///< another of them; empty: none
    };
    /// What the commands of a program have from it.
    struct Program {
        std::string version; ///< what --version says
        std::vector<SharedFlag> flags{};
        std::string group{}; ///< of the commands that are declared next
    };

    Command(std::shared_ptr<CLI::App> app, std::shared_ptr<Program> program);

    void share(const SharedFlag& flag);

    std::shared_ptr<CLI::App> app_; ///< the program's own owns those of its commands
    std::shared_ptr<Program> program_;
    std::vector<std::unique_ptr<Command>> commands_;

private:
    const Option& keep(CLI::Option& option, const OptionRules& rules);
    const Option& numberOption(const std::string& names, const std::function<void(long long)>& store,
                               const std::string& start, long long low, long long high,
                               const std::string& help, const OptionRules& rules);

    std::deque<Option> options_;
    std::deque<Option> shared_;
    HelpSections sections_;
    std::function<int()> action_;

    void showSections();
};

inline constexpr const char* completionOption = "--completion";
inline constexpr const char* manualOption = "--manual";

/// A program's.
class CommandLine : public Command {
public:
    CommandLine(const std::string& program, const std::string& version, const std::string& help);

    /// A flag that may stand before a command and among its options: declared before the commands are.
    /// `excludes`: such a flag with which it is refused.
    void everywhere(const std::string& names, bool& value, const std::string& help,
                    const std::string& excludes = {});

    /// The title in help of the commands that are declared from here on.
    void group(const std::string& title);

    /// Declares "help COMMAND", which says what "COMMAND --help" does.
    void addHelp();

    /// Declares --completion SHELL, which writes a script for it, and --manual PAGE, which writes a page for
    /// man.
    void addWords();

    /// Fills in the values. Gives what --help, --version or addWords' options ask for, if one of them is
    /// there: nothing else is to be done then. A wrong call is one sentence, without the program's name.
    [[nodiscard]] Result<std::optional<std::string>> parse(int argc, const char* const* argv);

private:
    [[nodiscard]] std::string calledCommand() const;
    [[nodiscard]] std::string missingCommand(int argc, const char* const* argv) const;
    [[nodiscard]] std::string noCommand(const std::string& word) const;
    [[nodiscard]] Result<std::optional<std::string>> helpAskedFor() const;

    [[nodiscard]] std::optional<Result<std::string>> wordsAskedFor(int argc, const char* const* argv) const;

    const Command* helpCommand_ = nullptr;
    std::string explained_;  ///< the command that "help" was asked about
    std::string completion_; ///< the shell
    std::string manual_;     ///< the page
};

} // namespace texplorer
