#pragma once

#include "app/view/capabilities.h"
#include "texplorer/base/result.h"

namespace texplorer::render {

/// Loads the GL entry points of the current context and queries its capabilities. The error names what
/// Texplorer needs (OpenGL 2.1 with fixed functions and GL_ARB_framebuffer_object) and what the driver
/// offers.
[[nodiscard]] Result<view::Capabilities> loadCapabilities();

/// The names and the version of a context of any kind. Does not query fixed functions.
[[nodiscard]] view::Capabilities namedCapabilities();

/// Whether the context has fixed functions: a core profile and a forward-compatible context do not.
[[nodiscard]] bool hasFixedFunctions();

} // namespace texplorer::render
