#include "texplorer/reference/explain/tap_places.h"

#include "texplorer/reference/explain/sampling_steps.h"
#include "texplorer/reference/sampling/ellipse.h"
#include "texplorer/reference/sampling/texel.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace texplorer::reference {

namespace {

/// The copy of texel `index` that is nearest to `place`, both in texels; copies lie `period` apart.
int nearestCopy(float index, float place, float period) {
    return static_cast<int>(index + std::round((place - 0.5F - index) / period) * period);
}

/// Of the texels that wrapping makes `index` of, the one nearest to the sample.
int unwrapped(Wrap wrap, int index, float place, int size) {
    const auto n = static_cast<float>(size);
    if (std::abs(place) > 1e6F || index < 0 || index >= size)
        return index;
    const auto i = static_cast<float>(index);
    if (wrap == Wrap::Repeat)
        return nearestCopy(i, place, n);
    if (wrap != Wrap::MirroredRepeat)
        return index;
    const int straight = nearestCopy(i, place, 2 * n);
    const int reversed = nearestCopy(2 * n - 1 - i, place, 2 * n);
    const auto far = [&](int at) { return std::abs(static_cast<float>(at) + 0.5F - place); };
    return far(straight) <= far(reversed) ? straight : reversed;
}

glm::vec2 placeIn(const Level& level, glm::vec3 coords) {
    return {definedCoordinate(coords.s) * static_cast<float>(level.width),
            definedCoordinate(coords.t) * static_cast<float>(level.height)};
}

/// Where a picture is sampled: of a cube map, on the face that the direction hits.
glm::vec3 onFace(const SampleRecord& sample, glm::vec3 coords) {
    return sample.cube ? sample.cube->coords : coords;
}
int faceOf(const SampleRecord& sample) {
    return sample.cube ? sample.cube->face : 0;
}

/// A texel of the image around, with what wrapping makes of its surroundings; of a seamless cube map the
/// faces around the one that is hit. Beyond a corner of that, the mean of the three texels that meet there.
glm::vec4 colorAround(const SampledTexture& texture, const LevelPatch& patch, const Level& level,
                      glm::ivec2 at, bool linear) {
    const int axes = axesOf(texture.target);
    if (patch.seamless) {
        const glm::ivec2 within = glm::clamp(at, -level.width, 2 * level.width - 1);
        if (const auto texel = foldedTexel({patch.layer, within}, level.width)) {
            const Level* other = texture.level(patch.level, texel->face);
            return other ? texelAt(*other, glm::ivec3(texel->index, 0), axes) : glm::vec4(0, 0, 0, 1);
        }
        const glm::ivec2 nearest = glm::clamp(at, 0, level.width - 1);
        const glm::ivec2 beside = glm::clamp(at, -1, level.width);
        return (colorAround(texture, patch, level, nearest, linear) +
                colorAround(texture, patch, level, {beside.x, nearest.y}, linear) +
                colorAround(texture, patch, level, {nearest.x, beside.y}, linear)) /
               3.0F;
    }
    const int slice = axes > 2 ? patch.layer : 0; // a face is a level of its own
    // Under a linear filter the neighbour of GL_CLAMP's last texel is the border, as is that of
    // GL_CLAMP_TO_BORDER.
    const auto wrapped = [&](Wrap wrap, int i, int size) {
        return wrappedTexel(wrap == Wrap::Clamp && linear ? Wrap::ClampToBorder : wrap, i, size);
    };
    glm::ivec3 index(wrapped(texture.wrapS, at.x, level.width), 0, slice);
    if (axes > 1)
        index.y = wrapped(texture.wrapT, at.y, level.height);
    return isBeyond(level, index, axes) ? texture.borderColor : texelAt(level, index, axes);
}

LevelPatch patchOf(const SampledTexture& texture, const Level& level, const SampleRecord& sample,
                   glm::vec3 coords, int number) {
    const int axes = std::min(2, axesOf(texture.target));
    LevelPatch patch;
    patch.level = number;
    patch.extent = {level.width, axes > 1 ? level.height : 1};
    patch.place = placeIn(level, onFace(sample, coords));
    if (axes < 2)
        patch.place.y = 0.5F;
    patch.taps = placeTaps(texture, sample, coords, number);
    // Some texels around all taps; where these are too many, around the heaviest.
    glm::ivec2 low = patch.taps.empty() ? glm::ivec2(0) : patch.taps.front().at;
    glm::ivec2 high = low;
    float most = 0;
    for (const PlacedTap& tap : patch.taps) {
        const glm::ivec2 l = glm::min(low, tap.at);
        const glm::ivec2 h = glm::max(high, tap.at);
        if (h.x - l.x < maxPatch - 2 && h.y - l.y < maxPatch - 2) {
            low = l;
            high = h;
        }
        if (tap.tap.weight > most) {
            most = tap.tap.weight;
            patch.layer = tap.tap.index.z;
        }
    }
    if (sample.cube)
        patch.layer = sample.cube->face;
    patch.seamless = sample.seamless;
    constexpr int margin = 1;
    const int side = std::min(maxPatch, std::max(high.x - low.x, high.y - low.y) + 1 + 2 * margin);
    patch.size = {side, axes > 1 ? side : 1};
    patch.low = {(low.x + high.x + 1 - side) / 2, axes > 1 ? (low.y + high.y + 1 - side) / 2 : 0};
    const bool linear = !sample.lod.ellipse && chooseLevels(texture, sample.lod).linear;
    for (int y = 0; y < patch.size.y; ++y) {
        for (int x = 0; x < patch.size.x; ++x)
            patch.colors.push_back(colorAround(texture, patch, level, patch.low + glm::ivec2(x, y), linear));
    }
    return patch;
}

} // namespace

std::vector<PlacedTap> placeTaps(const SampledTexture& texture, const SampleRecord& sample, glm::vec3 coords,
                                 int level) {
    std::vector<PlacedTap> placed;
    const Level* read = texture.level(level, faceOf(sample));
    if (!read)
        return placed;
    const glm::vec2 place = placeIn(*read, onFace(sample, coords));
    for (const Tap& tap : mergedTaps(sample)) {
        if (tap.level != level)
            continue;
        PlacedTap each{tap, glm::ivec2(tap.index)};
        if (sample.cube && sample.cube->face != tap.index.z) {
            each.at = unfoldedTexel({tap.index.z, each.at}, sample.cube->face, read->width).value_or(each.at);
            placed.push_back(each);
            continue;
        }
        each.at.x = unwrapped(texture.wrapS, tap.index.x, place.x, read->width);
        if (axesOf(texture.target) > 1)
            each.at.y = unwrapped(texture.wrapT, tap.index.y, place.y, read->height);
        placed.push_back(each);
    }
    return placed;
}

std::vector<LevelPatch> levelPatches(const SampledTexture& texture, const SampleRecord& sample,
                                     glm::vec3 coords) {
    std::vector<LevelPatch> patches;
    for (const LevelShare& share : sample.levels) {
        const Level* level = texture.level(share.level, faceOf(sample));
        if (level && share.weight > 0)
            patches.push_back(patchOf(texture, *level, sample, coords, share.level));
    }
    return patches;
}

} // namespace texplorer::reference
