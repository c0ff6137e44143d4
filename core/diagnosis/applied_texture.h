#pragma once

#include "core/diagnosis/diagnosis.h"
#include "core/diagnosis/visited_texels.h"
#include "core/reference/sampling/completeness.h"
#include "core/scene/scene.h"

#include <span>
#include <string_view>

namespace texplorer {

/// Something that a driver doesn't survive or doesn't do, and what it is given instead.
struct DriverFlaw {
    std::string_view driver; ///< how its GL_RENDERER begins
    /// `use`: nullptr where nothing is drawn.
    bool (*meets)(const Texture& texture, const reference::SampledTexture& shape, const TextureUse* use);
    void (*avoid)(Texture& texture);
    std::string_view sentence; ///< what is drawn otherwise and why; empty: no pixel changes
};

[[nodiscard]] std::span<const DriverFlaw> driverFlaws();

/// The parameters of a texture object as a driver is given them: never a level that isn't there, and nothing
/// that it doesn't survive.
struct AppliedTexture {
    Texture texture;
    reference::Completeness completeness; ///< where it is not complete, the texture is not bound
    std::vector<std::string_view> heldBack;
};

/// `shape` has the extents of the levels (reference::shapeOf), `lastLevel` is that of TextureLevels. Of the
/// driver its name counts alone. `use`: the frame that is drawn with it.
[[nodiscard]] AppliedTexture appliedTexture(const Texture& texture, reference::SampledTexture shape,
                                            int lastLevel, const DriverFacts& driver,
                                            const TextureUse* use = nullptr);

} // namespace texplorer
