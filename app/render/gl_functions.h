#pragma once

#include <span>

namespace texplorer::render {

/// A function that OpenGL got after version 1.1, and so may be missing at run time: GLEW's pointer to it is
/// null where the driver lists neither the version nor the extension that brings it.
struct GlFunction {
    const char* name;
    const char* source; ///< the version or the extension
    bool (*isLoaded)();
    bool needed = true; ///< else its caller asks first
};

/// Everything of the kind that Texplorer calls. A test holds the list against the calls.
[[nodiscard]] std::span<const GlFunction> glFunctions();

} // namespace texplorer::render
