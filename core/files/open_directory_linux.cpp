#include "texplorer/files/open_directory.h"

#include <fcntl.h>

namespace texplorer {

Descriptor openDirectory(const std::filesystem::path& path) {
    // O_PATH: it need not be readable.
    return Descriptor(::open(path.empty() ? "." : path.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
}

} // namespace texplorer
