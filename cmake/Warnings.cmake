# texplorer_warnings(TARGET): the warnings of this project, each with what it catches.
function(texplorer_warnings target)
    target_compile_options(${target} PRIVATE
        -Wall -Wextra -Wpedantic
        -Wshadow              # a name that hides another
        -Wnon-virtual-dtor    # deleting through a base without a virtual destructor
        -Wold-style-cast      # casts that say nothing about what they do
        -Wcast-align          # casts that assume more alignment than there is
        -Woverloaded-virtual  # a virtual hidden instead of overridden
        -Wconversion          # implicit conversions that may lose a value
        -Wsign-conversion     # and those that may change a sign
        -Wdouble-promotion    # float arithmetic done in double by accident
        -Wformat=2            # printf formats that don't match or aren't literals
        -Wimplicit-fallthrough # a case that runs into the next
        $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> # GCC 12's false alarm about "text" + std::string (PR 105651)
        -Wno-missing-field-initializers # designated initializers that name a part (GCC PR 96868; Clang since 19)
        $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized> # its false alarms about std::optional (PR 80635)
        $<$<CXX_COMPILER_ID:Clang>:-Wno-double-promotion> # Clang warns even where the text says double{x}
    )
    if(TEXPLORER_WERROR)
        target_compile_options(${target} PRIVATE -Werror)
    endif()
endfunction()
