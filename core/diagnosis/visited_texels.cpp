#include "texplorer/diagnosis/visited_texels.h"

#include "texplorer/reference/raster/raster.h"
#include "texplorer/reference/raster/scene_triangles.h"
#include "texplorer/reference/sampling/cube.h"
#include "texplorer/reference/sampling/ellipse.h"
#include "texplorer/reference/sampling/lod.h"
#include "texplorer/reference/shading/coordinates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stop_token>
#include <utility>
#include <vector>

namespace texplorer {

namespace {

using reference::PassState;
using reference::Plane;
using reference::SampledTexture;
using reference::Triangle;
using reference::UnitState;

constexpr double endless = std::numeric_limits<double>::infinity();

/// llvmpipe shades blocks of four pixels across, and takes derivatives from two by two, whether the triangle
/// covers all of them or not.
constexpr int blockExtent = 4;
constexpr int placesInRow = 8; ///< that are looked at

/// The passes that show a texture, with the units that do.
std::vector<PassState> passesOf(const SampledTexture& texture, const TextureUse& use) {
    std::vector<PassState> states;
    for (std::size_t p = 0; p < use.scene.passes.size(); ++p) {
        const Pass& pass = use.scene.passes[p];
        PassState state;
        state.pass = &pass;
        state.perspective = use.scene.view.perspectiveHint != HintMode::Fastest;
        for (std::size_t u = 0; u < pass.units.size() && pass.enabled; ++u) {
            const Unit& unit = pass.units[u];
            if (!unit.enabled || !std::cmp_equal(unit.texture, use.texture) || unit.target != texture.target)
                continue;
            UnitState& shown = state.units[u];
            shown.texture = &texture;
            shown.unit = &unit;
            shown.sampling.unitBias = unit.lodBias;
            shown.sampling.anisotropy = reference::AnisotropyMethod::Ellipse;
            shown.matrices = reference::coordinateMatrices(use.scene, p, u, LateFlip::None, use.time);
            state.unitsUsed = static_cast<int>(u) + 1;
        }
        if (state.unitsUsed > 0)
            states.push_back(state);
    }
    return states;
}

/// What a unit looks up in a triangle.
class Lookups {
public:
    Lookups(const Triangle& triangle, std::size_t unit)
        : plane_(triangle.texCoords[unit])
        , invW_(triangle.invW)
        , origin_(triangle.origin)
        , unit_(triangle.pass->units[unit]) {}

    /// Of the covered pixels of a row and of those that are shaded with them.
    [[nodiscard]] double visitedInRow(int first, int y, int count) const {
        const int left = first / blockExtent * blockExtent;
        const int right = (first + count - 1) / blockExtent * blockExtent + blockExtent - 1;
        const int low = y / 2 * 2;
        if (runsThroughZero(first, first + count - 1, low))
            return endless;
        // The box is largest next to q = 0: that is at one of the ends, because q is linear, or where it
        // changes its sign. Elsewhere the box changes slowly, and some places stand for all.
        const int step = blockExtent * std::max(1, (right - left) / (blockExtent * placesInRow));
        double visited = blockExtent * visitedAt(right - 1, low);
        for (int x = left; x < right; x += step)
            visited += step * visitedAt(x, low);
        const double begin = overW(left, low).q;
        const double end = overW(right, low).q;
        if ((begin < 0) != (end < 0)) {
            const int at = left + static_cast<int>((right - left) * (begin / (begin - end)));
            for (int x = std::max(left, at - 1); x <= std::min(right - 1, at + 1); ++x)
                visited += visitedAt(x, low);
        }
        return visited;
    }

    [[nodiscard]] bool isConstantAt(int x, int y) const {
        constexpr double rounding = 1e-6;
        const glm::dvec3 here = coords(x, y);
        const glm::dvec3 moves = glm::abs(coords(x + 1, y) - here) + glm::abs(coords(x, y + 1) - here);
        return moves.s <= rounding && moves.t <= rounding;
    }

private:
    /// q itself: beyond a steep triangle's edge 1 / w changes its sign, and q over w with it.
    [[nodiscard]] bool runsThroughZero(int left, int right, int low) const {
        const auto q = [this](int x, int y) { return overW(x, y).q * invW(x, y); };
        const std::array corners{q(left, low), q(right, low), q(left, low + 1), q(right, low + 1)};
        const auto [least, most] = std::ranges::minmax(corners);
        return !(least > 0 || most < 0);
    }

