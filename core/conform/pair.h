#pragma once

// Which renderers are compared, on which driver.

#include "texplorer/diagnosis/diagnosis.h"
#include "texplorer/reference/sampling/lod.h"
#include "texplorer/scene/renderer.h"

#include <array>
#include <string>

namespace texplorer::conform {

struct Pair {
    RendererKind subject;
    RendererKind against;

    [[nodiscard]] bool has(RendererKind kind) const { return subject == kind || against == kind; }
    bool operator==(const Pair&) const = default;
};

/// Fixed function is compared with both others; their agreement with each other follows from that.
inline constexpr std::array defaultPairs{Pair{RendererKind::Shader, RendererKind::Fixed},
                                         Pair{RendererKind::Reference, RendererKind::Fixed}};

/// The OpenGL implementation.
struct Driver {
    std::string name; ///< GL_RENDERER: "llvmpipe (LLVM 15.0.6, 256 bits)"; empty if none is needed
    std::string version;
    std::string settings; ///< environment variables that change its precision: "GALLIVM_PERF=…"
    DriverFacts facts{};

    [[nodiscard]] reference::AnisotropyMethod anisotropy() const {
        return reference::anisotropyMethodOf(name, version);
    }
};

} // namespace texplorer::conform
