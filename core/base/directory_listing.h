#pragma once

#include <dirent.h>
#include <fcntl.h>
#include <memory>
#include <unistd.h>

namespace texplorer {

/// Calls `visit` with every name in an open directory; with none where it can't be listed.
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
    while (const dirent* entry = ::readdir(names.get())) // NOLINT(concurrency-mt-unsafe): a listing of ours
        visit(static_cast<const char*>(entry->d_name));
}

} // namespace texplorer
