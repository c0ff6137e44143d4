#pragma once

#include "texplorer/reference/sampling/lod.h"

#include <array>
#include <cstdint>

namespace texplorer::reference {

/// Positions that are sampled together: adjacent pixels of a row, with similar footprints.
struct SampleRow {
    static constexpr int capacity = 32;
    using Numbers = std::array<float, capacity>;

    Numbers s;
    Numbers t;
    Numbers r;
    Numbers dsdx;
    Numbers dtdx;
    Numbers drdx;
    Numbers dsdy;
    Numbers dtdy;
    Numbers drdy;
};

/// A texture with a unit's options, prepared for sampling many positions. The texture must outlive it and
/// stay unchanged.
struct FastSampler {
    /// The kind of sampling: one or several levels of a texture with one or two axes. Other cases use the
    /// literal sampler.
    enum class Kind : std::uint8_t {
        Literal,
        BaseOfOneAxis,
        BaseOfTwoAxes,
        LevelsOfOneAxis,
        LevelsOfTwoAxes,
    };

    /// A level in the form in which it is read.
    struct Plane {
        const glm::vec4* texels = nullptr;
        const std::int32_t* bytes = nullptr; ///< the same as bytes, if the level has them
        int width = 1;
        int height = 1;
        float fWidth = 1;
        float fHeight = 1;
    };

    static constexpr int maxLevels = 16;

    const SampledTexture* texture = nullptr;
    SampleOptions options{};
    Kind kind = Kind::Literal;
    bool readsR = true; ///< of a SampleRow: r and its derivatives
    bool readsDerivatives = true;
    std::array<Plane, maxLevels> planes{}; ///< from the base level on
    float lastStep = 0;                    ///< the last level that minification uses
    float bias = 0;
    float switchOver = 0;
    float maxProbes = 1;

    FastSampler() = default;
    FastSampler(const SampledTexture& texture, const SampleOptions& options);
};

/// Calls sample() of sampler.h for `count` positions from `first` on.
void sampleLiterally(const FastSampler& sampler, const SampleRow& row, int first, int count,
                     glm::vec4* colors);

} // namespace texplorer::reference
