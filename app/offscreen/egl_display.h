#pragma once

#include "app/view/context_choice.h"

#include <EGL/egl.h>
#include <string>
#include <vector>

namespace texplorer::offscreen {

/// The places that a choice stands for, in the order in which they are tried: EglSurfaceless and EglDevice
/// alone.
[[nodiscard]] std::vector<view::ContextChoice> eglPlaces(const view::ContextChoice& choice);

/// The display of one of them, initialised. It stays so until the program ends: contexts share it. The error
/// says why there is none.
[[nodiscard]] Result<EGLDisplay> openEglDisplay(const view::ContextChoice& place);

/// "EGL_BAD_MATCH": what the last call of EGL on this thread complained about.
[[nodiscard]] std::string eglError();

/// Whether a list of names, as EGL and OpenGL give them, has this one.
[[nodiscard]] bool hasExtension(const char* list, std::string_view name);

} // namespace texplorer::offscreen
