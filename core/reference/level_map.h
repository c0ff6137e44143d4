#pragma once

// The levels of a texture that the pixels of a picture read, and the shapes of their footprints.

#include "texplorer/base/sentence.h"
#include "texplorer/reference/draw.h"
#include "texplorer/reference/sampling/texture_store.h"
#include "texplorer/scene/sampler_state.h"

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

/// The levels of one pixel.
struct PixelLevels {
    float lambda = std::numeric_limits<float>::quiet_NaN(); ///< NaN: the unit sampled nothing
    float ratio = 1;        ///< length to width of the footprint; infinite for width 0
    float share = 0;        ///< of `second`
    std::uint8_t first = 0; ///< the level that is read, or the larger of two
    std::uint8_t second = 0;
    std::uint16_t samples = 1; ///< along the footprint: above 1 for anisotropic filters

    [[nodiscard]] bool isSampled() const { return lambda == lambda; }
};

/// What a unit sampled at each pixel of a picture, in the last drawn fragment of its pass.
struct LevelMap {
    int width = 0;
    int height = 0;
    std::vector<PixelLevels> pixels; ///< bottom row first
    SamplerState sampler;            ///< of the unit's texture, with level numbers clamped to existing ones
    int lastLevel = 0;               ///< q: the last level that minification can use
    bool zeroSwitchOver = false;     ///< see SampleOptions
    std::vector<Sentence> problems;  ///< sentences about what could not be drawn

    /// nullptr: outside of the picture, or nothing was sampled.
    [[nodiscard]] const PixelLevels* at(int x, int y) const;
    [[nodiscard]] bool isMagnified(const PixelLevels& pixel) const;
};

/// Errors: OutOfRange for an invalid size, or if the pass or the unit does not exist; Unsupported if the unit
/// samples nothing; TooLarge without memory; Cancelled after a stop request.
[[nodiscard]] Result<LevelMap> levelMap(const DrawRequest& request, const LevelQuestion& question,
                                        const DrawOptions& options = {});

/// For a caller with a TextureStore.
[[nodiscard]] Result<LevelMap> findLevels(const DrawRequest& request, const LevelQuestion& question,
                                          const DrawOptions& options, TextureStore& textures);

/// "λ = 1.37: 63 % of level 1, 37 % of level 2".
[[nodiscard]] Sentence levelsText(const LevelMap& map, const PixelLevels& pixel);

/// "footprint 5.3 : 1, 6 samples along it".
[[nodiscard]] Sentence footprintText(const PixelLevels& pixel);

} // namespace texplorer::reference
