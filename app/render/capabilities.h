#pragma once

#include "app/view/capabilities.h"
#include "core/base/result.h"

namespace texplorer::render {

/// Loads the GL entry points of the current context and asks it. An error names what Texplorer needs
/// (OpenGL 2.1 with fixed functions and GL_ARB_framebuffer_object) and what the driver offers.
[[nodiscard]] Result<view::Capabilities> loadCapabilities();

} // namespace texplorer::render
