#include "texplorer/files/file_owner.h"

namespace texplorer {

unsigned thisUser() {
    return 0;
}

bool takeOwnerAndMode(int /*file*/, const struct stat& /*like*/) {
    return true;
}

bool makeOwnersAlone(int /*directory*/) {
    return true;
}

} // namespace texplorer
