#pragma once

// The command line of a program. Options and commands are declared, then parsed. --help and the error
// messages look the same in every program.

#include "app/command_line/help_sections.h"
#include "app/command_line/offers.h"
#include "texplorer/base/result.h"

#include <concepts>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CLI { // CLI11: only command_line.cpp and help_format.cpp include it, because it takes seconds to
                // compile
class App;
class Option;
} // namespace CLI

namespace texplorer {

class Option;

/// Further settings of an option, in addition to its names.
struct OptionRules {
    std::string value = {};       ///< the name of the value in help: "FILE"
    std::string environment = {}; ///< an environment variable with the same effect
    bool required = false;
    bool showsDefault = false; ///< help shows the value that it has when it is declared
    bool oneEach =
        false; ///< of a list: takes one value each time it is given, not all the values that follow
    const Option* needs = nullptr;    ///< required together with it
    const Option* excludes = nullptr; ///< not allowed together with it
    std::function<Sentence(const std::string&)> check =
        {};             ///< checks a value: returns what is wrong with it, or an empty text
    Offers offers = {}; ///< what a shell offers to complete the value
};

/// An option, flag or positional argument. Owned by its command.
class Option {
public:
    Option(CLI::Option& option, OptionRules rules)
        : option_(&option)
        , rules_(std::move(rules)) {}

    /// The long name: "--out" of "-o,--out".
    [[nodiscard]] std::string name() const;

    /// Whether the command line itself has it; a value from the environment does not count.
    [[nodiscard]] bool isGiven() const;

    // The declaration, for help, manuals and completion.

    /// "-o" and "--out"; "FILE" of an argument.
    [[nodiscard]] std::vector<std::string> names() const;
    [[nodiscard]] bool isArgument() const; ///< has no dashes: its position tells what it is
    [[nodiscard]] bool isFlag() const;     ///< takes no value
    [[nodiscard]] bool isList() const;     ///< can be given several times
    [[nodiscard]] std::string help() const;
    [[nodiscard]] std::string initial() const; ///< the initial value that help shows; empty: none
    [[nodiscard]] const OptionRules& rules() const { return rules_; }

private:
    friend class Command;
    CLI::Option* option_;
    OptionRules rules_;
};

/// The options and arguments of a program or of one of its commands ("texshot shot"). Parsing fills in the
/// values: they must live until then, and stay unchanged if the command line does not set them.
class Command {
public:
    Command(const Command&) = delete;
    Command& operator=(const Command&) = delete;
    ~Command() = default;

    [[nodiscard]] std::string name() const;
    [[nodiscard]] std::string help() const;
    [[nodiscard]] std::string version() const; ///< the version of the program: "texshot 0.1.0"
    [[nodiscard]] std::string group() const;   ///< the title of its group in the program's help

    /// `names`: "--size", "-o,--out", or "FILE" for an argument that has no dashes.
    const Option& option(const std::string& names, std::string& value, const std::string& help,
                         const OptionRules& rules = {});

    /// Can be given several times: each value is appended. With offers.joined, one word may hold several
    /// values separated by commas, for values whose names contain no comma.
    const Option& option(const std::string& names, std::vector<std::string>& values, const std::string& help,
                         const OptionRules& rules = {});

    const Option& flag(const std::string& names, bool& value, const std::string& help,
                       const OptionRules& rules = {});

    /// An integer from `low` to `high`; help shows the range.
    template<std::integral T>
    const Option& number(const std::string& names, T& value, long long low, long long high,
                         const std::string& help, const OptionRules& rules = {}) {
        return numberOption(
            names, [&value](long long number) { value = static_cast<T>(number); }, std::to_string(value), low,
            high, help, rules);
    }

    /// The paragraphs below the options in --help, one per line.
    void footer(const std::string& text);
    [[nodiscard]] std::string footer() const;

    /// The usage lines, if they are not the options and arguments in their order: "IN OUT", "IN... -o DIR".
    void usage(std::vector<std::string> lines);
    [[nodiscard]] const std::vector<std::string>& usage() const { return sections_.usage; }

    /// Calls that work unchanged, in this order, in an empty folder: one line of a shell each.
    void examples(std::vector<std::string> lines);
    [[nodiscard]] const std::vector<std::string>& examples() const { return sections_.examples; }

    /// A table below the options: describes the contents of a file that the command reads.
    void table(HelpTable table);
    [[nodiscard]] const std::vector<HelpTable>& tables() const { return sections_.tables; }

    /// Adds a subcommand. From then on one of the subcommands is required.
    Command& command(const std::string& name, const std::string& help);
    [[nodiscard]] const std::vector<std::unique_ptr<Command>>& commands() const { return commands_; }

    /// The action of the command; returns the program's exit status.
    void onCall(std::function<int()> action);

    /// Runs the action of the command that was called. Call it after a parse that returned nothing to print.
    [[nodiscard]] int run() const;

    /// All options declared so far, without those that every command has.
    [[nodiscard]] const std::deque<Option>& options() const { return options_; }

    /// --help, --version and the flags that every command has.
    [[nodiscard]] const std::deque<Option>& sharedOptions() const { return shared_; }

protected:
    /// A flag of every command.
    struct SharedFlag {
        std::string names;
        bool* value;
        std::string help;
        std::string excludes; ///< another shared flag that it excludes; empty: none
    };
    /// What all commands share.
    struct Program {
        std::string version; ///< printed by --version
        std::vector<SharedFlag> flags{};
        std::string group{}; ///< the group of the commands that are declared next
    };

    Command(std::shared_ptr<CLI::App> app, std::shared_ptr<Program> program);

    void share(const SharedFlag& flag);

    std::shared_ptr<CLI::App> app_; ///< the program's own object owns those of its commands
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

/// The command line of a program.
class CommandLine : public Command {
public:
    CommandLine(const std::string& program, const std::string& version, const std::string& help);

    /// A flag that is allowed before a command and among its options. Must be declared before the commands.
    /// `excludes`: another such flag that is not allowed together with it.
    void everywhere(const std::string& names, bool& value, const std::string& help,
                    const std::string& excludes = {});

    /// The title in help of the commands that are declared next.
    void group(const std::string& title);

    /// Declares "help COMMAND", which says what "COMMAND --help" does.
    void addHelp();

    /// Declares --completion SHELL, which prints a completion script, and --manual PAGE, which prints a
    /// manual page.
    void addWords();

    /// Parses the command line and sets the values. Returns the text to print if --help, --version or an
    /// option of addWords was given; the program then does nothing else. The error for a wrong call is one
    /// sentence, without the program's name.
    [[nodiscard]] Result<std::optional<std::string>> parse(int argc, const char* const* argv);

private:
    [[nodiscard]] std::string calledCommand() const;
    [[nodiscard]] Sentence missingCommand(int argc, const char* const* argv) const;
    [[nodiscard]] Sentence noCommand(const std::string& word) const;
    [[nodiscard]] Result<std::optional<std::string>> helpAskedFor() const;

    [[nodiscard]] std::optional<Result<std::string>> wordsAskedFor(int argc, const char* const* argv) const;

    const Command* helpCommand_ = nullptr;
    std::string explained_;  ///< the command named after "help"
    std::string completion_; ///< the shell
    std::string manual_;     ///< the page
};

} // namespace texplorer
