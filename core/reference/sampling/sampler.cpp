#include "texplorer/reference/sampling/sampler.h"

#include "texplorer/reference/sampling/depth_texel.h"
#include "texplorer/reference/sampling/ellipse.h"
#include "texplorer/reference/sampling/texel.h"
#include "texplorer/reference/sampling/wrap.h"

#include <glm/common.hpp>

#include <array>

namespace texplorer::reference {

namespace {

// A recorder is told of every step. The one that keeps nothing costs nothing.

struct KeepNothing {
    static void lod(const Lod& /*lod*/) {}
    static void cube(const CubePlace& /*place*/, bool /*seamless*/) {}
    static void level(int /*number*/, float /*weight*/) {}
    static void probe(glm::vec3 /*coords*/) {}
    static void wrapped(const WrappedCoordinate& /*coordinate*/) {}
    static void tap(const Tap& /*tap*/) {}
};

struct KeepAll {
    SampleRecord& record;
    void lod(const Lod& lod) const { record.lod = lod; }
    void cube(const CubePlace& place, bool seamless) const {
        record.cube = place;
        record.seamless = seamless;
    }
    void level(int number, float weight) const { record.levels.push_back({number, weight}); }
    void probe(glm::vec3 coords) const { record.probes.push_back(coords); }
    void wrapped(const WrappedCoordinate& coordinate) const { record.wrapped.push_back(coordinate); }
    void tap(const Tap& tap) const { record.taps.push_back(tap); }
};

struct WeighTexel {
    const TexelPlace& texel;
    float& weight;
    static void lod(const Lod& /*lod*/) {}
    static void cube(const CubePlace& /*place*/, bool /*seamless*/) {}
    static void level(int /*number*/, float /*weight*/) {}
    static void probe(glm::vec3 /*coords*/) {}
    static void wrapped(const WrappedCoordinate& /*coordinate*/) {}
    void tap(const Tap& tap) const {
        if (tap.level == texel.level && tap.index == texel.index)
            weight += tap.weight;
    }
};

/// The filters of one level. Section 3.8.8: NEAREST takes tau_ijk, LINEAR the weighted sum of 2, 4 or 8.
template<class Recorder>
class LevelFilter {
public:
    /// `face`: of a cube map, else 0. `seamless`: its other faces lie around it.
    /// `r` is what depths are compared with.
    LevelFilter(const SampledTexture& texture, int face, bool seamless, float r, const Recorder& recorder)
        : texture_(texture)
        , face_(face)
        , r_(r)
        , seamless_(seamless && texture.target == Target::CubeMap)
        , recorder_(recorder) {}

    glm::vec4 operator()(int number, bool linear, glm::vec3 coords, float weight) const {
        const Level* level = texture_.level(number, face_);
        if (!level)
            return {0, 0, 0, 1};
        glm::vec3 uvw(0);
        for (int axis = 0; axis < axes(); ++axis) {
            const Wrap mode = wrap(axis, linear);
            uvw[axis] = wrapCoordinate(mode, coords[axis], level->size()[axis]);
            recorder_.wrapped({number, axis, coords[axis], uvw[axis], mode});
        }
        return linear ? linearly(*level, number, uvw, weight) : nearest(*level, number, uvw, weight);
    }

private:
    [[nodiscard]] int axes() const { return axesOf(texture_.target); }

    /// ARB_seamless_cube_map: always GL_CLAMP_TO_EDGE under NEAREST, always GL_CLAMP_TO_BORDER under LINEAR,
    /// with the texels of other faces in the place of the border.
    [[nodiscard]] Wrap wrap(int axis, bool linear) const {
        if (!seamless_)
            return texture_.wrap(axis);
        return linear ? Wrap::ClampToBorder : Wrap::ClampToEdge;
    }

    glm::vec4 nearest(const Level& level, int number, glm::vec3 uvw, float weight) const {
        glm::ivec3 index(0);
        for (int axis = 0; axis < axes(); ++axis)
            index[axis] = nearestTexel(uvw[axis], level.size()[axis]);
        return read(level, number, index, weight);
    }

    /// Equations 3.22 to 3.24: the corners of a line, square or cube of texel centres.
    glm::vec4 linearly(const Level& level, int number, glm::vec3 uvw, float weight) const {
        std::array<TexelPair, 3> pairs{TexelPair{0, 0, 0}, TexelPair{0, 0, 0}, TexelPair{0, 0, 0}};
        for (int axis = 0; axis < axes(); ++axis)
            pairs[static_cast<std::size_t>(axis)] =
                linearTexels(wrap(axis, true), uvw[axis], level.size()[axis]);
        glm::vec4 sum(0);
        for (int corner = 0; corner < 1 << axes(); ++corner) {
            glm::ivec3 index(0);
            float share = 1;
            for (int axis = 0; axis < axes(); ++axis) {
                const TexelPair& pair = pairs[static_cast<std::size_t>(axis)];
                const bool second = ((corner >> axis) & 1) != 0;
                index[axis] = second ? pair.second : pair.first;
                share *= second ? pair.share : 1 - pair.share;
            }
            sum += share * (seamless_ ? readAround(level, number, index, weight * share)
                                      : read(level, number, index, weight * share));
        }
        return sum;
    }

