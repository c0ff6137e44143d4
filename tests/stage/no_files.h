#pragma once

#include <string>
#include <vector>

namespace texplorer::stage {

/// As long as it lives, the process can open no file or folder: `open`, `fopen` and `opendir` fail as if
/// there were none, and are noted. At most one at a time; other threads must not open files meanwhile.
class NoFiles {
public:
    NoFiles();
    ~NoFiles();
    NoFiles(const NoFiles&) = delete;
    NoFiles& operator=(const NoFiles&) = delete;

    std::vector<std::string> attempts; ///< the names, in order
};

} // namespace texplorer::stage
