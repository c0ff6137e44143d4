#include "texplorer/conform/judge.h"

#include "texplorer/conform/lambda_range.h"
#include "texplorer/reference/sampling/lod.h"
#include "texplorer/reference/shading/coordinate_reach.h"
#include "texplorer/scene/texture_matrix.h"

#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>

#include <algorithm>

namespace texplorer::conform {

namespace {

using reference::PixelBytes;

/// Of how many pixels one is probed at most: all would take long.
constexpr std::size_t probedOneIn = 32;

constexpr std::array rhoMethods{reference::RhoMethod::Ideal, reference::RhoMethod::Lower,
                                reference::RhoMethod::Upper};

constexpr float texelError = 1.0F / 128;    // dEQP: uvwBits = 7
constexpr float coordinateError = 0x1p-20F; // of a coordinate itself; dEQP: coordBits = 20

template<class Each> ///< each(number of the pass, number of the unit, texture)
void forEachUnit(Scene& scene, Each each) {
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        const Pass& pass = scene.passes[p];
        if (!pass.enabled)
            continue;
        for (std::size_t u = 0; u < pass.units.size(); ++u) {
            const Unit& unit = pass.units[u];
            const auto texture = static_cast<std::size_t>(unit.texture); // of a negative number: beyond all
            if (unit.enabled && texture < scene.textures.size())
                each(p, u, scene.textures[texture]);
        }
    }
}

/// Coordinates of all units moved by the error of a texel or by their own, where that is larger, to one side
/// of each axis; after the texture matrix.
Scene moved(Scene scene, const ImageSource& images, glm::vec3 sides) {
    forEachUnit(scene, [&](std::size_t p, std::size_t u, const Texture& texture) {
        const glm::vec3 reach = reference::coordinateReach(scene, p, u, 0);
        Unit& unit = scene.passes[p].units[u];
        glm::vec3 size = baseSizeOf(texture, unit.target, images);
        if (unit.target == Target::CubeMap) // all three are components of a direction
            size = glm::vec3(size.x);
        const glm::vec3 amount = sides * glm::max(texelError / size, coordinateError * reach);
        if (!inheritedSteps(scene, p, u).empty())
            return; // they have been moved
        // A step that loads a matrix makes void what stands before it.
        const auto load = std::find_if(unit.matrix.rbegin(), unit.matrix.rend(),
                                       [](const MatrixStep& step) { return step.op == MatrixOp::Load; });
        if (load != unit.matrix.rend())
            load->matrix = glm::translate(glm::mat4(1), amount) * load->matrix;
        else if (unit.matrix.size() < maxMatrixSteps)
            unit.matrix.insert(unit.matrix.begin(), {.op = MatrixOp::Translate, .amount = amount});
    });
    return scene;
}

/// Whether colours run from one to the next, so that everything between two ends is possible.
bool blends(Scene scene, Tolerance tolerance) {
    bool found = false;
    forEachUnit(scene, [&](std::size_t, std::size_t, const Texture& texture) {
        found = found || reference::blendsLevels(texture.minFilter) ||
                (tolerance == Tolerance::TexelEdge &&
                 (reference::isLinear(texture.minFilter) || texture.magFilter == MagFilter::Linear));
    });
    return found;
}

PixelBytes bytesAt(const Image& image, std::size_t pixel) {
    PixelBytes bytes{};
    for (std::size_t c = 0; c < 4; ++c)
        bytes[c] = std::to_integer<std::uint8_t>(image.pixels[4 * pixel + c]);
    return bytes;
}

bool isNear(const PixelBytes& a, const PixelBytes& b, int bound) {
    for (std::size_t c = 0; c < 4; ++c) {
        if (std::abs(a[c] - b[c]) > bound)
            return false;
    }
    return true;
}

/// Whether a colour is one of these, or lies between them where that is possible.
bool isAmong(const std::vector<PixelBytes>& ends, const PixelBytes& found, int bound, bool between) {
    if (std::ranges::any_of(ends, [&](const PixelBytes& end) { return isNear(end, found, bound); }))
        return true;
    for (std::size_t c = 0; c < 4 && between; ++c) {
        const auto [low, high] = std::ranges::minmax(ends, {}, [c](const PixelBytes& end) { return end[c]; });
        between = found[c] >= low[c] - bound && found[c] <= high[c] + bound;
    }
    return between;
}

/// Draws the scene with rho at an end of its range where that is clearly nearer to `theirs`: where the ideal
/// rho leaves more than a hundredth of the pixels over the bound, and the end less than a quarter of these.
/// Pixels that are right as they are in `ours` stay.
Result<void> takeNearestRho(Judgement& judgement, const Rule& rule, const Scene& scene, const Image& ours,
                            const Image& theirs, Explainer& reference) {
    const std::size_t ideal = judgement.difference.over;
    if (ideal <= judgement.difference.pixels / 100)
        return {};
    for (const reference::RhoMethod method : {reference::RhoMethod::Lower, reference::RhoMethod::Upper}) {
        Result<Frame> frame = reference.drawBy(scene, method);
        if (!frame)
            return fail(frame.error());
        for (std::size_t i = 0; i < judgement.difference.pixels; ++i) {
            if (isNear(bytesAt(ours, i), bytesAt(theirs, i), rule.bound))
                std::ranges::copy(ByteView(ours.pixels).subspan(4 * i, 4),
                                  frame->image.pixels.begin() + static_cast<std::ptrdiff_t>(4 * i));
        }
        const Result<Difference> difference = compare(frame->image, theirs, rule.bound);
        if (!difference)
            return fail(difference.error());
        if (difference->over < std::min(ideal / 4, judgement.difference.over)) {
            judgement.difference = *difference;
            judgement.rho = method;
            judgement.redrawn = std::move(frame->image);
        }
    }
    return {};
}

/// Which of these pixels are explained by what lambda may be.
Result<void> askLambda(Judgement& judgement, const Rule& rule, const Scene& scene, RhoRange range,
                       const std::vector<std::size_t>& pixels, const Image& theirs, Explainer& reference) {
    const std::size_t most = std::max<std::size_t>(judgement.difference.pixels / probedOneIn, 1);
    const std::size_t step = (pixels.size() + most - 1) / most;
    const bool between = blends(scene, Tolerance::Lambda);
    for (std::size_t i = 0; i < pixels.size(); i += step) {
        const auto width = static_cast<std::size_t>(theirs.width);
        const reference::PixelPlace place{static_cast<int>(pixels[i] % width),
                                          static_cast<int>(pixels[i] / width)};
        const auto explains = [&](RhoMethods methods) -> Result<bool> {
            const Result<std::vector<PixelBytes>> colors = reference.overLambda(scene, place, methods);
            if (!colors)
                return fail(colors.error());
            return isAmong(*colors, bytesAt(theirs, pixels[i]), rule.bound, between);
        };
        Result<bool> explained = false;
        for (const reference::RhoMethod& method : rhoMethods) {
            if (explained && !*explained)
                explained = explains({&method, 1});
        }
        if (explained && *explained)
            continue;
        if (explained && range == RhoRange::Any)
            explained = explains(rhoMethods);
        if (!explained)
            return fail(explained.error());
        (*explained ? judgement.withinRho : judgement.unexplained) += std::min(step, pixels.size() - i);
    }
    return {};
}

} // namespace

