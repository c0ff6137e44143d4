#include "texplorer/files/private_directory.h"

#include "texplorer/files/file_kind.h"
#include "texplorer/files/file_owner.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>

namespace texplorer {

namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> refuse(const Sentence& message, const fs::path& path) {
    return fail(ErrorCode::Unwritable, message, inFile(path.string()));
}

/// As the XDG Base Directory Specification wants it: what is made above is private, too.
bool makeWithParents(const fs::path& path) {
    if (::mkdir(path.c_str(), 0700) == 0 || errno == EEXIST)
        return true;
    return errno == ENOENT && path.has_relative_path() && makeWithParents(path.parent_path()) &&
           (::mkdir(path.c_str(), 0700) == 0 || errno == EEXIST);
}

} // namespace

Result<PrivateDirectory> PrivateDirectory::open(const fs::path& path) {
    Descriptor directory(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    struct stat info = {};
    if (!directory.valid()) {
        const int error = errno;
        if (error == ENOENT)
            return fail(ErrorCode::NotFound, Sentence("can't be opened: {0}", systemText(error)),
                        inFile(path.string()));
        if (::lstat(path.c_str(), &info) == 0 && !S_ISDIR(info.st_mode))
            return refuse(Sentence("is {0}, not a directory", kindName(info.st_mode)), path);
        return refuse(Sentence("can't be opened: {0}", systemText(error)), path);
    }
    if (::fstat(directory.get(), &info) != 0)
        return refuse(Sentence("can't be examined: {0}", systemText(errno)), path);
    if (info.st_uid != thisUser())
        return refuse(Sentence("belongs to user {0}, not to this one, {1}", info.st_uid, thisUser()), path);
    if ((info.st_mode & (S_IWGRP | S_IWOTH)) != 0)
        return refuse(
            Sentence("is writable by others: expected mode 0700, found {0:04o}", info.st_mode & 07777U),
            path);
    if ((info.st_mode & 07777U) != 0700 && !makeOwnersAlone(directory.get()))
        return refuse(Sentence("can't be made private: {0}", systemText(errno)), path);
    return PrivateDirectory(std::move(directory));
}

Result<PrivateDirectory> PrivateDirectory::make(const fs::path& path) {
    if (!makeWithParents(path))
        return refuse(Sentence("can't be made: {0}", systemText(errno)), path);
    return open(path);
}

Descriptor PrivateDirectory::openFile(const std::string& name) const {
    Descriptor file(
        ::openat(directory_.get(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    struct stat info = {};
    if (!file.valid() || ::fstat(file.get(), &info) != 0 || !S_ISREG(info.st_mode) ||
        info.st_uid != thisUser())
        return {};
    return file;
}

} // namespace texplorer
