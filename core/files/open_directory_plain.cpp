#include "texplorer/files/open_directory.h"

#include <fcntl.h>

namespace texplorer {

Descriptor openDirectory(const std::filesystem::path& path) {
    return Descriptor(::open(path.empty() ? "." : path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
}

} // namespace texplorer
