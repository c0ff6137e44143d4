#include "app/ui/texture_space/plane_input.h"

#include "app/ui/state/chosen_vertices.h"
#include "app/ui/texture_space/outline_drawing.h"
#include "app/ui/texture_space/plane_tools.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/points.h"
#include "app/ui/widgets/theme.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

namespace texplorer::ui {
namespace {

/// Infinite if it is certainly out of `reach`: called for each vertex in each frame.
float distanceTo(const Canvas& canvas, glm::vec2 place, ImVec2 mouse, float reach) {
    if (!isPlace(place))
        return INFINITY;
    const ImVec2 at = canvas.toPixel(place);
    const ImVec2 way = at - mouse;
    const bool near = std::max(std::abs(way.x), std::abs(way.y)) <= reach;
    return near ? std::hypot(way.x, way.y) : INFINITY;
}

struct NearVertex {
    std::size_t vertex;
    float distance;
};

std::optional<NearVertex> nearestOf(const Canvas& canvas, const Mesh& mesh, std::span<const glm::vec2> places,
                                    std::optional<std::size_t> chosen, ImVec2 mouse) {
    std::optional<NearVertex> best;
    constexpr float alike = 1; // in pixels: the same place
    const float reach = std::max(ImGui::GetFontSize() * 0.55F, targetHeight() / 2);
    const auto consider = [&](std::size_t vertex) {
        const float distance = distanceTo(canvas, places[vertex], mouse, reach);
        if (distance <= reach && (!best || distance < best->distance - alike))
            best = {vertex, distance};
    };
    if (chosen && *chosen < places.size()) {
        consider(*chosen);
        for (const Face& face : mesh.faces)
            if (contains(face, chosen))
                std::ranges::for_each(face.vertices, consider);
    }
    for (std::size_t vertex = 0; vertex < places.size(); ++vertex)
        consider(vertex);
    return best;
}

bool isPressed(int code) {
    return isKeyPressed(code, false);
}

Snapping snappingNow(const TextureSpaceState& state) {
    return {state.snapping.on != ImGui::GetIO().KeyCtrl, state.snapping.to};
}

TexelCounts texelsOf(const Session& session, const TextureSpaceState& state) {
    if (state.level.picture() && state.look.level != 0)
        return {state.level.picture()->width, state.level.picture()->height};
    const auto image = boundImage(session);
    if (!image || image->surfaces.empty())
        return {1, 1};
    const Surface& base = image->surfaces.front();
    return {std::max(widthOf(base), 1), std::max(heightOf(base), 1)};
}

void followWithMove(const Session& session, TextureSpaceState& state, const Canvas& canvas) {
    followMouse(session, state.coords, *state.move, canvas.toCoord(ImGui::GetIO().MousePos),
                snappingNow(state), texelsOf(session, state),
                ImGui::GetFontSize() * 0.6F / canvas.pixelsPerUnit);
}

void finishMove(const Session& session, TextureSpaceState& state, bool keep) {
    endMove(session, *state.move, keep);
    state.move.reset();
}

/// The vertices no longer exist: another model or unit was selected, or a mesh became smaller.
bool isStale(const Session& session, const TextureSpaceState& state) {
    const VertexMove& move = *state.move;
    return move.model != session.look.selection.model || move.unit != session.look.selection.unit ||
           move.vertices.back() >= state.coords.given().size();
}

/// The axis of a key: X and S the first, Y and T the second.
std::optional<int> axisKey() {
    if (isPressed('X') || isPressed('S'))
        return 0;
    if (isPressed('Y') || isPressed('T'))
        return 1;
    return std::nullopt;
}

/// Returns true if a click ended the move.
bool continueKeyedMove(const Session& session, TextureSpaceState& state, const Canvas& canvas) {
    session.out.keyTaken = true;
    const bool clicked = ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    const bool cancelled = isPressed(key::escape) || ImGui::IsMouseClicked(ImGuiMouseButton_Right);
    if (const std::optional<int> axis = axisKey())
        state.move->axis = state.move->axis == axis ? std::nullopt : axis;
    if (cancelled) {
        finishMove(session, state, false);
        return true;
    }
    if (ImGui::IsMousePosValid()) // outside of the window it keeps its position
        followWithMove(session, state, canvas);
    if (!clicked && !isPressed(key::enter) && !isPressed(key::keypadEnter))
        return false;
    finishMove(session, state, true);
    return clicked;
}

void beginKeyedMove(const Session& session, TextureSpaceState& state, const Canvas& canvas, MoveKind kind) {
    const std::optional<std::size_t>& vertex = session.look.selection.vertex;
    if (!vertex || *vertex >= state.coords.given().size())
        return;
    // Final positions are moved, unless they cannot be computed back.
    const bool results = state.coords.differ() &&
                         state.coords.givenFor(*vertex, state.coords.resultingPlaces()[*vertex]).has_value();
    sealEdit(session);
    state.move = beginMove(session.look.selection, state.coords, kind, results, *vertex,
                           canvas.toCoord(ImGui::GetIO().MousePos));
    if (state.move)
        state.move->byKey = true;
}

constexpr std::array arrowKeys{std::pair(key::left, glm::vec2(-1, 0)), std::pair(key::right, glm::vec2(1, 0)),
                               std::pair(key::down, glm::vec2(0, -1)), std::pair(key::up, glm::vec2(0, 1))};

void choose(const Session& session, std::vector<std::size_t> vertices) {
    act(session,
        [chosen = std::move(vertices)](Session& changed) { chooseVertices(changed.look.selection, chosen); });
}

void chooseAllOrNone(const Session& session, const TextureSpaceState& state) {
    const std::size_t count = state.coords.given().size();
    std::vector<std::size_t> all(chosenVertices(session.look.selection).size() == count ? 0 : count);
    std::iota(all.begin(), all.end(), std::size_t{0});
    choose(session, std::move(all));
}

void handleShortKeys(const Session& session, TextureSpaceState& state, const Canvas& canvas) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool hasVertices = !state.coords.given().empty();
    const auto takes = [&](int code, bool repeats = false) {
        const bool pressed = isKeyPressed(code, repeats);
        session.out.keyTaken = session.out.keyTaken || pressed;
        return pressed;
    };
    if (io.KeyCtrl) {
        if (!io.KeyShift && takes('C'))
            copyCoords(session, state.coords);
        if (!io.KeyShift && takes('V'))
            pasteCoords(session, state.coords);
        return;
    }
    if (takes('F'))
        fitPlane(session, state.coords);
    if (hasVertices && takes('A'))
        chooseAllOrNone(session, state);
    if (!session.look.selection.vertex || !hasVertices)
        return;
    for (const MoveRow& each : moveRows)
        if (!state.move && takes(each.key))
            beginKeyedMove(session, state, canvas, each.kind);
    glm::vec2 way{0};
    for (const auto& [code, step] : arrowKeys) {
        if (!takes(code, true))
            continue;
        if (isPressed(code)) // while held, it continues its undo step
            sealEdit(session);
        way += step;
    }
    if (way != glm::vec2{0})
        nudge(session, state.coords,
              way * (io.KeyShift ? glm::vec2(0.25F) : 1.0F / texelsOf(session, state)));
}

void pressOn(const Session& session, TextureSpaceState& state, const Canvas& canvas,
             const PlaneMouse& mouse) {
    const ImGuiIO& io = ImGui::GetIO();
    state.drag = PlaneDrag::Pan;
    state.pressed.reset();
    if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left) || state.coords.given().empty() || mouse.onPatch)
        return;
    if (!mouse.grip) {
        if (io.KeyShift != state.selects) {
            state.drag = PlaneDrag::Box;
            state.boxFrom = canvas.toCoord(io.MousePos);
        }
        return;
    }
    const std::size_t vertex = mouse.grip->vertex;
    const auto press = [vertex, toggles = io.KeyShift](Selection& pressed) {
        if (toggles)
            toggleVertex(pressed, vertex);
        else if (isChosen(pressed, vertex))
            pressed.vertex = vertex;
        else
            chooseVertices(pressed, {vertex});
    };
    Selection selection = session.look.selection;
    if (!io.KeyShift && isChosen(selection, vertex))
        state.pressed = vertex;
    press(selection);
    act(session, [press](Session& changed) { press(changed.look.selection); });
    state.drag = PlaneDrag::Vertices;
    if (!isChosen(selection, vertex))
        return;
    sealEdit(session);
    state.move = beginMove(selection, state.coords, MoveKind::Move, mouse.grip->result, vertex,
                           canvas.toCoord(io.MousePos));
}

