#include "core/conform/judge.h"

#include "core/conform/lambda_range.h"
#include "core/reference/sampling/lod.h"
#include "core/reference/shading/coordinate_reach.h"

#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>

#include <algorithm>

namespace texplorer::conform {

namespace {

using reference::PixelBytes;

/// A scene of which such a part is unexplained is wrong: probing all of its other pixels would take long.
constexpr std::size_t hopeless = 16;

constexpr float texelError = 1.0F / 128;    // dEQP: uvwBits = 7
constexpr float coordinateError = 0x1p-20F; // of a coordinate itself; dEQP: coordBits = 20

template<class Each> ///< each(pass, number of the unit, texture)
void forEachUnit(Scene& scene, Each each) {
    for (Pass& pass : scene.passes) {
        if (!pass.enabled)
            continue;
        for (std::size_t u = 0; u < pass.units.size(); ++u) {
            const Unit& unit = pass.units[u];
            const auto texture = static_cast<std::size_t>(unit.texture); // of a negative number: beyond all
            if (unit.enabled && texture < scene.textures.size())
                each(pass, u, scene.textures[texture]);
        }
    }
}

/// Coordinates of all units moved by the error of a texel or by their own, where that is larger, to one side
/// of each axis; after the texture matrix.
Scene moved(Scene scene, const ImageSource& images, glm::vec3 sides) {
    forEachUnit(scene, [&](Pass& pass, std::size_t u, const Texture& texture) {
        const glm::vec3 reach = reference::coordinateReach(scene, pass, u, 0);
        Unit& unit = pass.units[u];
        glm::vec3 size = baseSizeOf(texture, unit.target, images);
        if (unit.target == Target::CubeMap) // all three are components of a direction
            size = glm::vec3(size.x);
        const glm::vec3 amount = sides * glm::max(texelError / size, coordinateError * reach);
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
    forEachUnit(scene, [&](const Pass&, std::size_t, const Texture& texture) {
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

} // namespace

std::vector<Scene> movedByTexelError(const Scene& scene, const ImageSource& images) {
    std::vector<Scene> scenes;
    for (const float s : {-1.0F, 1.0F}) {
        for (const float t : {-1.0F, 1.0F})
            scenes.push_back(moved(scene, images, {s, t, s}));
    }
    return scenes;
}

Result<Judgement> judge(const Rule& rule, const Scene& scene, const Image& ours, const Image& theirs,
                        Explainer& reference) {
    Result<Difference> difference = compare(ours, theirs, rule.bound);
    if (!difference)
        return fail(difference.error());
    Judgement judgement{*difference, difference->over};
    if (difference->over == 0 || rule.tolerance == Tolerance::None)
        return judgement;

    std::vector<Image> moved{ours};
    for (const Scene& end : movedByTexelError(scene, reference.images())) {
        Result<Frame> frame = reference.draw(end);
        if (!frame)
            return fail(frame.error());
        moved.push_back(std::move(frame->image));
    }
    judgement.unexplained = 0;
    std::vector<PixelBytes> ends;
    for (std::size_t i = 0; i < difference->pixels; ++i) {
        const PixelBytes found = bytesAt(theirs, i);
        if (isNear(bytesAt(ours, i), found, rule.bound))
            continue;
        ends.clear();
        for (const Image& each : moved)
            ends.push_back(bytesAt(each, i));
        bool explained = isAmong(ends, found, rule.bound, blends(scene, Tolerance::TexelEdge));
        if (!explained && rule.tolerance == Tolerance::Lambda &&
            judgement.unexplained < difference->pixels / hopeless) {
            const auto width = static_cast<std::size_t>(ours.width);
            Result<std::vector<PixelBytes>> colors =
                reference.overLambda(scene, {static_cast<int>(i % width), static_cast<int>(i / width)});
            if (!colors)
                return fail(colors.error());
            explained = isAmong(*colors, found, rule.bound, blends(scene, Tolerance::Lambda));
        }
        judgement.unexplained += explained ? 0 : 1;
    }
    return judgement;
}

} // namespace texplorer::conform