    [[nodiscard]] double invW(int x, int y) const {
        const glm::dvec2 offset = glm::dvec2(x, y) - glm::dvec2(origin_);
        return double{invW_.origin} + double{invW_.dx} * offset.x + double{invW_.dy} * offset.y;
    }
    [[nodiscard]] glm::dvec4 overW(int x, int y) const {
        const glm::dvec2 offset = glm::dvec2(x, y) - glm::dvec2(origin_);
        return glm::dvec4(plane_.origin) + glm::dvec4(plane_.dx) * offset.x +
               glm::dvec4(plane_.dy) * offset.y;
    }
    [[nodiscard]] glm::dvec3 coords(int x, int y) const {
        const glm::dvec4 found = overW(x, y);
        const glm::dvec3 given = glm::dvec3(found) / found.q;
        if (unit_.texture->target != Target::CubeMap)
            return given;
        return glm::dvec3(reference::cubePlace(glm::vec3(given), {}).coords); // on whichever face it is
    }

    [[nodiscard]] double visitedAt(int x, int y) const {
        const SampledTexture& texture = *unit_.texture;
        const glm::dvec3 here = coords(x, y);
        const reference::Derivatives moves{glm::vec3(coords(x + 1, y) - here),
                                           glm::vec3(coords(x, y + 1) - here)};
        const reference::LevelChoice choice =
            reference::chooseLevels(texture, reference::levelOfDetail(texture, moves, unit_.sampling));
        const reference::Level* level = texture.level(choice.first);
        if (!level)
            return 0;
        const glm::dvec2 size(level->size());
        const glm::dvec2 half =
            reference::Ellipse(glm::dvec2(moves.dx) * size, glm::dvec2(moves.dy) * size).halfExtent();
        const double box = (2 * half.x + 2) * (2 * half.y + 2);
        return std::isnan(box) ? endless : box;
    }

    const Plane<glm::vec4>& plane_;
    const Plane<float>& invW_;
    glm::vec2 origin_;
    const UnitState& unit_;
};

/// Calls `visit` for each row of fragments that reads the texture, until it returns false.
template<typename Visit>
void eachRow(const SampledTexture& texture, const TextureUse& use, const Visit& visit) {
    const std::vector<PassState> states = passesOf(texture, use);
    const reference::Box picture{0, use.width - 1, 0, use.height - 1};
    bool goesOn = true;
    std::stop_source done;
    reference::eachTriangle(use.scene, states, use.time, {use.width, use.height}, done.get_token(),
                            [&](const Triangle& triangle) {
                                for (std::size_t u = 0; u < maxUnits; ++u) {
                                    if (!triangle.pass->units[u].texture)
                                        continue;
                                    const Lookups lookups(triangle, u);
                                    reference::eachCoveredRow(
                                        triangle, picture, [&](int first, int y, int count) {
                                            goesOn = goesOn && visit(lookups, first, y, count);
                                        });
                                }
                                if (!goesOn)
                                    done.request_stop();
                            });
}

} // namespace

double visitedTexels(const SampledTexture& texture, const TextureUse& use, double enough) {
    double visited = 0;
    eachRow(texture, use, [&](const Lookups& lookups, int first, int y, int count) {
        visited += lookups.visitedInRow(first, y, count);
        return visited <= enough;
    });
    return visited;
}

bool hasConstantCoords(const SampledTexture& texture, const TextureUse& use) {
    bool found = false;
    eachRow(texture, use, [&](const Lookups& lookups, int first, int y, int count) {
        found = lookups.isConstantAt(first + count / 2, y);
        return !found;
    });
    return found;
}

} // namespace texplorer
