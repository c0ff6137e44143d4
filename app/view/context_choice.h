#pragma once

// Which OpenGL draws where there is no display: what --context takes, and what "texshot drivers" lists.

#include "texplorer/base/result.h"

#include <string>
#include <string_view>

namespace texplorer::view {

/// A context of OpenGL without a display, or a rule that finds one.
struct ContextChoice {
    enum class Kind {
        Auto,           ///< OSMesa where it is there, else as Egl
        Osmesa,         ///< Mesa's drivers that draw into memory
        Egl,            ///< EglSurfaceless, or else the first device that gives a context
        EglSurfaceless, ///< EGL_MESA_platform_surfaceless
        EglDevice,      ///< EGL_EXT_platform_device
    };

    Kind kind = Kind::Auto;
    int device = 0; ///< of EglDevice: its place in EGL's list, from 0

    /// Of "auto", "osmesa", "egl", "egl:surfaceless" or "egl:N". The error is about `where`: "--context".
    [[nodiscard]] static Result<ContextChoice> parse(std::string_view text, std::string_view where);

    /// As parse() takes it.
    [[nodiscard]] std::string text() const;

    bool operator==(const ContextChoice&) const = default;
};

} // namespace texplorer::view
