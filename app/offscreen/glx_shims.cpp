// The static libGLEW.a finds GL functions through GLX. There is no GLX here: what it calls is answered by
// OSMesa or EGL, or by "no such thing", so that nothing needs libGL. glewInit() then loads every GL function
// and ends with a GLX error, which loadCapabilities() knows.

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
