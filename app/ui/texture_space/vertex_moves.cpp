#include "app/ui/texture_space/vertex_moves.h"

#include "app/ui/model/notice.h"
#include "app/ui/model/tex_coord_edits.h"
#include "app/ui/state/chosen_vertices.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>

namespace texplorer::ui {
namespace {

constexpr float angleStep = std::numbers::pi_v<float> / 12; // 15 degrees
constexpr float factorStep = 0.25F;

Sentence nameOfMove(MoveKind kind, std::span<const std::size_t> vertices) {
    const MoveRow& row = rowOf(kind);
    return vertices.size() == 1 ? Sentence(row.one, vertices.front()) : Sentence(row.many, vertices.size());
}

std::vector<glm::vec2> placesOf(std::span<const std::size_t> vertices, std::span<const glm::vec2> all) {
    std::vector<glm::vec2> places;
    for (const std::size_t vertex : vertices)
        places.push_back(all[vertex]);
    return places;
}

/// The middle of their bounding rectangle.
glm::vec2 middleOf(std::span<const glm::vec2> places) {
    Bounds bounds{places.front(), places.front()};
    for (const glm::vec2& each : places)
        bounds.include(each);
    return bounds.middle();
}

/// Changes only the coordinate that is not locked.
glm::vec2 constrained(glm::vec2 way, std::optional<int> axis) {
    return {axis == 1 ? 0 : way.x, axis == 0 ? 0 : way.y};
}

/// The target positions of the vertices.
struct Motion {
    glm::vec2 way{0};
    glm::vec2 centre{0};
    glm::mat2 matrix{1}; ///< about the centre

    [[nodiscard]] glm::vec2 operator()(glm::vec2 place) const {
        return matrix == glm::mat2(1) ? place + way : centre + matrix * (place - centre);
    }
};

Motion motionOf(const VertexMove& move, glm::vec2 mouse, std::optional<Snap> snap, TexelCounts texels,
                float magnet) {
    if (move.kind == MoveKind::Move) {
        const glm::vec2 wanted = move.heldPlace + mouse - move.from;
        const glm::vec2 place = snap ? snapped(wanted, *snap, texels, magnet) : wanted;
        return {.way = constrained(place - move.heldPlace, move.axis)};
    }
    const glm::vec2 before = move.from - move.centre;
    const glm::vec2 now = mouse - move.centre;
    if (move.kind == MoveKind::Rotate) {
        float angle = std::atan2(now.y, now.x) - std::atan2(before.y, before.x);
        if (snap)
            angle = std::round(angle / angleStep) * angleStep;
        const float sine = std::sin(angle);
        const float cosine = std::cos(angle);
        return {.centre = move.centre, .matrix = {cosine, sine, -sine, cosine}};
    }
    float factor = glm::length(before) > 0 ? glm::length(now) / glm::length(before) : 1;
    if (glm::dot(now, before) < 0) // beyond the middle
        factor = -factor;
    if (snap)
        factor = std::round(factor / factorStep) * factorStep;
    return {.centre = move.centre,
            .matrix = {move.axis == 1 ? 1 : factor, 0, 0, move.axis == 0 ? 1 : factor}};
}

/// The list with new positions of some vertices, given or final ones. The error says why that is not
/// possible.
Result<TexCoords> placed(const PlaneCoords& coords, bool results, std::span<const std::size_t> vertices,
                         const auto& placeOf) {
    TexCoords list = coords.given();
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const std::size_t vertex = vertices[i];
        const glm::vec2 place = placeOf(i);
        if (const Result<void> own = coords.hasOwn(vertex); !own)
            return fail(own.error());
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

/// Those that the list of coordinates has. Without those that have no coordinates of their own, if any has.
std::vector<std::size_t> movableOf(std::vector<std::size_t> vertices, const PlaneCoords& coords) {
    std::erase_if(vertices, [&](std::size_t vertex) { return vertex >= coords.given().size(); });
    std::vector<std::size_t> own;
    std::ranges::copy_if(vertices, std::back_inserter(own),
                         [&](std::size_t vertex) { return coords.hasOwn(vertex).has_value(); });
    return own.empty() ? vertices : own;
}

void submitOrSay(const Session& session, Sentence name, Result<TexCoords> list, auto&& submit) {
    if (list)
        return submit(session, std::move(name), *std::move(list));
    act(session, [error = list.error()](Session& told) { say(told, error); });
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
                    .vertices = movableOf(chosenVertices(selection), coords),
                    .held = held,
                    .from = mouse,
                    .model = selection.model,
                    .unit = selection.unit};
    if (move.vertices.empty())
        return std::nullopt;
    if (std::ranges::find(move.vertices, held) == move.vertices.end())
        move.held = move.vertices.front();
    const std::vector<glm::vec2>& places = results ? coords.resultingPlaces() : coords.givenPlaces();
    move.places = placesOf(move.vertices, places);
    move.heldPlace = places[move.held];
    move.centre = middleOf(move.places);
    return move;
}

void followMouse(const Session& session, const PlaneCoords& coords, VertexMove& move, glm::vec2 mouse,
                 const Snapping& snapping, TexelCounts texels, float magnet) {
    if (mouse == move.from && !move.submitted)
        return;
    const Motion motion =
        motionOf(move, mouse, snapping.on ? std::optional(snapping.to) : std::nullopt, texels, magnet);
    Result<TexCoords> list =
        placed(coords, move.results, move.vertices, [&](std::size_t i) { return motion(move.places[i]); });
    move.refusal = list ? Sentence() : list.error().message;
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
    std::vector<std::size_t> vertices = chosenVertices(session.look.selection);
    if (vertices.size() > 1)
        return vertices;
    vertices.resize(selectedMesh(session).vertices.size());
    std::iota(vertices.begin(), vertices.end(), std::size_t{0});
    return vertices;
}

void nudge(const Session& session, const PlaneCoords& coords, glm::vec2 way) {
    const std::vector<std::size_t> vertices = movableOf(chosenVertices(session.look.selection), coords);
    if (vertices.empty())
        return;
    const auto shifted = [&](std::size_t i) { return coords.givenPlaces()[vertices[i]] + way; };
    submitOrSay(session, nameOfMove(MoveKind::Move, vertices), placed(coords, false, vertices, shifted),
                dragTexCoords);
}

void mirrorVertices(const Session& session, const PlaneCoords& coords, int axis) {
    const std::vector<std::size_t> vertices = movableOf(editedVertices(session), coords);
    if (vertices.empty())
        return;
    const std::vector<glm::vec2> places = placesOf(vertices, coords.givenPlaces());
    const glm::vec2 middle = middleOf(places);
    Result<TexCoords> list = placed(coords, false, vertices, [&](std::size_t i) {
        glm::vec2 place = places[i];
        place[axis] = 2 * middle[axis] - place[axis];
        return place;
    });
    submitOrSay(session, axis == 0 ? N_("Mirror s") : N_("Mirror t"), std::move(list), submitTexCoords);
}

} // namespace texplorer::ui
