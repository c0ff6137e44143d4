#include "app/command_line/command_line.h"

#include "app/command_line/help_format.h"
#include "app/command_line/wrong_call.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <sstream>

namespace texplorer {
namespace {

constexpr const char* sharedGroup = HelpFormatter::sharedGroup;

constexpr const char* helpCommandName = "help";

std::shared_ptr<CLI::App> makeApp(const std::string& program, const std::string& help) {
    auto app = std::make_shared<CLI::App>(help, program);
    app->formatter(std::make_shared<HelpFormatter>());
    return app;
}

/// For any value. An empty value comes from an unset shell variable; the name of an option means that its
/// value was forgotten.
Sentence checkValue(const CLI::App& app, const std::string& value) {
    if (value.empty())
        return N_("expected a value, found an empty one");
    if (value.size() > 1 && value.starts_with("-") && app.get_option_no_throw(value) != nullptr)
        return Sentence("expected a value, found the option {0}", ProperName{value});
    return {};
}

} // namespace

std::string Option::name() const {
    return option_->get_name();
}

bool Option::isGiven() const {
    if (option_->count() == 0)
        return false;
    const char* environment =
        option_->get_envname().empty() ? nullptr : std::getenv(option_->get_envname().c_str()); // NOLINT
    return environment == nullptr || option_->results().front() != environment;
}

std::vector<std::string> Option::names() const {
    if (isArgument())
        return {option_->get_name(true, false)};
    std::vector<std::string> names;
    for (const std::string& name : option_->get_snames())
        names.push_back("-" + name);
    for (const std::string& name : option_->get_lnames())
        names.push_back("--" + name);
    return names;
}

bool Option::isArgument() const {
    return option_->get_positional();
}

bool Option::isFlag() const {
    return option_->get_items_expected_max() == 0;
}

bool Option::isList() const {
    return option_->get_expected_max() >= CLI::detail::expected_max_vector_size;
}

std::string Option::help() const {
    return option_->get_description();
}

std::string Option::initial() const {
    return option_->get_default_str();
}

Command::Command(std::shared_ptr<CLI::App> app, std::shared_ptr<Program> program)
    : app_(std::move(app))
    , program_(std::move(program)) {
    shared_.emplace_back(*app_->set_help_flag("-h,--help", "Print this help."), OptionRules{});
    shared_.emplace_back(*app_->set_version_flag("--version", program_->version, "Print the version."),
                         OptionRules{});
    for (const SharedFlag& flag : program_->flags)
        share(flag);
}

void Command::share(const SharedFlag& flag) {
    CLI::Option* option = app_->add_flag(flag.names, *flag.value, flag.help)->disable_flag_override();
    if (!flag.excludes.empty())
        option->excludes(flag.excludes);
    shared_.emplace_back(*option, OptionRules{});
}

std::string Command::name() const {
    return app_->get_name();
}

std::string Command::help() const {
    return app_->get_description();
}

std::string Command::version() const {
    return program_->version;
}

std::string Command::group() const {
    const std::string title = app_->get_group();
    return title == "Subcommands" ? std::string() : title; // the title that CLI11 uses without a name
}

std::string Command::footer() const {
    return app_->get_footer();
}

const Option& Command::keep(CLI::Option& option, const OptionRules& rules) {
    if (!rules.value.empty())
        option.type_name(rules.value);
    if (!rules.environment.empty())
        option.envname(rules.environment);
    if (rules.required)
        option.required();
    if (rules.showsDefault)
        option.capture_default_str();
    if (rules.oneEach)
        option.allow_extra_args(false);
    if (rules.needs != nullptr)
        option.needs(rules.needs->option_);
    if (rules.excludes != nullptr)
        option.excludes(rules.excludes->option_);
    if (option.get_items_expected_max() == 0) // a flag
        option.disable_flag_override();
    else
        option.check([&option, app = app_.get(), check = rules.check](const std::string& value) {
            Sentence wrong = checkValue(*app, value);
            if (wrong.empty() && check)
                wrong = check(value);
            if (!wrong.empty())
                throw WrongValue(option, wrong);
            return std::string();
        });
    return options_.emplace_back(option, rules);
}

const Option& Command::option(const std::string& names, std::string& value, const std::string& help,
                              const OptionRules& rules) {
    return keep(*app_->add_option(names, value, help), rules);
}

const Option& Command::option(const std::string& names, std::vector<std::string>& values,
                              const std::string& help, const OptionRules& rules) {
    CLI::Option* option = app_->add_option(names, values, help);
    if (rules.offers.joined)
        option->delimiter(',');
    return keep(*option, rules);
}

const Option& Command::flag(const std::string& names, bool& value, const std::string& help,
                            const OptionRules& rules) {
    return keep(*app_->add_flag(names, value, help), rules);
}

const Option& Command::numberOption(const std::string& names, const std::function<void(long long)>& store,
                                    const std::string& start, long long low, long long high,
                                    const std::string& help, const OptionRules& rules) {
    const auto parse = [store, low, high, app = app_.get(), names](const std::string& text) {
        long long number = 0;
        const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error != std::errc() || stop != text.data() + text.size() || number < low || number > high)
            throw WrongValue(*app->get_option(names.substr(0, names.find(','))),
                             Sentence("expected a whole number from {0} to {1}, found \"{2}\"", low, high,
                                      ProperName{text}));
        store(number);
    };
    CLI::Option* option = app_->add_option_function<std::string>(
                                  names, parse, fmt::format("{} From {} to {}.", help, low, high))
                              ->type_name("NUMBER");
    keep(*option, rules);
    if (rules.showsDefault)
        option->default_str(start);
    return options_.back();
}

