#include "tests/stage/no_files.h"

#include <cerrno>
#include <cstdio>
#include <dirent.h>
#include <dlfcn.h>

namespace texplorer::stage {
namespace {

NoFiles* active = nullptr;

bool isRefused(const char* file) {
    if (!active)
        return false;
    active->attempts.emplace_back(file);
    errno = ENOENT;
    return true;
}

/// The system's function of that name.
template<class Function>
Function* next(const char* name) {
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

using Open = int(const char*, int, ...);
using OpenAt = int(int, const char*, int, ...);
using OpenStream = std::FILE*(const char*, const char*);
using OpenFolder = DIR*(const char*);

} // namespace

NoFiles::NoFiles() {
    active = this;
}

NoFiles::~NoFiles() {
    active = nullptr;
}

// The names of the system's functions for these: the program's own go before those of its libraries. They are
// not declared as in the system's headers, which define some of them as macros or inline.
extern "C" {

[[gnu::visibility("default")]] int openFile(const char* file, int flags, unsigned mode) __asm__("open");
[[gnu::visibility("default")]] int openFile64(const char* file, int flags, unsigned mode) __asm__("open64");
[[gnu::visibility("default")]] int openFileAt(int folder, const char* file, int flags,
                                              unsigned mode) __asm__("openat");
[[gnu::visibility("default")]] int openFileAt64(int folder, const char* file, int flags,
                                                unsigned mode) __asm__("openat64");
[[gnu::visibility("default")]] std::FILE* openStream(const char* file, const char* mode) __asm__("fopen");
[[gnu::visibility("default")]] std::FILE* openStream64(const char* file, const char* mode) __asm__("fopen64");
[[gnu::visibility("default")]] DIR* openFolder(const char* file) __asm__("opendir");

int openFile(const char* file, int flags, unsigned mode) {
    return isRefused(file) ? -1 : next<Open>("open")(file, flags, mode);
}

int openFile64(const char* file, int flags, unsigned mode) {
    return isRefused(file) ? -1 : next<Open>("open64")(file, flags, mode);
}

int openFileAt(int folder, const char* file, int flags, unsigned mode) {
    return isRefused(file) ? -1 : next<OpenAt>("openat")(folder, file, flags, mode);
}

int openFileAt64(int folder, const char* file, int flags, unsigned mode) {
    return isRefused(file) ? -1 : next<OpenAt>("openat64")(folder, file, flags, mode);
}

std::FILE* openStream(const char* file, const char* mode) {
    return isRefused(file) ? nullptr : next<OpenStream>("fopen")(file, mode);
}

std::FILE* openStream64(const char* file, const char* mode) {
    return isRefused(file) ? nullptr : next<OpenStream>("fopen64")(file, mode);
}

DIR* openFolder(const char* file) {
    return isRefused(file) ? nullptr : next<OpenFolder>("opendir")(file);
}

} // extern "C"

} // namespace texplorer::stage
