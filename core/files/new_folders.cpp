#include "texplorer/files/new_folders.h"

#include <cerrno>
#include <sys/stat.h>
#include <unistd.h>

namespace texplorer {

namespace fs = std::filesystem;

bool NewFolders::make(const fs::path& folder) {
    std::error_code error;
    if (folder.has_parent_path() && !fs::exists(folder, error) && folder != folder.parent_path() &&
        !make(folder.parent_path()))
        return false;
    if (::mkdir(folder.c_str(), 0777) == 0)
        made_.push_back(folder);
    else if (errno != EEXIST)
        return false;
    return true;
}

NewFolders::~NewFolders() {
    for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder)
        ::rmdir(folder->c_str()); // which refuses what isn't empty
}

} // namespace texplorer
