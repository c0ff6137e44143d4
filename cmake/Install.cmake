# `cmake --install` gives the two programs (component programs) and the library (component development):
# find_package(texplorer) defines texplorer::core, texplorer::texshot where it is installed, and
# texplorer_add_screenshot_test; `pkg-config texplorer` knows the library too. Everything is found from where it
# lies, so that the prefix can be moved. With --strip nothing of it has debugging information.
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
install(DIRECTORY ${include}/texplorer DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
        FILES_MATCHING PATTERN "*.h")

# The archives, for find_package and pkg-config.
get_property(layers GLOBAL PROPERTY TEXPLORER_CORE_LAYERS)
install(TARGETS texplorer_core ${layers} EXPORT texplorer-targets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(EXPORT texplorer-targets NAMESPACE texplorer:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/texplorer
        COMPONENT development)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/texplorer-config.cmake.in
    ${PROJECT_BINARY_DIR}/texplorer-config.cmake
    INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/texplorer PATH_VARS CMAKE_INSTALL_BINDIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/texplorer-config-version.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/texplorer-config.cmake ${PROJECT_BINARY_DIR}/texplorer-config-version.cmake
        ${PROJECT_SOURCE_DIR}/cmake/FindSquish.cmake ${PROJECT_SOURCE_DIR}/cmake/TexplorerScreenshotTest.cmake
        ${PROJECT_SOURCE_DIR}/cmake/TexplorerRunScreenshotTest.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/texplorer COMPONENT development)

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
install(FILES ${PROJECT_BINARY_DIR}/texplorer.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)

# CMake strips programs and modules. It does not strip archives, because it would remove their symbols as well.
install(CODE "
    if(CMAKE_INSTALL_DO_STRIP)
        file(GLOB archives \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/libtexplorer_*.a\")
        execute_process(COMMAND ${CMAKE_STRIP} --strip-debug \${archives} COMMAND_ERROR_IS_FATAL ANY)
    endif()" COMPONENT development)

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT license)
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CONTRIBUTING.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/tests/end_to_end/consumer DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples
        COMPONENT development)
if(TEXPLORER_PROGRAMS)
    # For `texplorer --shaders`: to copy and change. The programs contain their own.
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/shaders DESTINATION ${CMAKE_INSTALL_DATADIR}/texplorer)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/assets/scenes ${PROJECT_SOURCE_DIR}/assets/suites
            DESTINATION ${CMAKE_INSTALL_DATADIR}/texplorer)
    # For clusters: to copy and change.
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/assets/cluster DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples)
    # For the desktop: the program, its icon, scenes as a file type, and its page in a software centre.
    install(FILES ${PROJECT_SOURCE_DIR}/assets/texplorer.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications
           )
    install(FILES ${PROJECT_SOURCE_DIR}/assets/texplorer.svg
            DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
    install(FILES ${PROJECT_SOURCE_DIR}/assets/texplorer.mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages
            RENAME texplorer.xml)
    install(FILES ${PROJECT_SOURCE_DIR}/assets/org.texplorer.Texplorer.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo
           )
endif()

# Generated by the programs: manual pages, completion for three shells, the schemas of scenes and suites.
if(TEXPLORER_PROGRAMS)
    find_program(GZIP_PROGRAM gzip REQUIRED)
    set(words ${PROJECT_BINARY_DIR}/words)
    add_custom_command(OUTPUT ${words}/made
        COMMAND ${CMAKE_COMMAND} -DPROGRAMS=$<TARGET_FILE:texshot>,$<TARGET_FILE:texplorer> -DOUT=${words}
                -DGZIP=${GZIP_PROGRAM} -DDATE=${TEXPLORER_RELEASED} -P ${PROJECT_SOURCE_DIR}/cmake/MakeWords.cmake
        COMMAND ${CMAKE_COMMAND} -E touch ${words}/made
        DEPENDS texshot texplorer ${PROJECT_SOURCE_DIR}/cmake/MakeWords.cmake
        COMMENT "Writing manual pages and completion" VERBATIM)
    add_custom_target(texplorer_words ALL DEPENDS ${words}/made)
    install(DIRECTORY ${words}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
    install(DIRECTORY ${words}/bash/ DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
           )
    install(DIRECTORY ${words}/zsh/ DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
    install(DIRECTORY ${words}/fish/ DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
           )
    install(DIRECTORY ${words}/schema/ DESTINATION ${CMAKE_INSTALL_DATADIR}/texplorer)
endif()
