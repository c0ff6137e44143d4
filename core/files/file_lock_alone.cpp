#include "texplorer/files/file_lock.h"

namespace texplorer {

int lockFile(int /*file*/) {
    return 0;
}

} // namespace texplorer