void chooseInBox(const Session& session, const TextureSpaceState& state, const Canvas& canvas) {
    const glm::vec2 to = canvas.toCoord(ImGui::GetIO().MousePos);
    const glm::vec2 low = glm::min(state.boxFrom, to);
    const glm::vec2 high = glm::max(state.boxFrom, to);
    // In the selecting mode without Shift the box replaces the selection; otherwise it adds to it.
    std::vector<std::size_t> vertices = state.selects && !ImGui::GetIO().KeyShift
                                            ? std::vector<std::size_t>{}
                                            : chosenVertices(session.look.selection);
    const std::vector<glm::vec2>& places = state.coords.resultingPlaces();
    for (std::size_t vertex = 0; vertex < places.size(); ++vertex) {
        const glm::vec2 at = places[vertex];
        if (at.x >= low.x && at.y >= low.y && at.x <= high.x && at.y <= high.y)
            vertices.push_back(vertex);
    }
    choose(session, std::move(vertices));
}

void release(const Session& session, TextureSpaceState& state, const Canvas& canvas, bool onPatch) {
    const PlaneDrag drag = std::exchange(state.drag, PlaneDrag::None);
    if (state.move && !state.move->byKey)
        finishMove(session, state, true);
    const bool left = ImGui::IsMouseReleased(ImGuiMouseButton_Left);
    if (drag == PlaneDrag::Box && isDrag())
        chooseInBox(session, state, canvas);
    else if (drag == PlaneDrag::Vertices && state.pressed && !isDrag())
        choose(session, {*state.pressed});
    else if (drag == PlaneDrag::Pan && left && !isDrag() && !onPatch && !ImGui::GetIO().KeyShift &&
             !state.coords.given().empty())
        choose(session, {});
    sealEdit(session);
}

