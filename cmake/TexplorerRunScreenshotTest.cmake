# Run as a script by the tests that texplorer_add_screenshot_test has added: draws SCENE, compares it with GOLDEN.
cmake_minimum_required(VERSION 3.19...3.25)

set(actual "${NAME}-actual.png")
set(difference "${NAME}-difference.png")
file(REMOVE "${FOLDER}/${actual}" "${FOLDER}/${difference}") # from the previous run

set(draw "")
foreach(word IN ITEMS SIZE TIME RENDERER CONTEXT)
    if(NOT "${${word}}" STREQUAL "")
        string(TOLOWER "${word}" option)
        list(APPEND draw "--${option}=${${word}}")
    endif()
endforeach()
foreach(each IN LISTS SET)
    list(APPEND draw "--set=${each}")
endforeach()
set(hold "")
if(RGB)
    list(APPEND hold --rgb)
endif()
foreach(word IN ITEMS METRIC TOLERANCE SHARE PIXELS_PER_DEGREE MASK) # a [ in a file's name would hide the next words
    if(NOT "${${word}}" STREQUAL "")
        string(TOLOWER "${word}" option)
        string(REPLACE "_" "-" option "${option}")
        list(APPEND hold "--${option}=${${word}}")
    endif()
endforeach()

# Runs in its folder: braces in the folder's name would be placeholders in -o.
function(draw_into folder file)
    execute_process(COMMAND "${TEXSHOT}" shot "${SCENE}" ${draw} ${ARGN} -o "${file}"
        WORKING_DIRECTORY "${folder}" RESULT_VARIABLE result)
    if(NOT result STREQUAL 0)
        message(FATAL_ERROR "${NAME}: ${folder}/${file} was not drawn: ${TEXSHOT} ended with ${result}")
    endif()
endfunction()

set(update "$ENV{TEXPLORER_UPDATE_GOLDENS}")
if(update STREQUAL "0")
    set(update "")
endif()

draw_into("${FOLDER}" "${actual}")
if(NOT update STREQUAL "") # report a wrong word or mask before a golden is written
    execute_process(COMMAND "${TEXSHOT}" compare "${actual}" "${actual}" ${hold}
        WORKING_DIRECTORY "${FOLDER}" RESULT_VARIABLE result OUTPUT_QUIET)
    if(NOT result STREQUAL 0)
        message(FATAL_ERROR "${NAME}: nothing can be compared: ${TEXSHOT} ended with ${result}")
    endif()
endif()
if(EXISTS "${GOLDEN}")
    execute_process(COMMAND "${TEXSHOT}" compare "${GOLDEN}" "${actual}" ${hold} -o "${difference}"
        WORKING_DIRECTORY "${FOLDER}" RESULT_VARIABLE result)
    if(result STREQUAL 0)
        file(REMOVE "${FOLDER}/${actual}" "${FOLDER}/${difference}")
        return()
    endif()
    set(broken FALSE) # a file that is not a picture: a new golden may replace it
    if(NOT update STREQUAL "" AND result STREQUAL 2)
        execute_process(COMMAND "${CMAKE_COMMAND}" -E cat "${GOLDEN}" RESULT_VARIABLE unreadable OUTPUT_QUIET ERROR_QUIET)
        if(unreadable STREQUAL 0)
            set(broken TRUE)
        endif()
    endif()
    if(NOT result STREQUAL 1 AND NOT broken)
        message(FATAL_ERROR "${NAME}: not compared with ${GOLDEN}: ${TEXSHOT} ended with ${result}")
    endif()
endif()

if(NOT update STREQUAL "")
    get_filename_component(folder "${GOLDEN}" DIRECTORY)
    get_filename_component(file "${GOLDEN}" NAME)
    file(MAKE_DIRECTORY "${folder}")
    draw_into("${folder}" "${file}" --no-metadata) # as `texshot test --update` writes goldens
    file(REMOVE "${FOLDER}/${actual}" "${FOLDER}/${difference}")
    message(NOTICE "${NAME}: the golden was written: ${GOLDEN}")
    return()
endif()

# Notices, as the words of an error are wrapped.
string(REGEX REPLACE "([.+])" "\\\\\\1" pattern "${NAME}")
string(REPLACE "'" "'\\''" TESTS "${TESTS}")
set(command "TEXPLORER_UPDATE_GOLDENS=1 ctest --test-dir '${TESTS}' -R '^${pattern}$'")
if(NOT EXISTS "${GOLDEN}")
    message(NOTICE "${NAME}: there is no golden ${GOLDEN}\n"
        "  what was drawn:  ${FOLDER}/${actual}\n"
        "  if it is right, this makes the golden:  ${command}")
    message(FATAL_ERROR "${NAME}: the golden is missing")
endif()
set(files "  expected:  ${GOLDEN}\n  actual:  ${FOLDER}/${actual}\n")
if(EXISTS "${FOLDER}/${difference}")
    string(APPEND files "  difference:  ${FOLDER}/${difference}\n")
endif()
message(NOTICE "${NAME}: not like its golden\n${files}"
    "  if the new one is right, this takes it over:  ${command}")
message(FATAL_ERROR "${NAME}: not like its golden")
