#pragma once

#include "core/diagnosis/diagnosis.h"
#include "core/reference/sampling/completeness.h"
#include "core/scene/scene.h"

#include <span>
#include <string_view>

namespace texplorer {

/// Something that a driver doesn't survive, and what it is given instead.
struct DriverFlaw {
    std::string_view driver; ///< how its GL_RENDERER begins
    bool (*meets)(const Texture& texture, const reference::SampledTexture& shape);
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
/// driver its name counts alone.
[[nodiscard]] AppliedTexture appliedTexture(const Texture& texture, reference::SampledTexture shape,
                                            int lastLevel, const DriverFacts& driver);

} // namespace texplorer
