#pragma once

#include "app/command_line/help_sections.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace texplorer {

/// --help as we want it: values by their names, sentences in lines of 80 columns, and what is needed or taken
/// otherwise at their end.
class HelpFormatter : public CLI::Formatter {
public:
    /// The title of what every command has, which stands behind its own.
    static constexpr const char* sharedGroup = "Of every command";

    explicit HelpFormatter(HelpSections sections = {});

    std::string make_usage(const CLI::App* command, std::string name) const override;
    std::string make_help(const CLI::App* command, std::string name, CLI::AppFormatMode mode) const override;
    std::string make_option(const CLI::Option* option, bool positional) const override;
    std::string make_subcommand(const CLI::App* command) const override;
    std::string make_description(const CLI::App* command) const override;
    std::string make_footer(const CLI::App* command) const override; ///< a paragraph for each of its lines

private:
    HelpSections sections_;
};

} // namespace texplorer
