#pragma once

#include <string>

namespace texplorer::workers {

/// "SIGSEGV, segmentation fault"
[[nodiscard]] std::string signalText(int signal);

} // namespace texplorer::workers
