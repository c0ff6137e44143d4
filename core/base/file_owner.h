#pragma once

#include <sys/stat.h>

namespace texplorer {

/// Whose files this program makes; 0 where there are no users.
[[nodiscard]] unsigned thisUser();

/// Gives an open file to the owner and the group that `like` has, where this user may, and its permissions:
/// all of them where the owner is the same, else those without set-user-ID. False leaves errno.
[[nodiscard]] bool takeOwnerAndMode(int file, const struct stat& like);

/// Only the user may read, write and enter it. False leaves errno.
[[nodiscard]] bool makeOwnersAlone(int directory);

} // namespace texplorer
