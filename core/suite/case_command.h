#pragma once

#include <string>
#include <string_view>

namespace texplorer::suite {

/// Returns the command that runs one case of a run again: the run's command (RunRecord::command) without its
/// selection of cases, and with this case. Empty if there is no command, or the name is not printable.
[[nodiscard]] std::string commandOfCase(std::string_view runCommand, std::string_view name);

} // namespace texplorer::suite
