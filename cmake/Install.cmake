# `cmake --install` gives the two programs and the library: find_package(texplorer) defines texplorer::core, and
# `pkg-config texplorer` knows it too. Everything is found from where it lies, so that the prefix can be moved.
# With --strip nothing of it has debugging information.
include(CMakePackageConfigHelpers)

# The headers. <texplorer/…> is made in the build folder, for those who add this folder to a project of theirs.
get_property(headers GLOBAL PROPERTY TEXPLORER_HEADERS)
list(TRANSFORM headers PREPEND ${PROJECT_SOURCE_DIR}/core/ OUTPUT_VARIABLE sources)
list(JOIN headers "," names)
set(include ${PROJECT_BINARY_DIR}/include)
configure_file(${PROJECT_SOURCE_DIR}/cmake/version.h.in ${include}/texplorer/version.h @ONLY)
add_custom_command(OUTPUT ${include}/made
    COMMAND ${CMAKE_COMMAND} -DFROM=${PROJECT_SOURCE_DIR}/core -DTO=${include}/texplorer -DNAMES=${names}
            -P ${PROJECT_SOURCE_DIR}/cmake/PublicHeaders.cmake
    COMMAND ${CMAKE_COMMAND} -E touch ${include}/made
    DEPENDS ${sources} ${PROJECT_SOURCE_DIR}/cmake/PublicHeaders.cmake
    VERBATIM)
add_custom_target(texplorer_headers ALL DEPENDS ${include}/made)
if(NOT PROJECT_IS_TOP_LEVEL)
    target_include_directories(texplorer_core INTERFACE $<BUILD_INTERFACE:${include}>)
    add_dependencies(texplorer_core texplorer_headers)
endif()
install(DIRECTORY ${include}/texplorer DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")

# The archives, and the two ways to find them.
get_property(layers GLOBAL PROPERTY TEXPLORER_LAYERS)
install(TARGETS texplorer_core ${layers} EXPORT texplorer-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT texplorer-targets NAMESPACE texplorer:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/texplorer)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/texplorer-config.cmake.in
    ${PROJECT_BINARY_DIR}/texplorer-config.cmake
    INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/texplorer)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/texplorer-config-version.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/texplorer-config.cmake ${PROJECT_BINARY_DIR}/texplorer-config-version.cmake
        ${PROJECT_SOURCE_DIR}/cmake/FindSquish.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/texplorer)

set(archives "")
foreach(layer ${layers}) # declared from the lowest to the highest, linked the other way round
    get_target_property(type ${layer} TYPE)
    if(type STREQUAL STATIC_LIBRARY)
        list(PREPEND archives -l${layer})
    endif()
endforeach()
if(TARGET texplorer_fmt)
    list(APPEND archives -ltexplorer_fmt)
endif()
list(JOIN archives " " archives)
file(RELATIVE_PATH up /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(${PROJECT_SOURCE_DIR}/cmake/texplorer.pc.in ${PROJECT_BINARY_DIR}/texplorer.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/texplorer.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# CMake strips programs and modules; of archives it would take the symbols, too, and so leaves them alone.
install(CODE "
    if(CMAKE_INSTALL_DO_STRIP)
        file(GLOB archives \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/libtexplorer_*.a\")
        execute_process(COMMAND ${CMAKE_STRIP} --strip-debug \${archives} COMMAND_ERROR_IS_FATAL ANY)
    endif()")

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
if(TEXPLORER_PROGRAMS)
    # For `texplorer --shaders`: to be copied and changed. The programs have their own inside.
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/shaders DESTINATION ${CMAKE_INSTALL_DATADIR}/texplorer)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/assets/scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/texplorer)
    install(FILES ${PROJECT_SOURCE_DIR}/assets/texplorer.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
    install(FILES ${PROJECT_SOURCE_DIR}/assets/texplorer.svg
            DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
endif()
