# `cmake --install` gives the two programs and the library: find_package(texplorer) defines texplorer::core.
include(CMakePackageConfigHelpers)

get_property(layers GLOBAL PROPERTY TEXPLORER_LAYERS)
install(TARGETS texplorer_core ${layers} EXPORT texplorer-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/core DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/texplorer
        FILES_MATCHING PATTERN "*.h")
install(EXPORT texplorer-targets NAMESPACE texplorer:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/texplorer)

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/texplorer-config.cmake.in
    ${PROJECT_BINARY_DIR}/texplorer-config.cmake
    INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/texplorer)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/texplorer-config-version.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/texplorer-config.cmake ${PROJECT_BINARY_DIR}/texplorer-config-version.cmake
        ${PROJECT_SOURCE_DIR}/cmake/FindSquish.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/texplorer)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
if(TEXPLORER_PROGRAMS)
    install(FILES ${PROJECT_SOURCE_DIR}/assets/texplorer.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
    install(FILES ${PROJECT_SOURCE_DIR}/assets/texplorer.svg
            DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
endif()
