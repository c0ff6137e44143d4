// The static libGLEW.a looks up GL functions through GLX, which is not available here. These functions answer
// by OSMesa or EGL, or report that a feature is missing, so that libGL is not needed. glewInit() then loads
// every GL function and returns a GLX error, which loadCapabilities() ignores.

#include "app/offscreen/gl_lookup.h"

extern "C" {

texplorer::offscreen::AnyFunction glXGetProcAddressARB(const unsigned char* name) {
    return texplorer::offscreen::findGlFunction(reinterpret_cast<const char*>(name));
}

const char* glXGetClientString(void* /*display*/, int /*name*/) {
    return "";
}

int glXQueryVersion(void* /*display*/, int* /*major*/, int* /*minor*/) {
    return 0;
}

void* glXGetCurrentDisplay() {
    return nullptr;
}
}