    /// A texel of this face, or of the one next to it that lies there. Where three faces meet, the mean of
    /// their texels stands for the fourth, as ARB_seamless_cube_map recommends.
    glm::vec4 readAround(const Level& level, int number, glm::ivec3 index, float weight) const {
        if (const auto texel = foldedTexel({face_, glm::ivec2(index)}, level.width))
            return readOfFace(level, number, *texel, weight);
        const glm::ivec3 nearest = glm::clamp(index, 0, level.width - 1);
        glm::vec4 sum(0);
        for (const glm::ivec2 each :
             {glm::ivec2(nearest), glm::ivec2(index.x, nearest.y), glm::ivec2(nearest.x, index.y)})
            sum += readOfFace(level, number, *foldedTexel({face_, each}, level.width), weight / 3);
        return sum / 3.0F;
    }

    glm::vec4 readOfFace(const Level& level, int number, const FaceTexel& texel, float weight) const {
        const Level* other = texture_.level(number, texel.face);
        if (!other || other->size() != level.size())
            return {0, 0, 0, 1};
        return LevelFilter(texture_, texel.face, seamless_, r_, recorder_)
            .read(*other, number, glm::ivec3(texel.index, 0), weight);
    }

    glm::vec4 read(const Level& level, int number, glm::ivec3 index, float weight) const {
        const bool border = isBeyond(level, index, axes());
        const glm::vec4 stored = border ? texture_.borderColor : texelAt(level, index, axes());
        if (texture_.target == Target::CubeMap)
            index.z = face_;
        const glm::vec4 color = isDepth_ ? depthColor(texture_, stored.r, r_) : stored;
        recorder_.tap({number, index, weight, color, border, stored.r});
        return color;
    }

    const SampledTexture& texture_;
    int face_;
    float r_;
    bool seamless_;
    bool isDepth_ = isDepth(texture_.internalFormat);
    const Recorder& recorder_;
};

/// One place: one level, or two that are blended (equation 3.28). For a cube map `coords` is a direction.
template<class Recorder>
glm::vec4 filterLevels(const SampledTexture& texture, const LevelChoice& choice, glm::vec3 coords,
                       bool seamless, float weight, const Recorder& recorder) {
    int face = 0;
    if (texture.target == Target::CubeMap) {
        const CubePlace place = cubePlace(coords, {});
        face = place.face;
        coords = place.coords;
    }
    const LevelFilter<Recorder> filter(texture, face, seamless, coords.p, recorder);
    if (choice.first == choice.second)
        return filter(choice.first, choice.linear, coords, weight);
    const float share = choice.share;
    return (1 - share) * filter(choice.first, choice.linear, coords, weight * (1 - share)) +
           share * filter(choice.second, choice.linear, coords, weight * share);
}

template<class Recorder>
glm::vec4 sampleWith(const SampledTexture& texture, glm::vec3 coords, const Derivatives& derivatives,
                     const SampleOptions& options, const Recorder& recorder) {
    Derivatives onImage = derivatives;
    if (texture.target == Target::CubeMap) {
        const CubePlace place = cubePlace(coords, derivatives);
        recorder.cube(place, options.seamlessCubeMap);
        onImage = place.derivatives;
    }
    const Lod lod = levelOfDetail(texture, onImage, options);
    recorder.lod(lod);
    const LevelChoice choice = chooseLevels(texture, lod);
    // Mesa does this for magnified textures, too.
    if (lod.ellipse && choice.first < lastMipLevel(texture)) {
        recorder.level(choice.first, 1);
        recorder.probe(coords);
        return averageOverEllipse(texture, choice.first, coords, derivatives, recorder);
    }
    recorder.level(choice.first, 1 - choice.share);
    if (choice.second != choice.first)
        recorder.level(choice.second, choice.share);
    if (lod.probes == 1) {
        recorder.probe(coords);
        return filterLevels(texture, choice, coords, options.seamlessCubeMap, 1, recorder);
    }
    // EXT_texture_filter_anisotropic: N samples along the axis in which the footprint is longer, at
    // x - 1/2 + i/(N + 1) for i from 1 to N, with equal weights. Mesa's line has (i - 1/2)/N.
    const glm::vec3 along = lod.alongX ? derivatives.dx : derivatives.dy;
    const auto n = static_cast<float>(lod.probes);
    glm::vec4 sum(0);
    for (int i = 1; i <= lod.probes; ++i) {
        const auto number = static_cast<float>(i);
        glm::vec3 at = coords + along * ((lod.line ? (number - 0.5F) / n : number / (n + 1)) - 0.5F);
        if (isDepth(texture.internalFormat)) // what is compared is the pixel's own
            at.p = coords.p;
        recorder.probe(at);
        sum += filterLevels(texture, choice, at, options.seamlessCubeMap, 1 / n, recorder);
    }
    return sum / n;
}

} // namespace

glm::vec4 sample(const SampledTexture& texture, glm::vec3 coords, const Derivatives& derivatives,
                 const SampleOptions& options) {
    return sampleWith(texture, coords, derivatives, options, KeepNothing{});
}

SampleRecord explainSample(const SampledTexture& texture, glm::vec3 coords, const Derivatives& derivatives,
                           const SampleOptions& options) {
    SampleRecord record;
    record.color = sampleWith(texture, coords, derivatives, options, KeepAll{record});
    return record;
}

float texelWeight(const SampledTexture& texture, glm::vec3 coords, const Derivatives& derivatives,
                  const SampleOptions& options, const TexelPlace& texel) {
    float weight = 0;
    [[maybe_unused]] const glm::vec4 color =
        sampleWith(texture, coords, derivatives, options, WeighTexel{texel, weight});
    return weight;
}

} // namespace texplorer::reference
