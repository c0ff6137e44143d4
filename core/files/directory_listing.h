#pragma once

#include <dirent.h>
#include <fcntl.h>
#include <memory>
#include <unistd.h>

namespace texplorer {

/// Calls `visit` with the name of each entry of an open directory. Does nothing if the directory cannot be
/// listed.
template<class Visit>
void forEachName(int directory, const Visit& visit) {
    const int listing = ::openat(directory, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (listing < 0)
        return;
    const std::unique_ptr<DIR, decltype([](DIR* open) { ::closedir(open); })> names(::fdopendir(listing));
    if (!names) {
        ::close(listing);
        return;
    }
    while (const dirent* entry =
               ::readdir(names.get())) // NOLINT(concurrency-mt-unsafe): only this function uses this listing
        visit(static_cast<const char*>(entry->d_name));
}

} // namespace texplorer
