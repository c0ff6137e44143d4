#pragma once

#include "app/view/context_choice.h"

#include <EGL/egl.h>
#include <string>
#include <vector>

namespace texplorer::offscreen {

/// The concrete choices for a choice, in the order in which they are tried: only EglSurfaceless and
/// EglDevice.
[[nodiscard]] std::vector<view::ContextChoice> eglPlaces(const view::ContextChoice& choice);

/// The initialised display of a choice. It stays initialised until the program ends, because contexts share
/// it. The error gives the reason.
[[nodiscard]] Result<EGLDisplay> openEglDisplay(const view::ContextChoice& place);

/// The name of the last EGL error on this thread: "EGL_BAD_MATCH".
[[nodiscard]] std::string eglError();

/// Whether a space-separated list of names, as EGL and OpenGL return them, contains `name`.
[[nodiscard]] bool hasExtension(const char* list, std::string_view name);

} // namespace texplorer::offscreen
