#pragma once

#include "core/reference/sampling/lod.h"

#include <array>
#include <cstdint>

namespace texplorer::reference {

/// Places that are sampled together: neighbours in a row of pixels, whose footprints are much alike.
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

/// A texture and the options of a unit, made ready once for sampling many places. The texture must outlive
/// it, unchanged.
struct FastSampler {
    /// What is to be done for a place: one level or several, of a texture with one axis or two. The rest is
    /// left to the literal sampler.
    enum class Kind : std::uint8_t {
        Literal,
        BaseOfOneAxis,
        BaseOfTwoAxes,
        LevelsOfOneAxis,
        LevelsOfTwoAxes,
    };

    /// A level as it is read.
    struct Plane {
        const glm::vec4* texels = nullptr;
        const std::int32_t* bytes = nullptr; ///< the same, where the level has them
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
    float lastStep = 0;                    ///< the last of them that minification uses
    float bias = 0;
    float switchOver = 0;
    float maxProbes = 1;

    FastSampler() = default;
    FastSampler(const SampledTexture& texture, const SampleOptions& options);
};

/// sample() of sampler.h for `count` places from `first` on.
void sampleLiterally(const FastSampler& sampler, const SampleRow& row, int first, int count,
                     glm::vec4* colors);

} // namespace texplorer::reference
