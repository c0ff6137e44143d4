#pragma once

#include "app/command_line/help_sections.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace texplorer {

/// The format of --help: values by their names, text wrapped at 80 columns, requirements and exclusions at
/// the end.
class HelpFormatter : public CLI::Formatter {
public:
    /// The title of the options that every command has; they come last.
    static constexpr const char* sharedGroup = "Common options";

    explicit HelpFormatter(HelpSections sections = {});

    std::string make_usage(const CLI::App* command, std::string name) const override;
    std::string make_help(const CLI::App* command, std::string name, CLI::AppFormatMode mode) const override;
    std::string make_option(const CLI::Option* option, bool positional) const override;
    std::string make_subcommand(const CLI::App* command) const override;
    std::string make_description(const CLI::App* command) const override;
    std::string make_footer(const CLI::App* command) const override; ///< one paragraph per line

private:
    HelpSections sections_;
};

} // namespace texplorer