void movePlane(const Session& session, const Canvas& canvas, bool hovered, bool pans) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!pans && !(hovered && io.MouseWheel != 0))
        return;
    Plane plane = session.look.plane;
    if (pans) {
        plane.s -= io.MouseDelta.x / canvas.pixelsPerUnit;
        plane.t += io.MouseDelta.y / canvas.pixelsPerUnit;
    }
    if (hovered && io.MouseWheel != 0) {
        // The point under the mouse stays there.
        const glm::vec2 fixed = canvas.toCoord(io.MousePos);
        const float extent = std::clamp(plane.extent * std::pow(0.9F, io.MouseWheel), minPlane, maxPlane);
        const float factor = extent / plane.extent;
        plane.s = fixed.x + (plane.s - fixed.x) * factor;
        plane.t = fixed.y + (plane.t - fixed.y) * factor;
        plane.extent = extent;
    }
    act(session, [plane](Session& changed) { changed.look.plane = plane; });
}

/// Returns true if a click ended a move.
bool handleKeys(const Session& session, TextureSpaceState& state, const Canvas& canvas,
                const PlaneMouse& mouse) {
    if (state.move && isStale(session, state))
        state.move.reset();
    // In a dialog the mouse has other functions, and elsewhere the wheel edits something else.
    if (state.move && state.move->byKey && session.asking.dialog != Dialog::None)
        finishMove(session, state, false);
    else if (state.move && state.move->byKey && ImGui::GetIO().MouseWheel != 0 && !mouse.hovered)
        finishMove(session, state, true);
    if (state.move && state.move->byKey)
        return continueKeyedMove(session, state, canvas);
    if (state.move && isPressed(key::escape)) { // of a drag, which continues without them
        finishMove(session, state, false);
        session.out.keyTaken = true;
    }
    const bool free = !session.out.keyTaken && session.asking.dialog == Dialog::None &&
                      !ImGui::GetIO().WantTextInput && !ImGui::IsAnyItemActive();
    if (mouse.hovered && free)
        handleShortKeys(session, state, canvas);
    return false;
}

void handleMouse(const Session& session, TextureSpaceState& state, const Canvas& canvas,
                 const PlaneMouse& mouse) {
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActivated())
        pressOn(session, state, canvas, mouse);
    if (mouse.active && state.drag == PlaneDrag::Vertices && state.move && isDrag())
        followWithMove(session, state, canvas);
    if (!mouse.active && state.drag != PlaneDrag::None)
        release(session, state, canvas, mouse.onPatch);
    const bool dragged = mouse.active && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0);
    movePlane(session, canvas, mouse.hovered, dragged && state.drag == PlaneDrag::Pan);
    if (mouse.hovered && !mouse.grip && !mouse.onPatch && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
        fitPlane(session, state.coords);
}

} // namespace

bool isDrag() {
    const ImGuiIO& io = ImGui::GetIO();
    return io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] >= io.MouseDragThreshold * io.MouseDragThreshold;
}

std::optional<Grip> gripUnder(const Canvas& canvas, const Mesh& mesh, const PlaneCoords& coords,
                              std::optional<std::size_t> chosen, ImVec2 mouse) {
    const auto end = nearestOf(canvas, mesh, coords.resultingPlaces(), chosen, mouse);
    const auto given =
        coords.differ() ? nearestOf(canvas, mesh, coords.givenPlaces(), chosen, mouse) : std::nullopt;
    if (end && (!given || end->distance <= given->distance))
        return Grip{end->vertex, coords.differ()};
    return given ? std::optional(Grip{given->vertex, false}) : std::nullopt;
}

bool handlePlaneInput(const Session& session, TextureSpaceState& state, const Canvas& canvas,
                      const PlaneMouse& mouse) {
    const bool ended = handleKeys(session, state, canvas, mouse);
    if (!ended)
        handleMouse(session, state, canvas, mouse);
    return ended;
}

std::optional<Box> selectionBox(const TextureSpaceState& state, const Canvas& canvas) {
    if (state.drag != PlaneDrag::Box || !isDrag())
        return std::nullopt;
    const ImVec2 from = canvas.toPixel(state.boxFrom);
    const ImVec2 to = ImGui::GetIO().MousePos;
    return Box{{std::min(from.x, to.x), std::min(from.y, to.y)},
               {std::max(from.x, to.x), std::max(from.y, to.y)}};
}

} // namespace texplorer::ui
