#pragma once

#include <sys/stat.h>

namespace texplorer {

/// Returns the user id of new files; 0 where the system has no users.
[[nodiscard]] unsigned thisUser();

/// Gives an open file the owner and group of `like`, as far as this user may, and its permissions: all of
/// them if the owner is the same, else without set-user-ID. Returns false and leaves errno on failure.
[[nodiscard]] bool takeOwnerAndMode(int file, const struct stat& like);

/// Restricts reading, writing and entering to the owner. Returns false and leaves errno on failure.
[[nodiscard]] bool makeOwnersAlone(int directory);

} // namespace texplorer
