# Toolchain: i386 on an amd64 machine, with the libraries that `./dev core32` has unpacked into build/i386.
set(root ${CMAKE_CURRENT_LIST_DIR}/../build/i386/root)
set(flags "-O1 -m32 -msse2 -mfpmath=sse -isystem ${root}/usr/include/i386-linux-gnu") # rounds doubles as on amd64
set(CMAKE_C_FLAGS_INIT ${flags})
set(CMAKE_CXX_FLAGS_INIT ${flags})
set(CMAKE_CXX_STANDARD_LIBRARIES_INIT -lgomp) # needed by libsquish.a
set(CMAKE_LIBRARY_PATH ${root}/usr/lib/i386-linux-gnu)
set(CMAKE_INCLUDE_PATH ${root}/usr/include)
set(ENV{PKG_CONFIG_LIBDIR} ${root}/usr/lib/i386-linux-gnu/pkgconfig)
set(ENV{PKG_CONFIG_SYSROOT_DIR} ${root})
