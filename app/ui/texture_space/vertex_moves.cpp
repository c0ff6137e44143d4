#include "app/ui/texture_space/vertex_moves.h"

#include "app/ui/model/chosen_vertices.h"
#include "app/ui/model/tex_coord_edits.h"
#include "core/scene/tex_coords.h"

#include <fmt/core.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace texplorer::ui {
namespace {

constexpr float angleStep = std::numbers::pi_v<float> / 12; // 15 degrees
constexpr float factorStep = 0.25F;

struct MoveRow {
    MoveKind kind;
    const char* one;  ///< the name in Undo, with the vertex's number
    const char* many; ///< with the number of vertices
};

constexpr std::array moveRows{
    MoveRow{MoveKind::Move, "Move vertex {}", "Move {} vertices"},
    MoveRow{MoveKind::Rotate, "Rotate vertex {}", "Rotate {} vertices"},
    MoveRow{MoveKind::Scale, "Scale vertex {}", "Scale {} vertices"},
};

std::string nameOfMove(MoveKind kind, std::span<const std::size_t> vertices) {
    const MoveRow& row = moveRows[static_cast<std::size_t>(kind)];
    return vertices.size() == 1 ? fmt::format(fmt::runtime(row.one), vertices.front())
                                : fmt::format(fmt::runtime(row.many), vertices.size());
}

/// The middle of their bounding rectangle.
glm::vec2 middleOf(std::span<const glm::vec2> places) {
    glm::vec2 low = places.front();
    glm::vec2 high = low;
    for (const glm::vec2& each : places) {
        low = glm::min(low, each);
        high = glm::max(high, each);
    }
    return (low + high) / 2.0F;
}

/// Changes only the coordinate that is not locked.
glm::vec2 constrained(glm::vec2 way, std::optional<int> axis) {
    return {axis == 1 ? 0 : way.x, axis == 0 ? 0 : way.y};
}

/// The target positions of the vertices.
class Motion {
public:
    Motion(const VertexMove& move, glm::vec2 mouse, std::optional<Snap> snap, TexelCounts texels,
           float magnet)
        : kind_(move.kind)
        , centre_(move.centre) {
        switch (kind_) {
        case MoveKind::Move: {
            const glm::vec2 wanted = move.heldPlace + mouse - move.from;
            way_ = (snap ? snapped(wanted, *snap, texels, magnet) : wanted) - move.heldPlace;
            way_ = constrained(way_, move.axis);
            return;
        }
        case MoveKind::Rotate: {
            const glm::vec2 before = move.from - centre_;
            const glm::vec2 now = mouse - centre_;
            float angle = std::atan2(now.y, now.x) - std::atan2(before.y, before.x);
            if (snap)
                angle = std::round(angle / angleStep) * angleStep;
            sine_ = std::sin(angle);
            cosine_ = std::cos(angle);
            return;
        }
        case MoveKind::Scale: {
            const float before = glm::length(move.from - centre_);
            const float now = glm::length(mouse - centre_);
            float factor = before > 0 ? now / before : 1;
            if (glm::dot(mouse - centre_, move.from - centre_) < 0) // beyond the middle
                factor = -factor;
            if (snap)
                factor = std::round(factor / factorStep) * factorStep;
            factors_ = {move.axis == 1 ? 1 : factor, move.axis == 0 ? 1 : factor};
            return;
        }
        }
    }

    [[nodiscard]] glm::vec2 operator()(glm::vec2 place) const {
        const glm::vec2 from = place - centre_;
        switch (kind_) {
        case MoveKind::Move:
            return place + way_;
        case MoveKind::Rotate:
            return centre_ + glm::vec2(from.x * cosine_ - from.y * sine_, from.x * sine_ + from.y * cosine_);
        case MoveKind::Scale:
            return centre_ + from * factors_;
        }
        return place;
    }

private:
    MoveKind kind_;
    glm::vec2 centre_;
    glm::vec2 way_{0};
    float sine_ = 0;
    float cosine_ = 1;
    glm::vec2 factors_{1};
};

/// The list with new positions of some vertices, given or final ones. The error says why that is not
/// possible.
Result<TexCoords> placed(const PlaneCoords& coords, bool results, std::span<const std::size_t> vertices,
                         const auto& placeOf) {
    TexCoords list = coords.given();
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const std::size_t vertex = vertices[i];
        const glm::vec2 place = placeOf(i);
        if (results) {
            const Result<glm::vec4> given = coords.givenFor(vertex, place);
            if (!given)
                return fail(given.error());
            list[vertex] = withinCoordRange(*given);
        } else {
            list[vertex] = withinCoordRange({place.x, place.y, list[vertex].z, list[vertex].w});
        }
    }
    return list;
}

