#pragma once

// Which levels of a texture the pixels of a picture read, and how long their footprints are.

#include "core/reference/draw.h"
#include "core/reference/sampling/texture_store.h"
#include "core/scene/sampler_state.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace texplorer::reference {

/// A texture unit of a pass.
struct LevelQuestion {
    int pass = 0;
    int unit = 0;

    bool operator==(const LevelQuestion&) const = default;
};

/// Of one pixel.
struct PixelLevels {
    float lambda = std::numeric_limits<float>::quiet_NaN(); ///< NaN: the unit sampled nothing there
    float ratio = 1; ///< how many times as long as wide the footprint is; infinite where it has no width
    float share = 0; ///< of `second`
    std::uint8_t first = 0; ///< the level that was read, or the larger one of two
    std::uint8_t second = 0;
    std::uint16_t samples = 1; ///< along the footprint: above 1 where the filter is anisotropic

    [[nodiscard]] bool isSampled() const { return lambda == lambda; }
};

/// What one unit sampled at each pixel of a picture, in the last fragment of its pass that was drawn there.
struct LevelMap {
    int width = 0;
    int height = 0;
    std::vector<PixelLevels> pixels;   ///< bottom row first
    SamplerState sampler;              ///< of the unit's texture, its levels kept to those that there are
    int lastLevel = 0;                 ///< q: the last one that minification can use
    bool zeroSwitchOver = false;       ///< see SampleOptions
    std::vector<std::string> problems; ///< sentences: what could not be drawn

    /// nullptr: outside of the picture, or nothing was sampled there.
    [[nodiscard]] const PixelLevels* at(int x, int y) const;
    [[nodiscard]] bool isMagnified(const PixelLevels& pixel) const;
};

/// Errors: OutOfRange for a bad size, or where the pass or the unit does not exist; Unsupported where the
/// unit samples nothing; TooLarge without memory; Cancelled after a stop request.
[[nodiscard]] Result<LevelMap> levelMap(const DrawRequest& request, const LevelQuestion& question,
                                        const DrawOptions& options = {});

/// For a caller that keeps a TextureStore.
[[nodiscard]] Result<LevelMap> findLevels(const DrawRequest& request, const LevelQuestion& question,
                                          const DrawOptions& options, TextureStore& textures);

/// "λ = 1.37: 63 % of level 1, 37 % of level 2".
[[nodiscard]] std::string levelsText(const LevelMap& map, const PixelLevels& pixel);

/// "footprint 5.3 : 1, 6 samples along it".
[[nodiscard]] std::string footprintText(const PixelLevels& pixel);

} // namespace texplorer::reference
