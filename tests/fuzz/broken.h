#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace texplorer::fuzz {

/// Ends the program, so that libFuzzer keeps the input that led here.
[[noreturn]] inline void broken(const std::string& what) {
    std::fprintf(stderr, "broken promise: %s\n", what.c_str());
    std::abort();
}

} // namespace texplorer::fuzz
