#pragma once

#include "app/view/capabilities.h"
#include "core/base/result.h"

namespace texplorer::render {

/// Loads the GL entry points of the current context and asks it. An error names what Texplorer needs
/// (OpenGL 2.1 with fixed functions and GL_ARB_framebuffer_object) and what the driver offers.
[[nodiscard]] Result<view::Capabilities> loadCapabilities();

/// What a context of any kind says of itself, and no more than that: nothing is asked of fixed functions.
[[nodiscard]] view::Capabilities namedCapabilities();

/// Whether the context has them: neither a core profile has, nor a forward-compatible context.
[[nodiscard]] bool hasFixedFunctions();

} // namespace texplorer::render
