# `cpack` makes Debian packages of what is installed: texplorer, with the programs, and libtexplorer-dev, with the
# library. `./dev package` does so, from a build of its own, and tries them in a bare Debian.
set(TEXPLORER_MAINTAINER "The Texplorer authors <texplorer@packages.invalid>" CACHE STRING
    "Who makes the packages, as Debian has it: NAME <ADDRESS>")
find_program(GZIP_PROGRAM gzip REQUIRED)

# Debian requires of each package: its copyright, and a changelog packed without the time.
set(ENV{SOURCE_DATE_EPOCH} ${TEXPLORER_RELEASED}) # used by TIMESTAMP as the current time
string(TIMESTAMP TEXPLORER_RELEASE_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)
unset(ENV{SOURCE_DATE_EPOCH})
set(folder ${PROJECT_BINARY_DIR}/packaging)
configure_file(${PROJECT_SOURCE_DIR}/packaging/changelog.in ${folder}/changelog @ONLY)
execute_process(COMMAND ${GZIP_PROGRAM} -9nc ${folder}/changelog OUTPUT_FILE ${folder}/changelog.gz
    COMMAND_ERROR_IS_FATAL ANY)
foreach(package texplorer libtexplorer-dev)
    set(component programs)
    if(package STREQUAL libtexplorer-dev)
        set(component development)
    endif()
    install(FILES ${PROJECT_SOURCE_DIR}/packaging/copyright ${folder}/changelog.gz
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component} EXCLUDE_FROM_ALL)
    if(EXISTS ${PROJECT_SOURCE_DIR}/packaging/${package}.lintian-overrides)
        install(FILES ${PROJECT_SOURCE_DIR}/packaging/${package}.lintian-overrides
            DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides RENAME ${package}
            COMPONENT ${component} EXCLUDE_FROM_ALL)
    endif()
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME texplorer)
set(CPACK_PACKAGE_VENDOR Texplorer)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each package has its own
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL programs development)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${TEXPLORER_MAINTAINER}")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)

set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME texplorer)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SHLIBDEPS ON) # also for modules: their libraries are found when they start
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_DEPENDS fonts-dejavu-core)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS libgl1-mesa-dri)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SUGGESTS "fonts-droid-fallback, xplanet-images")
set(CPACK_DEBIAN_PROGRAMS_DESCRIPTION "explorer of OpenGL texture mapping
Texplorer shows what every setting of OpenGL texture mapping does, while it is
changed: filters, wrap modes, mip levels, anisotropy, formats, environments,
coordinate generation and the texture matrix, on a live cube and sphere. It
explains every pixel, number by number, and has lessons.
.
texshot draws the same scenes without a display, for screenshots and tests of
graphics programs, and looks into BMP, DDS, JPEG, PNG and TGA files.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libtexplorer-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
string(CONCAT CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libc6-dev, libstdc++-12-dev | libstdc++-dev, libdeflate-dev, libexpected-dev, libfmt-dev, libglm-dev, "
    "libjpeg62-turbo-dev | libjpeg-dev, libpng-dev, libsquish-dev, pkgconf | pkg-config")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "libgtest-dev, texplorer (= ${PROJECT_VERSION})") # gtest.h; screenshot tests
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "texture files, S3TC, and texture mapping as OpenGL specifies it
The static library behind Texplorer, for C++20: it reads and writes BMP, DDS,
JPEG, PNG and TGA files, flips and compresses S3TC blocks, makes mip levels,
and holds scenes with a renderer of its own that follows the specification of
OpenGL step by step. It needs neither OpenGL nor a window.
.
It is found by CMake's find_package(texplorer) and by pkg-config.")
include(CPack)
