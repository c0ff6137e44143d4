#pragma once

#include <span>

namespace texplorer::render {

/// A function added to OpenGL after version 1.1, which may be missing at run time: GLEW's pointer to it is
/// null if the driver lists neither the version nor the extension.
struct GlFunction {
    const char* name;
    const char* source; ///< the version or the extension
    bool (*isLoaded)();
    bool needed = true; ///< false: its caller checks for it
};

/// All such functions that Texplorer calls. A test compares the list with the calls.
[[nodiscard]] std::span<const GlFunction> glFunctions();

} // namespace texplorer::render
