# texplorer_embed(TARGET FOLDER NAMES HEADER NAMESPACE TYPE FUNCTION): compiles files of FOLDER into TARGET, so that an
# installed program needs none: FUNCTION, which HEADER declares, returns them as const std::vector<TYPE>&, each
# {name, text}. What isn't a text by its name is embedded byte by byte, as a literal too, which compiles faster than a
# list of numbers. Run as a script, this file writes that source.
if(CMAKE_SCRIPT_MODE_FILE)
    cmake_minimum_required(VERSION 3.25)
    string(REPLACE "," ";" names "${NAMES}")
    set(text "// Made by cmake/EmbedFiles.cmake.\n#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\n\n")
    string(APPEND text "const std::vector<${TYPE}>& ${FUNCTION}() {\n    static const std::vector<${TYPE}> files{\n")
    foreach(name IN LISTS names)
        if(name MATCHES "\\.(bmp|dds|tga|png|jpg)$")
            file(READ "${FOLDER}/${name}" content HEX)
            string(LENGTH "${content}" digits)
            math(EXPR size "${digits} / 2")
            string(REGEX REPLACE "(..)" "\\\\x\\1" content "${content}")
            string(APPEND text "        {\"${name}\", {\"${content}\", ${size}}},\n")
        else()
            file(READ "${FOLDER}/${name}" content)
            string(APPEND text "        {\"${name}\", R\"text(${content})text\"},\n")
        endif()
    endforeach()
    string(APPEND text "    };\n    return files;\n}\n\n} // namespace ${NAMESPACE}\n")
    file(WRITE "${OUT}" "${text}")
    return()
endif()

set(TEXPLORER_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
function(texplorer_embed target folder names header namespace type function)
    set(out ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
    list(JOIN names "," joined)
    set(embed ${CMAKE_COMMAND} -DOUT=${out} -DFOLDER=${folder} -DNAMES=${joined} -DHEADER=${header}
        -DNAMESPACE=${namespace} -DTYPE=${type} -DFUNCTION=${function} -P ${TEXPLORER_EMBED_SCRIPT})
    if(NOT EXISTS ${out}) # for tools that read sources without a build, such as clang-tidy
        execute_process(COMMAND ${embed} COMMAND_ERROR_IS_FATAL ANY)
    endif()
    list(TRANSFORM names PREPEND ${folder}/ OUTPUT_VARIABLE files)
    add_custom_command(OUTPUT ${out} COMMAND ${embed} DEPENDS ${files} ${TEXPLORER_EMBED_SCRIPT}
        COMMENT "Embedding ${folder}" VERBATIM)
    target_sources(${target} PRIVATE ${out})
endfunction()
