#pragma once

#include <filesystem>

namespace texplorer {

/// Returns a user folder of the XDG Base Directory Specification: the value of `variable` ("XDG_STATE_HOME"),
/// else `belowHome` (".local/state") in $HOME. Empty if neither is an absolute path.
[[nodiscard]] std::filesystem::path userFolder(const char* variable, const char* belowHome);

} // namespace texplorer
