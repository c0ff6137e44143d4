#include "texplorer/scene/projections.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <numeric>
#include <optional>

namespace texplorer {
namespace {

/// The box around a mesh.
struct Extents {
    glm::vec3 low{0};
    glm::vec3 high{0};

    explicit Extents(const Mesh& mesh) {
        if (mesh.vertices.empty())
            return;
        low = high = mesh.vertices.front().position;
        for (const Vertex& vertex : mesh.vertices) {
            low = glm::min(low, vertex.position);
            high = glm::max(high, vertex.position);
        }
    }
    /// What longitude and latitude are about. The box of a sphere with few slices isn't symmetrical.
    [[nodiscard]] glm::vec3 middle() const {
        const bool holdsOrigin = glm::all(glm::lessThanEqual(low, glm::vec3(0))) &&
                                 glm::all(glm::greaterThanEqual(high, glm::vec3(0)));
        return holdsOrigin ? glm::vec3(0) : low / 2.0F + high / 2.0F;
    }
    [[nodiscard]] float longest() const { return std::max({high.x - low.x, high.y - low.y, high.z - low.z}); }
    /// 0 to 1 along an axis.
    [[nodiscard]] float share(glm::vec3 position, int axis) const {
        const float extent = high[axis] - low[axis];
        return extent > 0 ? (position[axis] - low[axis]) / extent : 0;
    }
};

glm::vec2 onBox(const Vertex& vertex, const Extents& extents) {
    const glm::vec3 n = glm::abs(vertex.normal);
    const float x = extents.share(vertex.position, 0);
    const float y = extents.share(vertex.position, 1);
    const float z = extents.share(vertex.position, 2);
    // As the cube's faces are seen from in front of them.
    if (n.z >= n.x && n.z >= n.y)
        return {vertex.normal.z < 0 ? 1 - x : x, y};
    if (n.x >= n.y)
        return {vertex.normal.x < 0 ? z : 1 - z, y};
    return {x, vertex.normal.y < 0 ? z : 1 - z};
}

/// Which vertices share a triangle or a line.
class Neighbours {
public:
    explicit Neighbours(const Mesh& mesh)
        : lists_(mesh.vertices.size()) {
        for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
            for (int corner = 0; corner < 3; ++corner)
                join(mesh.triangles[i + static_cast<std::size_t>(corner)],
                     mesh.triangles[i + static_cast<std::size_t>((corner + 1) % 3)]);
        }
        for (std::size_t i = 0; i + 1 < mesh.lines.size(); i += 2)
            join(mesh.lines[i], mesh.lines[i + 1]);
    }
    [[nodiscard]] std::span<const std::uint32_t> of(std::size_t vertex) const { return lists_[vertex]; }

private:
    void join(std::uint32_t a, std::uint32_t b) {
        lists_[a].push_back(b);
        lists_[b].push_back(a);
    }
    std::vector<std::vector<std::uint32_t>> lists_;
};

/// The longitude of every vertex about the y axis through the middle, going on beyond seams.
class Longitudes {
public:
    Longitudes(const Mesh& mesh, const Extents& extents)
        : mesh_(mesh)
        , neighbours_(mesh)
        , longitudes_(mesh.vertices.size()) {
        const glm::vec3 middle = extents.middle();
        const float least = extents.longest() * 1e-6F;
        for (std::size_t i = 0; i < longitudes_.size(); ++i) {
            const glm::vec3 from = mesh.vertices[i].position - middle;
            if (std::hypot(from.x, from.z) > least)
                longitudes_[i] = 0.5F + std::atan2(from.x, from.z) / (2 * std::numbers::pi_v<float>);
        }
        goOnBeyondSeams();
    }

    [[nodiscard]] float of(std::size_t vertex) const {
        return longitudes_[vertex] ? *longitudes_[vertex] : atPole(vertex);
    }

private:
    /// Each part that hangs together starts at its vertex nearest to the front, and from neighbour to
    /// neighbour s takes the shorter way.
    void goOnBeyondSeams() {
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < longitudes_.size(); ++i) {
            if (longitudes_[i])
                order.push_back(i);
        }
        std::ranges::stable_sort(order, {}, [&](std::size_t i) { return std::abs(*longitudes_[i] - 0.5F); });
        std::vector<bool> seen(longitudes_.size());
        for (const std::size_t start : order) {
            if (seen[start])
                continue;
            seen[start] = true;
            std::deque<std::size_t> next{start};
            while (!next.empty()) {
                const std::size_t from = next.front();
                next.pop_front();
                for (const std::uint32_t to : neighbours_.of(from)) {
                    if (seen[to] || !longitudes_[to])
                        continue;
                    seen[to] = true;
                    constexpr float nearlyOne = 0.9999F; // half way around isn't beyond the seam
                    *longitudes_[to] += std::round((*longitudes_[from] - *longitudes_[to]) * nearlyOne);
                    next.push_back(to);
                }
            }
        }
    }

    float atPole(std::size_t pole) const {
        const float own = mesh_.vertices[pole].texCoord.s;
        std::vector<float> around;
        for (const std::uint32_t each : neighbours_.of(pole)) {
            if (longitudes_[each])
                around.push_back(*longitudes_[each]);
        }
        if (around.empty())
            return own;
        constexpr float rounding = 1e-5F;
        const auto [low, high] = std::ranges::minmax(around);
        if (own >= low - rounding && own <= high + rounding)
            return own;
        return std::accumulate(around.begin(), around.end(), 0.0F) / static_cast<float>(around.size());
    }

    const Mesh& mesh_;
    Neighbours neighbours_;
    std::vector<std::optional<float>> longitudes_; ///< none: at a pole
};

/// 0 at the south pole, 1 at the north pole; in the middle itself 0.5.
float latitude(glm::vec3 fromMiddle) {
    return 0.5F +
           std::atan2(fromMiddle.y, std::hypot(fromMiddle.x, fromMiddle.z)) / std::numbers::pi_v<float>;
}

} // namespace

TexCoords projectedTexCoords(const Mesh& mesh, CoordProjection projection,
                             std::span<const std::size_t> vertices, TexCoords coords) {
    const Extents extents(mesh);
    const bool isRound =
        projection == CoordProjection::Spherical || projection == CoordProjection::Cylindrical;
    const std::optional<Longitudes> longitudes =
        isRound ? std::optional<Longitudes>(std::in_place, mesh, extents) : std::nullopt;
    for (const std::size_t i : vertices) {
        const Vertex& vertex = mesh.vertices[i];
        glm::vec2 place(0);
        switch (projection) {
        case CoordProjection::Planar:
            place = {extents.share(vertex.position, 0), extents.share(vertex.position, 1)};
            break;
        case CoordProjection::Box:
            place = onBox(vertex, extents);
            break;
        case CoordProjection::Spherical:
            place = {longitudes->of(i), latitude(vertex.position - extents.middle())};
            break;
        case CoordProjection::Cylindrical:
            place = {longitudes->of(i), extents.share(vertex.position, 1)};
            break;
        }
        coords[i] = {place, 0, 1};
    }
    return coords;
}

} // namespace texplorer
