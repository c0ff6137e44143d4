#pragma once

#include <filesystem>

namespace texplorer {

/// A folder of the user's as the XDG Base Directory Specification names it: what `variable` holds
/// ("XDG_STATE_HOME"), else `belowHome` (".local/state") in $HOME. Empty where neither is an absolute path.
[[nodiscard]] std::filesystem::path userFolder(const char* variable, const char* belowHome);

} // namespace texplorer
