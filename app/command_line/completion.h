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

/// A script that completes the commands of a program, their options and values. It does not call the program:
/// it contains everything that it offers, except files. Shells look for such scripts by the program's name:
/// bash-completion/completions/NAME, zsh/site-functions/_NAME, fish/vendor_completions.d/NAME.fish below
/// share/.
[[nodiscard]] std::string completionScript(const CommandLine& line, Shell shell);

} // namespace texplorer