std::vector<Scene> movedByTexelError(const Scene& scene, const ImageSource& images) {
    std::vector<Scene> scenes;
    for (const float s : {-1.0F, 1.0F}) {
        for (const float t : {-1.0F, 1.0F})
            scenes.push_back(moved(scene, images, {s, t, s}));
    }
    return scenes;
}

RhoRange rhoRangeOf(const Driver& driver) {
    return driver.name.starts_with("llvmpipe") || driver.name.starts_with("softpipe") ? RhoRange::Ends
                                                                                      : RhoRange::Any;
}

Result<Judgement> judge(const Rule& rule, const Scene& scene, const Image& ours, const Image& theirs,
                        Explainer& reference, RhoRange range) {
    Result<Difference> difference = compare(ours, theirs, rule.bound);
    if (!difference)
        return fail(difference.error());
    Judgement judgement{*difference, difference->over};
    if (difference->max > rule.farBound) {
        const Result<Difference> far = compare(ours, theirs, rule.farBound);
        if (!far)
            return fail(far.error());
        judgement.far = far->over;
    }
    if (difference->over == 0 || rule.tolerance == Tolerance::None)
        return judgement;

    const bool lambda = rule.tolerance == Tolerance::Lambda;
    if (lambda) {
        if (const Result<void> taken = takeNearestRho(judgement, rule, scene, ours, theirs, reference);
            !taken)
            return fail(taken.error());
    }
    std::vector<TexturePictures> held; // or the stand-in for light depths is made again for each pixel
    for (const Texture& texture : scene.textures)
        held.push_back(reference.images().picturesOf(texture));
    std::vector<Image> moved{judgement.redrawn ? *judgement.redrawn : ours};
    for (const Scene& end : movedByTexelError(scene, reference.images())) {
        Result<Frame> frame = reference.drawBy(end, judgement.rho);
        if (!frame)
            return fail(frame.error());
        moved.push_back(std::move(frame->image));
    }
    judgement.unexplained = 0;
    std::vector<PixelBytes> ends;
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < difference->pixels; ++i) {
        const PixelBytes found = bytesAt(theirs, i);
        if (isNear(bytesAt(moved.front(), i), found, rule.bound))
            continue;
        ends.clear();
        for (const Image& each : moved)
            ends.push_back(bytesAt(each, i));
        if (!isAmong(ends, found, rule.bound, blends(scene, Tolerance::TexelEdge)))
            open.push_back(i);
    }
    if (!lambda) {
        judgement.unexplained = open.size();
        return judgement;
    }
    if (const Result<void> asked = askLambda(judgement, rule, scene, range, open, theirs, reference); !asked)
        return fail(asked.error());
    return judgement;
}

} // namespace texplorer::conform
