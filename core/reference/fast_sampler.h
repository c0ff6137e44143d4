#pragma once

// Texture filtering for a whole picture: the same numbers as sampler.h, which is the text to read, several
// pixels at a time. Every colour is equal to sample()'s, bit for bit: the same operations in the same order,
// but nothing is computed that the parameters leave without effect.

#include "core/reference/lod.h"

#include <array>

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

/// A texture and the options of a unit, made ready once. The texture must outlive it, unchanged.
class FastSampler {
public:
    FastSampler() = default;
    FastSampler(const SampledTexture& texture, const SampleOptions& options);

    /// Which members of a SampleRow are read: r and its derivatives, and derivatives at all.
    [[nodiscard]] bool readsR() const { return readsR_; }
    [[nodiscard]] bool readsDerivatives() const { return readsDerivatives_; }

    /// The colours of the first `count` places (at most SampleRow::capacity). Room for as many, rounded up to
    /// a multiple of 4.
    void operator()(const SampleRow& row, int count, glm::vec4* colors) const {
        sample_(*this, row, count, colors);
    }

private:
    template<int axes>
    class Quartet; // fast_sampler.cpp

    /// A level as it is read.
    struct Plane {
        const glm::vec4* texels = nullptr;
        int width = 1;
        int height = 1;
        float fWidth = 1;
        float fHeight = 1;
    };

    using Function = void (*)(const FastSampler&, const SampleRow&, int count, glm::vec4* colors);
    static void literally(const FastSampler& sampler, const SampleRow& row, int count, glm::vec4* colors);
    template<int axes, bool baseOnly>
    static void quickly(const FastSampler& sampler, const SampleRow& row, int count, glm::vec4* colors);

    const SampledTexture* texture_ = nullptr;
    SampleOptions options_{};
    Function sample_ = literally;
    bool readsR_ = true;
    bool readsDerivatives_ = true;

    static constexpr int maxLevels = 16;
    std::array<Plane, maxLevels> planes_{}; ///< from the base level on
    float lastStep_ = 0;                    ///< the last of them that minification uses
    float bias_ = 0;
    float switchOver_ = 0;
    float maxProbes_ = 1;
};

} // namespace texplorer::reference
