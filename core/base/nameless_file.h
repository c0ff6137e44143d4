#pragma once

#include "core/base/descriptor.h"

#include <string>
#include <sys/stat.h>

namespace texplorer {

/// A new file in a directory that goes away by itself, unless it is given a name; empty where there are none.
[[nodiscard]] Descriptor openNameless(int directory, mode_t mode);

/// Under this name, which must be free, in the same file system. False leaves errno.
[[nodiscard]] bool nameFile(int file, int directory, const std::string& name);

} // namespace texplorer
