#include "texplorer/reference/sampling/fast_sampler.h"

#include "texplorer/reference/sampling/sampler.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace texplorer::reference {

FastSampler::FastSampler(const SampledTexture& sampled, const SampleOptions& sampling)
    : texture(&sampled)
    , options(sampling) {
    const bool flat = sampled.target == Target::Texture1D || sampled.target == Target::Texture2D;
    const bool anisotropic = sampled.maxAnisotropy > 1;
    const bool ownMethod =
        anisotropic && sampling.anisotropy != AnisotropyMethod::Probes && sampled.target == Target::Texture2D;
    const int steps = wantsMipmaps(sampled.minFilter) ? lastMipLevel(sampled) - sampled.baseLevel : 0;
    if (!flat || ownMethod || steps >= maxLevels || isDepth(sampled.internalFormat))
        return;
    for (int step = 0; step <= steps; ++step) {
        const Level* level = sampled.level(sampled.baseLevel + step);
        if (!level || level->border != 0)
            return;
        planes[static_cast<std::size_t>(step)] = {level->texels.data(),
                                                  level->bytes.empty() ? nullptr : level->bytes.data(),
                                                  level->width,
                                                  level->height,
                                                  static_cast<float>(level->width),
                                                  static_cast<float>(level->height)};
    }
    lastStep = static_cast<float>(steps);
    bias = lodBias(sampled, sampling);
    switchOver = sampling.zeroSwitchOver ? 0 : switchOverOf(sampled.magFilter, sampled.minFilter);
    if (bias > 32) // no GL allows it; the kernel takes it for granted that tiny footprints are magnified
        return;
    maxProbes = anisotropic ? std::min(std::floor(sampled.maxAnisotropy), 1024.0F) : 1.0F;
    readsR = false;
    readsDerivatives = anisotropic || wantsMipmaps(sampled.minFilter) ||
                       (sampled.magFilter == MagFilter::Linear) != isLinear(sampled.minFilter);
    const bool oneAxis = sampled.target == Target::Texture1D;
    if (readsDerivatives)
        kind = oneAxis ? Kind::LevelsOfOneAxis : Kind::LevelsOfTwoAxes;
    else
        kind = oneAxis ? Kind::BaseOfOneAxis : Kind::BaseOfTwoAxes;
}

void sampleLiterally(const FastSampler& sampler, const SampleRow& row, int first, int count,
                     glm::vec4* colors) {
    for (int i = 0; i < count; ++i) {
        const auto at = static_cast<std::size_t>(first + i);
        colors[i] =
            sample(*sampler.texture, {row.s[at], row.t[at], row.r[at]},
                   {{row.dsdx[at], row.dtdx[at], row.drdx[at]}, {row.dsdy[at], row.dtdy[at], row.drdy[at]}},
                   sampler.options);
    }
}

} // namespace texplorer::reference
