#include "texplorer/files/file_lock.h"

#include <cerrno>
#include <sys/file.h>

namespace texplorer {

int lockFile(int file) {
    return ::flock(file, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
}

} // namespace texplorer
