#pragma once

// What a context says of itself. Asked of the module that makes it, in the process that asks: a driver may
// end or hold that process, so whoever only wants to know asks in another one (driver_question.h).

#include "app/view/context_choice.h"
#include "texplorer/base/result.h"

#include <string>
#include <vector>

namespace texplorer::screenshot {

struct DriverReport {
    std::string renderer;
    std::string vendor;
    std::string version;
    std::string shadingLanguage; ///< "4.50"; empty: none
    bool isCore = false;         ///< without fixed functions
    int maxTextureSize = 0;
    float maxAnisotropy = 1;
    bool s3tc = false;
    bool textureBorders = false;
    std::vector<std::string> extensions{};
    Sentence lack{}; ///< why Texplorer can't draw with it; empty: it can
};

/// The contexts that a module may be asked for by themselves. The error: it can't be loaded, or isn't built.
[[nodiscard]] Result<std::vector<view::ContextChoice>> contextsOf(const view::ContextChoice& choice);

/// Makes the context and asks it.
[[nodiscard]] Result<DriverReport> reportDriver(const view::ContextChoice& choice);

/// The modules that were built, as the choices that name them: Osmesa, Egl.
[[nodiscard]] std::vector<view::ContextChoice> builtContexts();

/// The module's entry points, found by these names.
using ContextsEntry = void (*)(std::vector<view::ContextChoice>& contexts);
inline constexpr const char* contextsEntryName = "texshotContexts";
using DriverEntry = void (*)(const view::ContextChoice& choice, Result<DriverReport>& report);
inline constexpr const char* driverEntryName = "texshotDriver";

} // namespace texplorer::screenshot
