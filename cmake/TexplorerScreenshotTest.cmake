# texplorer_add_screenshot_test(NAME name SCENE file GOLDEN file.png [SIZE WxH] [TIME seconds] [RENDERER renderer]
#                               [CONTEXT context] [SET path=value…] [TOLERANCE n] [SHARE p] [METRIC metric]
#                               [PIXELS_PER_DEGREE n] [MASK file] [RGB] [TIMEOUT seconds] [LABELS label…])
#
# A test of ctest: texshot draws the scene and holds it against the golden. Files are relative to the current source
# folder; the other words are those of `texshot shot` and `texshot compare`, which say what is wrong with them, and of
# ctest's properties. A failure leaves NAME-actual.png and, where both have one size, NAME-difference.png in the current
# binary folder. With TEXPLORER_UPDATE_GOLDENS=1 in the environment, a golden that is missing, different or no picture is
# written.
cmake_policy(PUSH)
cmake_policy(VERSION 3.19...3.25)


function(texplorer_add_screenshot_test)
    set(words NAME SCENE GOLDEN SIZE TIME RENDERER CONTEXT TOLERANCE SHARE METRIC PIXELS_PER_DEGREE MASK TIMEOUT)
    cmake_parse_arguments(PARSE_ARGV 0 SCREENSHOT "RGB" "${words}" "SET;LABELS")
    set(complaint "texplorer_add_screenshot_test(${SCREENSHOT_NAME}):")
    if(DEFINED SCREENSHOT_UNPARSED_ARGUMENTS)
        list(JOIN words ", " known)
        list(GET SCREENSHOT_UNPARSED_ARGUMENTS 0 found)
        message(FATAL_ERROR "${complaint} expected ${known}, RGB, SET or LABELS, found \"${found}\"")
    endif()
    if(DEFINED SCREENSHOT_KEYWORDS_MISSING_VALUES)
        list(GET SCREENSHOT_KEYWORDS_MISSING_VALUES 0 found)
        message(FATAL_ERROR "${complaint} ${found} has no value")
    endif()
    foreach(word IN ITEMS NAME SCENE GOLDEN)
        if("${SCREENSHOT_${word}}" STREQUAL "")
            message(FATAL_ERROR "${complaint} ${word} is missing")
        endif()
    endforeach()
    if(NOT SCREENSHOT_NAME MATCHES "^[A-Za-z0-9_.+-]+$")
        message(FATAL_ERROR "${complaint} NAME names files: expected letters, digits and _ . + -")
    endif()
    get_filename_component(file "${SCREENSHOT_GOLDEN}" NAME)
    if(NOT file MATCHES "^[^{}]+\\.png$")
        message(FATAL_ERROR "${complaint} GOLDEN: expected a file .png without braces in its name, found \"${file}\"")
    endif()
    if(DEFINED SCREENSHOT_TIMEOUT AND NOT SCREENSHOT_TIMEOUT MATCHES "^[0-9]+(\\.[0-9]+)?$")
        message(FATAL_ERROR "${complaint} TIMEOUT: expected seconds, found \"${SCREENSHOT_TIMEOUT}\"")
    endif()
    foreach(each IN LISTS SCREENSHOT_SET)
        if(NOT each MATCHES "^[^=]+=")
            message(FATAL_ERROR "${complaint} SET: expected path=value, found \"${each}\"")
        endif()
    endforeach()
    if(NOT TARGET texplorer::texshot)
        message(FATAL_ERROR "${complaint} this installation of texplorer has no texshot. It comes with Debian's package "
            "texplorer, or with a build with TEXPLORER_PROGRAMS=ON.")
    endif()

    foreach(word IN LISTS words)
        if(SCREENSHOT_${word} MATCHES ";")
            message(FATAL_ERROR "${complaint} ${word}: expected a value without a semicolon, found \"${SCREENSHOT_${word}}\"")
        endif()
    endforeach()
    foreach(word IN ITEMS SCENE GOLDEN MASK)
        if(NOT "${SCREENSHOT_${word}}" STREQUAL "")
            get_filename_component(SCREENSHOT_${word} "${SCREENSHOT_${word}}" ABSOLUTE)
        endif()
    endforeach()
    add_test(NAME ${SCREENSHOT_NAME}
        COMMAND ${CMAKE_COMMAND} -DTEXSHOT=$<TARGET_FILE:texplorer::texshot> -DNAME=${SCREENSHOT_NAME}
                "-DSCENE=${SCREENSHOT_SCENE}" "-DGOLDEN=${SCREENSHOT_GOLDEN}" "-DSIZE=${SCREENSHOT_SIZE}" "-DTIME=${SCREENSHOT_TIME}"
                "-DRENDERER=${SCREENSHOT_RENDERER}" "-DCONTEXT=${SCREENSHOT_CONTEXT}" "-DMETRIC=${SCREENSHOT_METRIC}"
                "-DTOLERANCE=${SCREENSHOT_TOLERANCE}" "-DSHARE=${SCREENSHOT_SHARE}" "-DMASK=${SCREENSHOT_MASK}"
                "-DPIXELS_PER_DEGREE=${SCREENSHOT_PIXELS_PER_DEGREE}" "-DRGB=${SCREENSHOT_RGB}" "-DSET=${SCREENSHOT_SET}"
                "-DTESTS=${CMAKE_BINARY_DIR}" "-DFOLDER=${CMAKE_CURRENT_BINARY_DIR}"
                -P "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/TexplorerRunScreenshotTest.cmake")
    set_tests_properties(${SCREENSHOT_NAME} PROPERTIES LABELS "${SCREENSHOT_LABELS}")
    if(DEFINED SCREENSHOT_TIMEOUT)
        set_tests_properties(${SCREENSHOT_NAME} PROPERTIES TIMEOUT ${SCREENSHOT_TIMEOUT})
    endif()
endfunction()

cmake_policy(POP)
