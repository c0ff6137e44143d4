#pragma once

// What POSIX has and WebAssembly's C library lacks. Included before each test there; nothing can start a
// process.

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <sys/stat.h>

inline char* mkdtemp(char* name) {
    const std::size_t end = std::string(name).size();
    for (int number = 100000; number <= 999999; ++number) {
        std::to_string(number).copy(name + end - 6, 6);
        if (::mkdir(name, 0700) == 0)
            return name;
        if (errno != EEXIST)
            return nullptr;
    }
    return nullptr;
}

inline int mkfifo(const char* /*name*/, mode_t /*mode*/) {
    return -1;
}

inline std::FILE* popen(const char* /*command*/, const char* /*mode*/) {
    return nullptr;
}
inline int pclose(std::FILE* /*stream*/) {
    return -1;
}
