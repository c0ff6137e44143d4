# texplorer_layer(TARGET [PROGRAM | MODULE | OBJECT] [PRECOMPILED kind] SOURCES … PUBLIC … PRIVATE … HEADERS …)
#
# A folder as a library, or as a program, that links the folders below it and no others. texplorer_NAME is also
# texplorer::NAME. Without SOURCES the library is headers alone. Every folder of core and app is declared here: the
# architecture tests read the property TEXPLORER_LAYERS.
#
#   PRECOMPILED  what is precompiled for it (Precompiled.cmake), code unless given; of a program its own kind
#   HEADERS      of core: the headers that are installed for users of the library; the others are the library's own
#
# Headers of core are <texplorer/…> for all: a link of that name in the build folder leads to core. Headers of app are
# "app/…", which core can't include.
function(texplorer_layer target)
    cmake_parse_arguments(PARSE_ARGV 1 LAYER "PROGRAM;MODULE;OBJECT" "PRECOMPILED" "HEADERS;SOURCES;PUBLIC;PRIVATE")
    set(scope PUBLIC)
    if(LAYER_PROGRAM)
        add_executable(${target} ${LAYER_SOURCES})
    elseif(LAYER_MODULE)
        add_library(${target} MODULE ${LAYER_SOURCES})
    elseif(LAYER_OBJECT)
        add_library(${target} OBJECT ${LAYER_SOURCES})
    elseif(LAYER_SOURCES)
        add_library(${target} STATIC ${LAYER_SOURCES})
    else()
        add_library(${target} INTERFACE)
        set(scope INTERFACE)
    endif()
    string(REGEX REPLACE "^texplorer_" "" name ${target})
    if(NOT LAYER_PROGRAM AND NOT name STREQUAL target)
        add_library(texplorer::${name} ALIAS ${target})
    endif()
    target_link_libraries(${target} ${scope} ${LAYER_PUBLIC})
    if(NOT scope STREQUAL "INTERFACE")
        target_link_libraries(${target} PRIVATE ${LAYER_PRIVATE} ${TEXPLORER_FMT})
        if(LAYER_PROGRAM OR LAYER_MODULE) # its flags differ
            set(LAYER_PRECOMPILED ${target})
        elseif(NOT LAYER_PRECOMPILED)
            set(LAYER_PRECOMPILED code)
        endif()
        texplorer_precompile(${target} ${LAYER_PRECOMPILED})
        texplorer_warnings(${target})
    endif()
    set_property(GLOBAL APPEND PROPERTY TEXPLORER_LAYERS ${target})
    if(target MATCHES "^texplorer_core_")
        set_property(GLOBAL APPEND PROPERTY TEXPLORER_CORE_LAYERS ${target})
        set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
        target_compile_features(${target} ${scope} cxx_std_20)
        target_include_directories(${target} ${scope}
            $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/headers>
            $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
        file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR}/core ${CMAKE_CURRENT_SOURCE_DIR})
        install(FILES ${LAYER_HEADERS} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/texplorer/${folder}
                COMPONENT development)
    else()
        target_include_directories(${target} ${scope} ${PROJECT_SOURCE_DIR})
    endif()
endfunction()
