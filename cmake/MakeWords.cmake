# Run as a script: what is installed and made of the programs' own tables. PROGRAMS (with commas between them) each
# write their manual pages and completion, and texshot the schemas of scenes and suites, into OUT.
#   cmake -DPROGRAMS=bin/texshot,bin/texplorer -DOUT=words -DGZIP=/usr/bin/gzip -DDATE=1795392000 -P MakeWords.cmake
cmake_minimum_required(VERSION 3.25)
set(ENV{SOURCE_DATE_EPOCH} ${DATE}) # a page's
set(ENV{ASAN_OPTIONS} detect_leaks=0)
string(REPLACE "," ";" programs "${PROGRAMS}")
file(REMOVE_RECURSE "${OUT}")
foreach(program IN LISTS programs)
    get_filename_component(name "${program}" NAME)
    file(MAKE_DIRECTORY "${OUT}/man" "${OUT}/bash" "${OUT}/zsh" "${OUT}/fish" "${OUT}/schema")
    execute_process(COMMAND "${program}" --manual list OUTPUT_VARIABLE pages COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX MATCHALL "[^\n]+" pages "${pages}")
    foreach(page IN LISTS pages)
        execute_process(COMMAND "${program}" --manual ${page} COMMAND "${GZIP}" -9nc
            OUTPUT_FILE "${OUT}/man/${page}.1.gz" COMMAND_ERROR_IS_FATAL ANY)
    endforeach()
    foreach(shell bash zsh fish)
        set(bash_file ${name})
        set(zsh_file _${name})
        set(fish_file ${name}.fish)
        execute_process(COMMAND "${program}" --completion ${shell} OUTPUT_FILE "${OUT}/${shell}/${${shell}_file}"
            COMMAND_ERROR_IS_FATAL ANY)
    endforeach()
    if(name STREQUAL texshot)
        execute_process(COMMAND "${program}" schema OUTPUT_FILE "${OUT}/schema/scene.schema.json"
            COMMAND_ERROR_IS_FATAL ANY)
        execute_process(COMMAND "${program}" schema --outputs OUTPUT_FILE "${OUT}/schema/output.schema.json"
            COMMAND_ERROR_IS_FATAL ANY)
        execute_process(COMMAND "${program}" schema --suites OUTPUT_FILE "${OUT}/schema/suite.schema.json"
            COMMAND_ERROR_IS_FATAL ANY)
    endif()
endforeach()
