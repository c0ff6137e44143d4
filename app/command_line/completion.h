#pragma once

#include "app/command_line/command_line.h"

#include <array>
#include <string>
#include <string_view>

namespace texplorer {

enum class Shell { Bash, Zsh, Fish };

struct ShellRow {
    Shell shell;
    std::string_view name;
};
inline constexpr std::array shellRows{ShellRow{Shell::Bash, "bash"}, ShellRow{Shell::Zsh, "zsh"},
                                      ShellRow{Shell::Fish, "fish"}};

/// A script that completes the words of a program's command line, its commands' options and their values. It
/// asks no program: all that it offers but files is in it. Where a shell looks for such scripts, it is named
/// after the program: bash-completion/completions/NAME, zsh/site-functions/_NAME,
/// fish/vendor_completions.d/NAME.fish below share/.
[[nodiscard]] std::string completionScript(const CommandLine& line, Shell shell);

} // namespace texplorer
