# A compiler cache and a fast linker, if available.
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
    # The time of a precompiled header may differ.
    set(launcher ${CMAKE_COMMAND} -E env
        CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${CCACHE_PROGRAM})
    set(CMAKE_C_COMPILER_LAUNCHER ${launcher})
    set(CMAKE_CXX_COMPILER_LAUNCHER ${launcher})
endif()

find_program(MOLD_PROGRAM mold)
if(MOLD_PROGRAM AND NOT CMAKE_CROSSCOMPILING) # it knows no WebAssembly
    add_link_options(-fuse-ld=mold)
endif()
