#include "texplorer/files/nameless_file.h"

#include <cerrno>

namespace texplorer {

Descriptor openNameless(int /*directory*/, mode_t /*mode*/) {
    return {};
}

bool nameFile(int /*file*/, int /*directory*/, const std::string& /*name*/) {
    errno = ENOTSUP;
    return false;
}

} // namespace texplorer
