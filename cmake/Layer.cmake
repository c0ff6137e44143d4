# texplorer_layer(NAME HEADERS … SOURCES … PUBLIC … PRIVATE …): a folder of core as a library, texplorer::core_NAME, that
# links the folders below it and no others. Without SOURCES it is headers alone. HEADERS are those that users of the
# library include, as <texplorer/…> (PublicHeaders.cmake); the others are the library's own.
function(texplorer_layer name)
    cmake_parse_arguments(PARSE_ARGV 1 LAYER "" "" "HEADERS;SOURCES;PUBLIC;PRIVATE")
    set(target texplorer_core_${name})
    if(LAYER_SOURCES)
        add_library(${target} STATIC ${LAYER_SOURCES})
        set(scope PUBLIC)
        target_link_libraries(${target} PRIVATE ${LAYER_PRIVATE} ${TEXPLORER_FMT})
        texplorer_precompile(${target} code)
        texplorer_warnings(${target})
    else()
        add_library(${target} INTERFACE)
        set(scope INTERFACE)
    endif()
    add_library(texplorer::core_${name} ALIAS ${target})
    set_target_properties(${target} PROPERTIES EXPORT_NAME core_${name})
    target_compile_features(${target} ${scope} cxx_std_20)
    target_include_directories(${target} ${scope}
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_link_libraries(${target} ${scope} ${LAYER_PUBLIC})
    set_property(GLOBAL APPEND PROPERTY TEXPLORER_LAYERS ${target})
    file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR}/core ${CMAKE_CURRENT_SOURCE_DIR})
    list(TRANSFORM LAYER_HEADERS PREPEND ${folder}/)
    set_property(GLOBAL APPEND PROPERTY TEXPLORER_HEADERS ${LAYER_HEADERS})
endfunction()
