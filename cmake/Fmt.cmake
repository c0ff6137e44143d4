# TEXPLORER_FMT: the fmt library. Linked if possible; built from its headers for another standard library or processor
# than it was built for.
include(CheckCXXSourceCompiles)
find_package(fmt QUIET GLOBAL)
if(fmt_FOUND)
    set(CMAKE_REQUIRED_LIBRARIES fmt::fmt)
    check_cxx_source_compiles("
        #include <fmt/core.h>
        int main(int count, char**) { return static_cast<int>(fmt::format(\"{}\", count).size()); }"
        TEXPLORER_FMT_LINKS)
    unset(CMAKE_REQUIRED_LIBRARIES)
endif()
if(TEXPLORER_FMT_LINKS)
    set(TEXPLORER_FMT fmt::fmt)
    set(TEXPLORER_FMT_PACKAGE fmt) # its name in pkg-config
else()
    find_path(FMT_INCLUDE_DIR fmt/core.h REQUIRED)
    add_library(texplorer_fmt STATIC cmake/fmt_from_headers.cpp)
    set_target_properties(texplorer_fmt PROPERTIES EXPORT_NAME fmt)
    target_include_directories(texplorer_fmt SYSTEM PUBLIC $<BUILD_INTERFACE:${FMT_INCLUDE_DIR}>)
    install(TARGETS texplorer_fmt EXPORT texplorer-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
            COMPONENT development)
    set(TEXPLORER_FMT texplorer_fmt)
endif()
