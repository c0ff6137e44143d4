# texplorer_precompile(TARGET KIND): what most sources include is read once. KIND is code, panels, screenshot or LAYER_tests;
# of a kind that has no list here, there are too few sources to make a precompiled header worth its time.
# TEXPLORER_PRECOMPILE is off where it should show that every file includes what it uses.
option(TEXPLORER_PRECOMPILE "Precompile the headers that most sources include" ON)

set(texplorer_precompiled_common
    <algorithm> <array> <chrono> <cmath> <condition_variable> <cstddef> <cstdint> <cstring> <filesystem> <functional>
    <limits> <map> <memory> <mutex> <optional> <span> <stop_token> <string> <string_view> <thread> <utility> <variant>
    <vector>
    <glm/glm.hpp> <tl/expected.hpp>)
set(texplorer_precompiled_code ${texplorer_precompiled_common} <fmt/core.h>)
set(texplorer_precompiled_panels ${texplorer_precompiled_code} <imgui.h>)
set(texplorer_precompiled_screenshot ${texplorer_precompiled_code} <nlohmann/json.hpp>)
foreach(layer core render ui) # a precompiled header of their own: their flags differ
    set(texplorer_precompiled_${layer}_tests ${texplorer_precompiled_common} <gmock/gmock.h> <gtest/gtest.h>)
endforeach()

# The first target of a kind with these compiler options creates it; the others reuse it.
function(texplorer_precompile target kind)
    if(NOT TEXPLORER_PRECOMPILE OR NOT DEFINED texplorer_precompiled_${kind})
        return()
    endif()
    get_target_property(options ${target} COMPILE_OPTIONS)
    string(MD5 key "${kind} ${options}")
    get_property(maker GLOBAL PROPERTY TEXPLORER_PRECOMPILED_${key})
    if(maker)
        target_precompile_headers(${target} REUSE_FROM ${maker})
    else()
        target_precompile_headers(${target} PRIVATE ${texplorer_precompiled_${kind}})
        set_property(GLOBAL PROPERTY TEXPLORER_PRECOMPILED_${key} ${target})
    endif()
    if(CCACHE_PROGRAM AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        target_compile_options(${target} PRIVATE -fpch-preprocess) # ccache can then look into it
    endif()
endfunction()
