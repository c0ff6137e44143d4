#include "texplorer/reference/explain/ties.h"

#include "texplorer/reference/sampling/sampler.h"
#include "texplorer/reference/sampling/wrap.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace texplorer::reference {

namespace {

constexpr float coordinateSlack = 1e-5F;
constexpr float lambdaSlack = 1.0F / 64;
constexpr float timesAsFar = 2; ///< lies the other answer
constexpr std::size_t maxOthers = 16;

/// By how much a coordinate may be off.
float slackOf(float coordinate) {
    return coordinateSlack * std::max(1.0F, std::abs(coordinate));
}

/// Coordinates on a face are half of a direction's components over the largest.
constexpr float faceShare = 0.5F;

float largestOf(glm::vec3 direction) {
    const glm::vec3 sizes = glm::abs(direction);
    return std::max({sizes.x, sizes.y, sizes.z});
}

std::optional<Tie> texelTie(const WrappedCoordinate& each, int size) {
    constexpr float farthest = 0.25F; // texels: coordinates without a fraction are no tie, they are undefined
    const float slack = std::min(slackOf(each.given), farthest / static_cast<float>(size));
    const int chosen = nearestTexel(each.texels, size);
    for (const float moved : {each.given - slack, each.given + slack}) {
        const int other = nearestTexel(wrapCoordinate(each.wrap, moved, size), size);
        if (other != chosen)
            return Tie{Tie::Between::Texels, chosen, other, each.level, each.axis};
    }
    return std::nullopt;
}

std::optional<Tie> levelTie(const SampledTexture& texture, const Lod& lod) {
    if (lod.undefined)
        return std::nullopt;
    const LevelChoice chosen = chooseLevels(texture, lod);
    const bool blends = !lod.magnified && blendsLevels(texture.minFilter) && !lod.ellipse && !lod.line;
    for (const float by : {-lambdaSlack, lambdaSlack}) {
        Lod moved = lod;
        moved.lambda = std::min(std::max(lod.biased + by, texture.minLod), texture.maxLod);
        moved.magnified = !(moved.lambda > lod.switchOver);
        const LevelChoice other = chooseLevels(texture, moved);
        if (moved.magnified != lod.magnified && other.linear != chosen.linear)
            return Tie{Tie::Between::Filters, chosen.first, other.first};
        if (moved.magnified == lod.magnified && !blends && other.first != chosen.first)
            return Tie{Tie::Between::Levels, chosen.first, other.first};
    }
    return std::nullopt;
}

std::optional<Tie> faceTie(glm::vec3 direction) {
    const float length = largestOf(direction);
    const int chosen = cubePlace(direction, {}).face;
    for (int axis = 0; axis < 3; ++axis) {
        glm::vec3 moved = direction;
        moved[axis] *= 1 + timesAsFar * coordinateSlack;
        if (std::abs(direction[axis]) < length * (1 - coordinateSlack))
            continue;
        if (const int other = cubePlace(moved, {}).face; other != chosen)
            return Tie{Tie::Between::Faces, chosen, other};
    }
    return std::nullopt;
}

bool isSameTexel(const Tap& one, const Tap& other) {
    return one.level == other.level && one.index == other.index;
}

} // namespace

Ties tiesOf(const SampledTexture& texture, glm::vec3 coords, const Derivatives& derivatives,
            const SampleOptions& options, const SampleRecord& sample) {
    Ties found;
    const auto add = [&](const std::optional<Tie>& tie) {
        if (tie && std::ranges::find(found.ties, *tie) == found.ties.end())
            found.ties.push_back(*tie);
    };
    const bool linear = chooseLevels(texture, sample.lod).linear || sample.lod.ellipse;
    if (sample.cube && !(linear && sample.seamless)) // from face to face a seamless filter blends
        add(faceTie(coords));
    add(levelTie(texture, sample.lod));
    for (const WrappedCoordinate& each : sample.wrapped) {
        const Level* level = texture.level(each.level);
        if (!linear && level && std::isfinite(each.given))
            add(texelTie(each, level->size()[each.axis]));
    }
    if (found.ties.empty())
        return found;
    const auto isKnown = [](const std::vector<Tap>& taps, const Tap& tap) {
        return std::ranges::any_of(taps, [&](const Tap& each) { return isSameTexel(each, tap); });
    };
    for (const glm::vec4& signs : roundingsOf(tiedIn(found.ties, texture.target))) {
        const SampleRecord other = explainSample(texture, rounded(texture.target, coords, signs), derivatives,
                                                 rounded(options, signs));
        for (const Tap& tap : other.taps)
            if (found.others.size() < maxOthers && tap.weight > 0 && !isKnown(sample.taps, tap) &&
                !isKnown(found.others, tap))
                found.others.push_back(tap);
    }
    return found;
}

glm::bvec4 tiedIn(const std::vector<Tie>& ties, Target target) {
    glm::bvec4 tied(false);
    for (const Tie& tie : ties) {
        if (tie.between == Tie::Between::Levels || tie.between == Tie::Between::Filters)
            tied.w = true;
        else if (target == Target::CubeMap)
            tied = glm::bvec4(true, true, true, tied.w);
        else
            tied[tie.axis] = true;
    }
    return tied;
}

std::vector<glm::vec4> roundingsOf(glm::bvec4 tied) {
    std::vector<glm::vec4> roundings{glm::vec4(0)};
    for (int axis = 0; axis < 4; ++axis) {
        if (!tied[axis])
            continue;
        const std::size_t count = roundings.size();
        for (std::size_t i = 0; i < count; ++i) {
            roundings[i][axis] = -1;
            glm::vec4 up = roundings[i];
            up[axis] = 1;
            roundings.push_back(up);
        }
    }
    return roundings;
}

glm::vec3 rounded(Target target, glm::vec3 coords, glm::vec4 signs) {
    for (int axis = 0; axis < 3; ++axis) {
        if (signs[axis] == 0)
            continue;
        const float slack = target == Target::CubeMap ? coordinateSlack * largestOf(coords) / faceShare
                                                      : slackOf(coords[axis]);
        coords[axis] += signs[axis] * timesAsFar * slack;
    }
    return coords;
}

SampleOptions rounded(SampleOptions options, glm::vec4 signs) {
    options.shaderBias += signs.w * timesAsFar * lambdaSlack;
    return options;
}

} // namespace texplorer::reference
