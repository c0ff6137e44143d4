#include "texplorer/conform/lambda_range.h"

#include "texplorer/reference/probe.h"
#include "texplorer/reference/sampling/cube.h"
#include "texplorer/reference/shading/fragment.h"
#include "texplorer/reference/shading/stored_color.h"
#include "texplorer/texture/image_source.h"
#include "texplorer/texture/level_plan.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace texplorer::conform {

namespace {

constexpr float lambdaError = 1.0F / 64; // dEQP: lodBits = 6

/// Texture coordinates anywhere in the plane of a triangle, from its corners. A line's change along it alone:
/// a third corner with the coordinates of the first lies across it. A point's don't change.
class CoordinatePlane {
public:
    CoordinatePlane(const reference::Explanation& pixel, const reference::FragmentExplanation& fragment,
                    const reference::UnitExplanation& unit) {
        const std::size_t corners = std::min<std::size_t>(fragment.vertices.size(), 3);
        for (std::size_t i = 0; i < corners; ++i) {
            const glm::dvec4 clip(fragment.vertices[i].clip);
            window_[i] = {(clip.x / clip.w + 1) / 2 * pixel.width - 0.5,
                          (clip.y / clip.w + 1) / 2 * pixel.height - 0.5};
            overW_[i] = glm::dvec4(unit.vertices[i].transformed) / clip.w;
        }
        if (corners == 1) {
            window_[1] = window_[0] + glm::dvec2(1, 0);
            overW_[1] = overW_[0];
        }
        if (corners < 3) {
            const glm::dvec2 along = window_[1] - window_[0];
            window_[2] = window_[0] + glm::dvec2(-along.y, along.x);
            overW_[2] = overW_[0];
        }
    }

    /// s / q, t / q and r / q at the centre of a pixel.
    [[nodiscard]] glm::dvec3 at(glm::dvec2 place) const {
        // Both a coordinate and q are planes over the window once they are divided by w, which so cancels
        // out.
        const double area = cross(window_[1] - window_[0], window_[2] - window_[0]);
        const double b = cross(place - window_[0], window_[2] - window_[0]) / area;
        const double c = cross(window_[1] - window_[0], place - window_[0]) / area;
        const glm::dvec4 sum = overW_[0] * (1 - b - c) + overW_[1] * b + overW_[2] * c;
        return glm::dvec3(sum) / sum.w;
    }

private:
    static double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

    std::array<glm::dvec2, 3> window_{};
    std::array<glm::dvec4, 3> overW_{};
};

/// As lod.cpp has it, of other derivatives.
double rhoOf(const reference::UnitExplanation& unit, reference::RhoMethod method,
             const reference::Derivatives& derivatives, glm::vec3 baseSize) {
    const int axes = axesOf(unit.target);
    if (std::floor(unit.sampler.maxAnisotropy) <= 1)
        return reference::rhoBy(method, derivatives, baseSize, axes);
    glm::vec3 size(0); // axes that the target doesn't have say nothing
    for (int axis = 0; axis < axes; ++axis)
        size[axis] = baseSize[axis];
    const double alongX = glm::length(derivatives.dx * size);
    const double alongY = glm::length(derivatives.dy * size);
    const double longer = std::max(alongX, alongY);
    const reference::Lod& lod = unit.sample.lod;
    return lod.ellipse || lod.line ? reference::rhoOfOneLevel(lod.line, longer, std::min(alongX, alongY),
                                                              std::floor(unit.sampler.maxAnisotropy))
                                   : longer;
}

/// The line through log2 at the powers of two.
float log2OfBits(float value) {
    int exponent = 0;
    const float mantissa = std::frexp(value, &exponent); // 0.5 to 1
    return static_cast<float>(exponent - 1) + (2 * mantissa - 1);
}

} // namespace

glm::vec3 baseSizeOf(const Texture& texture, Target target, const ImageSource& images) {
    const LevelPlan plan = planLevels(texture, images.picturesOf(texture), target);
    for (const PlannedLevel& level : plan.levels) {
        if (level.number == texture.baseLevel)
            return {level.width, level.height, level.depth};
    }
    return {1, 1, 1};
}

LambdaRange lambdaRange(const reference::Explanation& pixel, const reference::FragmentExplanation& fragment,
                        const reference::UnitExplanation& unit, glm::vec3 baseSize, RhoMethods methods) {
    const CoordinatePlane plane(pixel, fragment, unit);
    const glm::dvec2 corner(pixel.pixel.x & ~1, pixel.pixel.y & ~1);
    const auto coords = [&](glm::dvec2 place) {
        const glm::dvec3 given = plane.at(place);
        if (unit.target != Target::CubeMap)
            return given;
        return glm::dvec3(reference::cubePlace(glm::vec3(given), {}).coords); // on the face
    };
    const glm::dvec3 here = coords(corner);
    const glm::dvec3 above = coords(corner + glm::dvec2(0, 1));
    const std::array<reference::Derivatives, 2> ofQuad{
        // by either of its rows
        reference::Derivatives{coords(corner + glm::dvec2(1, 0)) - here, above - here},
        reference::Derivatives{coords(corner + glm::dvec2(1, 1)) - above, above - here}};
    const reference::Derivatives& ofPixel =
        unit.sample.cube ? unit.sample.cube->derivatives : unit.derivatives;
    LambdaRange range{-lambdaError, lambdaError};
    const auto reach = [&](float lambda) {
        range.low = std::min(range.low, lambda - unit.sample.lod.base - lambdaError);
        range.high = std::max(range.high, lambda - unit.sample.lod.base + lambdaError);
    };
    for (const reference::RhoMethod method : methods) {
        for (const reference::Derivatives& derivatives : ofQuad) {
            const double rho = rhoOf(unit, method, derivatives, baseSize);
            const auto squared = static_cast<float>(rho * rho);
            if (!std::isfinite(squared) || squared <= 0 || !std::isfinite(unit.sample.lod.base))
                continue;
            reach(std::log2(squared) / 2);
            reach(log2OfBits(squared) / 2);
        }
        const double exact = rhoOf(unit, method, ofPixel, baseSize);
        if (exact > 0 && std::isfinite(exact) && std::isfinite(unit.sample.lod.base) &&
            method != unit.sample.lod.method)
            reach(static_cast<float>(std::log2(exact)));
    }
    return range;
}

