#pragma once

#include "texplorer/files/descriptor.h"

#include <string>
#include <sys/stat.h>

namespace texplorer {

/// Creates a nameless file in a directory. The system removes it unless it is named. Empty where nameless
/// files are not supported.
[[nodiscard]] Descriptor openNameless(int directory, mode_t mode);

/// Names the file. The name must be free and in the same file system. Returns false and leaves errno on
/// failure.
[[nodiscard]] bool nameFile(int file, int directory, const std::string& name);

} // namespace texplorer
