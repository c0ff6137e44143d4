#pragma once

#include <string>
#include <string_view>

namespace texplorer::suite {

/// What runs one case of a run again: the run's command (RunRecord::command) without what chose its cases,
/// and with that case alone. Empty where a shell couldn't be given the name: there is no command, or the name
/// isn't printable.
[[nodiscard]] std::string commandOfCase(std::string_view runCommand, std::string_view name);

} // namespace texplorer::suite
