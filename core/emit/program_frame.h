#pragma once

#include "texplorer/emit/emission.h"

#include <vector>

namespace texplorer::emit {

/// What differs between programs in C.
struct CProgram {
    std::vector<std::string> hints{};   ///< of glfwWindowHint, each with its two arguments
    std::vector<std::string> headers{}; ///< beside those that all have: "stddef.h"
};

/// What was written, with all that a program in C needs around it: what it is and how it is compiled,
/// headers, variables, functions, the mouse, main(), and long arrays at its end.
[[nodiscard]] std::vector<Line> framed(Emission&& emission, const CProgram& program);

} // namespace texplorer::emit
