#pragma once

#include "texplorer/diagnosis/diagnosis.h"
#include "texplorer/diagnosis/visited_texels.h"
#include "texplorer/reference/sampling/completeness.h"
#include "texplorer/reference/sampling/lod.h"
#include "texplorer/scene/scene.h"

#include <optional>
#include <span>
#include <string_view>

namespace texplorer {

/// A flaw of a driver that crashes it or gives a wrong picture, and what is used instead.
struct DriverFlaw {
    std::string_view driver;                           ///< the beginning of its GL_RENDERER
    std::optional<reference::AnisotropyMethod> method; ///< only where the driver filters so; otherwise always
    /// `use`: nullptr if nothing is drawn.
    bool (*meets)(const Texture& texture, const reference::SampledTexture& shape, const TextureUse* use);
    void (*avoid)(Texture& texture);
    std::string_view sentence; ///< what is drawn differently, and why; empty: no pixel changes
};

[[nodiscard]] std::span<const DriverFlaw> driverFlaws();

/// The parameters of a texture object as given to a driver: only existing levels, and nothing that crashes
/// it.
struct AppliedTexture {
    Texture texture;
    reference::Completeness completeness; ///< an incomplete texture is not bound
    std::vector<std::string_view> heldBack;
};

/// `shape` has the extents of the levels (reference::shapeOf), `lastLevel` is that of TextureLevels. Of the
/// driver, only its name and version are used. `use`: the frame to draw.
[[nodiscard]] AppliedTexture appliedTexture(const Texture& texture, reference::SampledTexture shape,
                                            int lastLevel, const DriverFacts& driver,
                                            const TextureUse* use = nullptr);

} // namespace texplorer
