# Run as a script: the headers of core/ as users include them. Inside the project a line says "core/scene/scene.h", here
# it says <texplorer/scene/scene.h>. What is there and not in the list is removed.
#   cmake -DFROM=core -DTO=include/texplorer -DNAMES=scene/scene.h,mesh/mesh.h -P PublicHeaders.cmake
string(REPLACE "," ";" names "${NAMES}")
file(GLOB_RECURSE present RELATIVE "${TO}" "${TO}/*.h")
list(REMOVE_ITEM present ${names} version.h)
foreach(name IN LISTS present)
    file(REMOVE "${TO}/${name}")
endforeach()
foreach(name IN LISTS names)
    file(READ "${FROM}/${name}" text)
    string(REGEX REPLACE "#include \"core/([^\"]+)\"" "#include <texplorer/\\1>" text "${text}")
    string(REPLACE "core/" "texplorer/" text "${text}") # in comments
    set(old "")
    if(EXISTS "${TO}/${name}")
        file(READ "${TO}/${name}" old)
    endif()
    if(NOT text STREQUAL old) # an unchanged file keeps its time
        file(WRITE "${TO}/${name}" "${text}")
    endif()
endforeach()
