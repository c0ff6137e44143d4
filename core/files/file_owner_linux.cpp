#include "texplorer/files/file_owner.h"

#include <unistd.h>

namespace texplorer {

unsigned thisUser() {
    return ::geteuid();
}

bool takeOwnerAndMode(int file, const struct stat& like) {
    // Only root may give files away; what can't be given away must not keep a set-user-ID bit.
    const bool sameOwner = ::fchown(file, like.st_uid, like.st_gid) == 0;
    return ::fchmod(file, like.st_mode & (sameOwner ? 07777 : 0777)) == 0;
}

bool makeOwnersAlone(int directory) {
    return ::fchmod(directory, 0700) == 0;
}

} // namespace texplorer