namespace {

using reference::Explanation;
using reference::FragmentExplanation;
using reference::FragmentOutcome;
using reference::PixelBytes;

/// Fragments whose range is asked for, from the last one on, and colours that are kept of them all.
constexpr std::size_t maxFragments = 8;
constexpr std::size_t maxColors = 256;

/// The scene with the bias of a fragment's units moved to a place of their ranges.
reference::DrawRequest biased(const reference::DrawRequest& request, const Explanation& pixel,
                              const FragmentExplanation& fragment, RhoMethods methods, float place) {
    reference::DrawRequest moved = request;
    for (const reference::UnitExplanation& unit : fragment.units) {
        const Texture& texture = request.scene.textures[static_cast<std::size_t>(unit.texture)];
        const LambdaRange range =
            lambdaRange(pixel, fragment, unit, baseSizeOf(texture, unit.target, request.images), methods);
        moved.scene.passes[static_cast<std::size_t>(fragment.pass)]
            .units[static_cast<std::size_t>(unit.unit)]
            .lodBias += std::lerp(range.low, range.high, place);
    }
    return moved;
}

/// What the framebuffer holds after a fragment of this colour.
PixelBytes drawnOver(const PixelBytes& before, const FragmentExplanation& fragment, glm::vec4 color) {
    const auto& alpha = fragment.alphaTest;
    if (alpha.enabled && !reference::passes(alpha.function, color.a, alpha.with))
        return before;
    const auto bytes = [](const PixelBytes& pixel) {
        return reference::colorOf(reinterpret_cast<const std::byte*>(pixel.data()));
    };
    if (fragment.blend.enabled)
        color = reference::blend(fragment.blend.sourceFactor, fragment.blend.destinationFactor, color,
                                 bytes(before));
    PixelBytes after{};
    reference::store(color, reinterpret_cast<std::byte*>(after.data()));
    return after;
}

/// Whether nothing of what was there before shows through.
bool covers(const FragmentExplanation& fragment) {
    return fragment.outcome == FragmentOutcome::Drawn && !fragment.blend.enabled &&
           !fragment.alphaTest.enabled;
}

} // namespace

Result<std::vector<PixelBytes>> colorsOverLambda(reference::ReferenceRenderer& renderer,
                                                 const reference::DrawRequest& request,
                                                 reference::PixelPlace pixel, RhoMethods methods,
                                                 const reference::DrawOptions& options) {
    const Result<Explanation> exact = renderer.probe(request, pixel, options);
    if (!exact)
        return fail(exact.error());
    const std::vector<FragmentExplanation>& fragments = exact->fragments;
    const int steps = methods.size() == 1 ? 4 : 12; // from one end of the range to the other
    std::size_t first = fragments.size();
    for (std::size_t count = 0; first > 0 && count < maxFragments; ++count) {
        if (covers(fragments[--first]))
            break;
    }
    if (first == fragments.size())
        return std::vector{exact->bytes};
    // Each fragment is off by an amount of its own: all that they may be, one over the other.
    std::vector<PixelBytes> colors{fragments[first].before};
    for (std::size_t f = first; f < fragments.size(); ++f) {
        if (fragments[f].outcome == FragmentOutcome::FailedDepthTest)
            continue;
        std::vector<glm::vec4> own;
        for (int step = 0; step <= steps; ++step) {
            const float place = static_cast<float>(step) / static_cast<float>(steps);
            const Result<Explanation> found =
                renderer.probe(biased(request, *exact, fragments[f], methods, place), pixel, options);
            if (!found)
                return fail(found.error());
            own.push_back(found->fragments[f].color);
        }
        std::vector<PixelBytes> after;
        for (const PixelBytes& before : colors) {
            for (const glm::vec4& color : own)
                after.push_back(drawnOver(before, fragments[f], color));
        }
        std::ranges::sort(after);
        after.erase(std::ranges::unique(after).begin(), after.end());
        const std::size_t step = after.size() / maxColors + 1;
        colors.clear();
        for (std::size_t i = 0; i < after.size(); i += step)
            colors.push_back(after[i]);
        colors.push_back(after.back());
    }
    return colors;
}

} // namespace texplorer::conform
