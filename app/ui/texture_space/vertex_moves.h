#pragma once

#include "app/ui/model/session.h"
#include "app/ui/texture_space/plane_coords.h"
#include "texplorer/base/sentence.h"

#include <array>
#include <optional>
#include <vector>

namespace texplorer::ui {

/// The grid that moved vertices snap to.
enum class Snap : std::uint8_t { Texel, Quarter, Whole };

struct SnapRow {
    Snap snap;
    const char* label;
    const char* help;
};

inline constexpr std::array snapRows{
    SnapRow{Snap::Texel, N_("Texels"), N_("Vertices snap to the edges of texels")},
    SnapRow{Snap::Quarter, N_("Quarters"), N_("Vertices snap to multiples of 1/4")},
    SnapRow{Snap::Whole, N_("0 and 1"), N_("Vertices snap to 0 and 1")},
};

/// Whether vertices snap, and to which grid. Holding Ctrl inverts it.
struct Snapping {
    bool on = false;
    Snap to = Snap::Texel;
};

/// The kind of move.
enum class MoveKind : std::uint8_t { Move, Rotate, Scale };

struct MoveRow {
    MoveKind kind;
    int key;
    Sentence::Key<std::size_t> one;  ///< the name in Undo, with the vertex's number
    Sentence::Key<std::size_t> many; ///< with the number of vertices
    Sentence::Key<std::size_t> hint; ///< with that number, too
};

inline constexpr std::array moveRows{
    MoveRow{MoveKind::Move, 'G', N_("Move vertex {0}"), N_("Move {0} vertices"),
            N_("Moving {0} · S, T: one axis · Enter confirms, Escape cancels")},
    MoveRow{MoveKind::Rotate, 'R', N_("Rotate vertex {0}"), N_("Rotate {0} vertices"),
            N_("Rotating {0} · Enter confirms, Escape cancels")},
    MoveRow{MoveKind::Scale, 'S', N_("Scale vertex {0}"), N_("Scale {0} vertices"),
            N_("Scaling {0} · S, T: one axis · Enter confirms, Escape cancels")},
};

[[nodiscard]] inline const MoveRow& rowOf(MoveKind kind) {
    return moveRows[static_cast<std::size_t>(kind)];
}

/// The selected vertices while they are moved: by a drag, or by the mouse alone after a key.
struct VertexMove {
    MoveKind kind = MoveKind::Move;
    bool byKey = false;
    bool results = false;                ///< moves their final positions
    std::vector<std::size_t> vertices{}; ///< ascending
    std::vector<glm::vec2> places{};     ///< their original places
    std::size_t held = 0;                ///< the one that snaps
    glm::vec2 heldPlace{0};              ///< its original place
    glm::vec2 from{0};                   ///< the mouse at the start, in the plane
    glm::vec2 centre{0};                 ///< for rotation and scaling
    std::optional<int> axis{};           ///< 0: only s changes, 1: only t
    int model = 0;
    int unit = 0;
    bool submitted = false; ///< there is an undo step to drop
    Sentence refusal{};     ///< why nothing moves; empty: it does
};

/// The number of texels along each axis of the plane's picture.
using TexelCounts = glm::vec2;

/// Starts a move of the selected vertices; nothing if none is selected. `mouse` is in the plane.
[[nodiscard]] std::optional<VertexMove> beginMove(const Selection& selection, const PlaneCoords& coords,
                                                  MoveKind kind, bool results, std::size_t held,
                                                  glm::vec2 mouse);

/// Moves them to the mouse, as one undo step. `magnet`: the distance at which 0 and 1 attract.
void followMouse(const Session& session, const PlaneCoords& coords, VertexMove& move, glm::vec2 mouse,
                 const Snapping& snapping, TexelCounts texels, float magnet);

/// Keeps the move or undoes it.
void endMove(const Session& session, const VertexMove& move, bool keep);

/// The nearest place on the grid.
[[nodiscard]] glm::vec2 snapped(glm::vec2 place, Snap snap, TexelCounts texels, float magnet);

/// The vertices that buttons and menus edit: the selected ones if there are two or more, else all.
[[nodiscard]] std::vector<std::size_t> editedVertices(const Session& session);

/// Moves the selected vertices by an offset in the plane.
void nudge(const Session& session, const PlaneCoords& coords, glm::vec2 way);

/// Mirrors the edited vertices about their middle: `axis` 0 exchanges left and right in s, 1 turns t upside
/// down.
void mirrorVertices(const Session& session, const PlaneCoords& coords, int axis);

} // namespace texplorer::ui
