// What WebAssembly's C library declares and doesn't define; see also plain_posix.h.

#include <cstdlib>

extern "C" int system(const char* /*command*/) {
    return -1;
}
