#pragma once

// Which renderers are compared, on which driver.

#include "core/diagnosis/diagnosis.h"
#include "core/scene/renderer.h"

#include <array>
#include <string>

namespace texplorer::conform {

struct Pair {
    RendererKind subject;
    RendererKind against;

    [[nodiscard]] bool has(RendererKind kind) const { return subject == kind || against == kind; }
    bool operator==(const Pair&) const = default;
};

/// Fixed function is what the other two are held against: what they make of each other follows.
inline constexpr std::array defaultPairs{Pair{RendererKind::Shader, RendererKind::Fixed},
                                         Pair{RendererKind::Reference, RendererKind::Fixed}};

/// OpenGL as it was found.
struct Driver {
    std::string name; ///< GL_RENDERER: "llvmpipe (LLVM 15.0.6, 256 bits)"; empty where none is needed
    std::string version;
    std::string settings; ///< of the environment, that decide how precisely it draws: "GALLIVM_PERF=…"
    DriverFacts facts{};
};

} // namespace texplorer::conform
