#include "texplorer/files/file_lock.h"

#include <cerrno>

namespace texplorer {

int lockFile(int /*file*/) {
    return ENOTSUP;
}

} // namespace texplorer
