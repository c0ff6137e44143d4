#include "app/offscreen/egl_display.h"

#include <fmt/core.h>

#include <EGL/eglext.h>
#include <algorithm>
#include <array>

namespace texplorer::offscreen {
namespace {

using Kind = view::ContextChoice::Kind;

struct EglErrorRow {
    EGLint code;
    const char* name;
};

#define TEXPLORER_EGL_ERROR(name)                                                                            \
    EglErrorRow {                                                                                            \
        name, #name                                                                                          \
    } // NOLINT(cppcoreguidelines-macro-usage): two uses
constexpr std::array eglErrorRows{
    TEXPLORER_EGL_ERROR(EGL_NOT_INITIALIZED), TEXPLORER_EGL_ERROR(EGL_BAD_ACCESS),
    TEXPLORER_EGL_ERROR(EGL_BAD_ALLOC),       TEXPLORER_EGL_ERROR(EGL_BAD_ATTRIBUTE),
    TEXPLORER_EGL_ERROR(EGL_BAD_CONFIG),      TEXPLORER_EGL_ERROR(EGL_BAD_CONTEXT),
    TEXPLORER_EGL_ERROR(EGL_BAD_DISPLAY),     TEXPLORER_EGL_ERROR(EGL_BAD_MATCH),
    TEXPLORER_EGL_ERROR(EGL_BAD_PARAMETER),   TEXPLORER_EGL_ERROR(EGL_BAD_SURFACE),
    TEXPLORER_EGL_ERROR(EGL_CONTEXT_LOST),    TEXPLORER_EGL_ERROR(EGL_BAD_DEVICE_EXT)};
#undef TEXPLORER_EGL_ERROR

bool hasClientExtension(std::string_view name) {
    return hasExtension(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), name);
}

/// Uses EGL_EXT_device_enumeration; empty without that extension.
std::vector<EGLDeviceEXT> eglDevices() {
    if (!hasClientExtension("EGL_EXT_device_enumeration") && !hasClientExtension("EGL_EXT_device_base"))
        return {};
    const auto query = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    EGLint count = 0;
    if (!query || !query(0, nullptr, &count) || count < 1)
        return {};
    std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
    if (!query(count, devices.data(), &count))
        return {};
    devices.resize(
        static_cast<std::size_t>(std::clamp<EGLint>(count, 0, static_cast<EGLint>(devices.size()))));
    return devices;
}

Result<EGLDisplay> surfacelessDisplay() {
    if (!hasClientExtension("EGL_MESA_platform_surfaceless"))
        return fail(ErrorCode::Unsupported, "EGL has no EGL_MESA_platform_surfaceless");
    return eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
}

Result<EGLDisplay> deviceDisplay(int number) {
    const std::vector<EGLDeviceEXT> devices = eglDevices();
    if (static_cast<std::size_t>(number) >= devices.size())
        return fail(ErrorCode::OutOfRange,
                    devices.empty() ? "EGL lists no devices"
                                    : Sentence("EGL has the devices 0 to {0}", devices.size() - 1));
    if (!hasClientExtension("EGL_EXT_platform_device"))
        return fail(ErrorCode::Unsupported, "EGL has no EGL_EXT_platform_device");
    return eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(number)], nullptr);
}

} // namespace

std::vector<view::ContextChoice> eglPlaces(const view::ContextChoice& choice) {
    if (choice.kind == Kind::EglSurfaceless || choice.kind == Kind::EglDevice)
        return {choice};
    std::vector<view::ContextChoice> places{{Kind::EglSurfaceless, 0}};
    const int count = static_cast<int>(eglDevices().size());
    for (int device = 0; device < count; ++device)
        places.push_back({Kind::EglDevice, device});
    return places;
}

Result<EGLDisplay> openEglDisplay(const view::ContextChoice& place) {
    Result<EGLDisplay> display =
        place.kind == Kind::EglDevice ? deviceDisplay(place.device) : surfacelessDisplay();
    if (!display)
        return display;
    if (*display == EGL_NO_DISPLAY)
        return fail(ErrorCode::Driver, Sentence("eglGetPlatformDisplay says {0}", eglError()));
    if (!eglInitialize(*display, nullptr, nullptr))
        return fail(ErrorCode::Driver, Sentence("eglInitialize says {0}", eglError()));
    return display;
}

std::string eglError() {
    const EGLint code = eglGetError();
    const auto* found = std::ranges::find(eglErrorRows, code, &EglErrorRow::code);
    return found != eglErrorRows.end() ? found->name : fmt::format("{:#x}", code);
}

bool hasExtension(const char* list, std::string_view name) {
    for (std::string_view rest = list ? list : ""; !rest.empty();) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        if (rest.substr(0, end) == name)
            return true;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return false;
}

} // namespace texplorer::offscreen