/// The vertices that the list of coordinates has.
std::vector<std::size_t> chosenOf(const Selection& selection, const PlaneCoords& coords) {
    std::vector<std::size_t> vertices = chosenVertices(selection);
    std::erase_if(vertices, [&](std::size_t vertex) { return vertex >= coords.given().size(); });
    return vertices;
}

} // namespace

glm::vec2 snapped(glm::vec2 place, Snap snap, TexelCounts texels, float magnet) {
    switch (snap) {
    case Snap::Texel:
        return glm::round(place * texels) / texels;
    case Snap::Quarter:
        return glm::round(place * 4.0F) / 4.0F;
    case Snap::Whole:
        for (int i = 0; i < 2; ++i) {
            const float whole = place[i] < 0.5F ? 0 : 1;
            if (std::abs(place[i] - whole) <= magnet)
                place[i] = whole;
        }
        return place;
    }
    return place;
}

std::optional<VertexMove> beginMove(const Selection& selection, const PlaneCoords& coords, MoveKind kind,
                                    bool results, std::size_t held, glm::vec2 mouse) {
    VertexMove move{.kind = kind,
                    .results = results,
                    .vertices = chosenOf(selection, coords),
                    .held = held,
                    .from = mouse,
                    .model = selection.model,
                    .unit = selection.unit};
    if (move.vertices.empty())
        return std::nullopt;
    if (std::ranges::find(move.vertices, held) == move.vertices.end())
        move.held = move.vertices.front();
    const std::vector<glm::vec2>& places = results ? coords.resultingPlaces() : coords.givenPlaces();
    for (const std::size_t vertex : move.vertices)
        move.places.push_back(places[vertex]);
    move.heldPlace = places[move.held];
    move.centre = middleOf(move.places);
    return move;
}

void followMouse(const Session& session, const PlaneCoords& coords, VertexMove& move, glm::vec2 mouse,
                 const Snapping& snapping, TexelCounts texels, float magnet) {
    if (mouse == move.from && !move.submitted)
        return;
    const Motion motion(move, mouse, snapping.on ? std::optional(snapping.to) : std::nullopt, texels, magnet);
    Result<TexCoords> list =
        placed(coords, move.results, move.vertices, [&](std::size_t i) { return motion(move.places[i]); });
    move.refusal = list ? std::string() : list.error().message;
    if (!list || *list == coords.given())
        return;
    dragTexCoords(session, nameOfMove(move.kind, move.vertices), std::move(*list));
    move.submitted = true;
}

void endMove(const Session& session, const VertexMove& move, bool keep) {
    if (!keep && move.submitted)
        session.out.requests.emplace_back(DropStep{});
    sealEdit(session);
}

std::vector<std::size_t> editedVertices(const Session& session) {
    std::vector<std::size_t> vertices = chosenVertices(session.window.selection);
    if (vertices.size() > 1)
        return vertices;
    vertices.resize(selectedMesh(session).vertices.size());
    std::iota(vertices.begin(), vertices.end(), std::size_t{0});
    return vertices;
}

void nudge(const Session& session, const PlaneCoords& coords, glm::vec2 way) {
    const std::vector<std::size_t> vertices = chosenOf(session.window.selection, coords);
    if (vertices.empty())
        return;
    const auto shifted = [&](std::size_t i) { return coords.givenPlaces()[vertices[i]] + way; };
    Result<TexCoords> list = placed(coords, false, vertices, shifted);
    dragTexCoords(session, nameOfMove(MoveKind::Move, vertices), std::move(*list));
}

void mirrorVertices(const Session& session, const PlaneCoords& coords, int axis) {
    const std::vector<std::size_t> vertices = editedVertices(session);
    std::vector<glm::vec2> places;
    for (const std::size_t vertex : vertices)
        places.push_back(coords.givenPlaces()[vertex]);
    if (places.empty())
        return;
    const glm::vec2 middle = middleOf(places);
    Result<TexCoords> list = placed(coords, false, vertices, [&](std::size_t i) {
        glm::vec2 place = places[i];
        place[axis] = 2 * middle[axis] - place[axis];
        return place;
    });
    submitTexCoords(session, axis == 0 ? "Mirror s" : "Mirror t", std::move(*list));
}

} // namespace texplorer::ui