void Command::footer(const std::string& text) {
    app_->footer(text);
}

void Command::usage(std::vector<std::string> lines) {
    sections_.usage = std::move(lines);
    showSections();
}

void Command::examples(std::vector<std::string> lines) {
    sections_.examples = std::move(lines);
    showSections();
}

void Command::table(HelpTable table) {
    sections_.tables.push_back(std::move(table));
    showSections();
}

void Command::showSections() {
    app_->formatter(std::make_shared<HelpFormatter>(sections_));
}

Command& Command::command(const std::string& name, const std::string& help) {
    app_->require_subcommand(1);
    for (const Option& each : shared_) // listed separately, as in each command
        each.option_->group(sharedGroup);
    std::shared_ptr<CLI::App> app(app_, app_->add_subcommand(name, help));
    app->formatter(std::make_shared<HelpFormatter>());
    if (!program_->group.empty())
        app->group(program_->group);
    Command& command = *commands_.emplace_back(new Command(std::move(app), program_));
    for (const Option& each : command.shared_)
        each.option_->group(sharedGroup);
    return command;
}

void Command::onCall(std::function<int()> action) {
    action_ = std::move(action);
}

int Command::run() const {
    for (const auto& command : commands_) {
        if (command->app_->parsed())
            return command->run();
    }
    return action_();
}

CommandLine::CommandLine(const std::string& program, const std::string& version, const std::string& help)
    : Command(makeApp(program, help), std::make_shared<Program>(Program{program + " " + version})) {}

void CommandLine::everywhere(const std::string& names, bool& value, const std::string& help,
                             const std::string& excludes) {
    program_->flags.push_back({names, &value, help, excludes});
    share(program_->flags.back());
}

void CommandLine::group(const std::string& title) {
    program_->group = title;
}

void CommandLine::addHelp() {
    Command& command = this->command(helpCommandName, "Help for a command.");
    command.option("COMMAND", explained_, "The command. Default: a list of all commands.",
                   {.offers = {.words = [this] {
                        std::vector<std::string> names;
                        for (const auto& each : commands())
                            names.push_back(each->name());
                        return names;
                    }}});
    helpCommand_ = &command;
}

/// The called command as the user writes it: "texshot shot".
std::string CommandLine::calledCommand() const {
    std::string name = app_->get_name();
    for (const CLI::App* command : app_->get_subcommands())
        name += " " + command->get_name();
    return name;
}

Sentence CommandLine::noCommand(const std::string& word) const {
    std::string all;
    std::vector<std::string> names;
    for (const auto& command : commands_) {
        names.push_back(command->name());
        all.append(all.empty() ? "" : ", ").append(names.back());
    }
    const Sentence meant = meantBy(word, {names.begin(), names.end()});
    return meant.empty()
               ? Sentence("there is no command \"{0}\"; expected one of {1}", ProperName{word},
                          ProperName{all})
               : Sentence("there is no command \"{0}\"; did you mean {1}?", ProperName{word}, meant);
}

/// The error for a missing subcommand, with more than CLI11 says. Empty if none is missing.
Sentence CommandLine::missingCommand(int argc, const char* const* argv) const {
    if (commands_.empty())
        return {};
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (const CLI::Option* flag = app_->get_option_no_throw(word)) {
            if (flag == app_->get_help_ptr() || flag == app_->get_version_ptr())
                return {};
            continue; // it may stand before the command
        }
        if (std::ranges::any_of(commands_, [&](const auto& command) { return command->name() == word; }))
            return {};
        if (!word.starts_with("-"))
            return noCommand(word);
        const Sentence meant = optionMeantBy(*app_, word);
        return meant.empty() ? Sentence("expected a command, found \"{0}\"; see {1} --help", ProperName{word},
                                        ProperName{app_->get_name()})
                             : Sentence("expected a command, found \"{0}\"; did you mean {1}?",
                                        ProperName{word}, meant);
    }
    return Sentence("a command is missing; see {0} --help", ProperName{app_->get_name()});
}

Result<std::optional<std::string>> CommandLine::helpAskedFor() const {
    if (explained_.empty())
        return app_->get_formatter()->make_help(app_.get(), app_->get_name(), CLI::AppFormatMode::Normal);
    for (const auto& command : commands_)
        if (command->name() == explained_)
            return app_->get_subcommand(explained_)->help(app_->get_name());
    return fail(ErrorCode::OutOfRange, noCommand(explained_));
}

Result<std::optional<std::string>> CommandLine::parse(int argc, const char* const* argv) {
    if (auto words = wordsAskedFor(argc, argv))
        return *std::move(words);
    if (const Sentence missing = missingCommand(argc, argv); !missing.empty())
        return fail(ErrorCode::OutOfRange, missing);
    try {
        app_->parse(argc, argv);
        if (!completion_.empty() || !manual_.empty())
            return fail(ErrorCode::OutOfRange, "expected no other argument with it",
                        atOption(completion_.empty() ? manualOption : completionOption));
        if (helpCommand_ != nullptr && app_->got_subcommand(helpCommandName))
            return helpAskedFor();
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != 0)
            return fail(errorFor(*app_, calledCommand(), error));
        std::ostringstream text; // --help, --version
        app_->exit(error, text);
        return text.str();
    }
}

} // namespace texplorer
