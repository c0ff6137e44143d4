#pragma once

#include "app/ui/model/session.h"
#include "app/ui/texture_space/plane_coords.h"
#include "app/ui/texture_space/plane_drawing.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::ui {

/// Where moved vertices come to rest.
enum class Snap : std::uint8_t { Texel, Quarter, Whole };

struct SnapRow {
    Snap snap;
    const char* label;
    const char* help;
};

inline constexpr std::array snapRows{
    SnapRow{Snap::Texel, "Texels", "Vertices come to rest on the edges of texels"},
    SnapRow{Snap::Quarter, "Quarters", "Vertices come to rest on multiples of 1/4"},
    SnapRow{Snap::Whole, "0 and 1", "0 and 1 attract vertices that come near"},
};

/// Whether vertices snap, and to what. Ctrl inverts it while it is held.
struct Snapping {
    bool on = false;
    Snap to = Snap::Texel;
};

/// What is done to the chosen vertices.
enum class MoveKind : std::uint8_t { Move, Rotate, Scale };

/// The chosen vertices while they are moved: by a drag, or by the mouse alone after a key.
struct VertexMove {
    MoveKind kind = MoveKind::Move;
    bool byKey = false;
    bool results = false;                ///< what is moved is where the coordinates end
    std::vector<std::size_t> vertices{}; ///< ascending
    std::vector<glm::vec2> places{};     ///< of those, as they were
    std::size_t held = 0;                ///< the one that snaps
    glm::vec2 heldPlace{0};              ///< as it was
    glm::vec2 from{0};                   ///< where the mouse was, in the plane
    glm::vec2 centre{0};                 ///< of turning and scaling
    std::optional<int> axis{};           ///< 0: s alone changes, 1: t alone
    int model = 0;
    int unit = 0;
    bool recorded = false; ///< there is a step to take back
    std::string refusal{}; ///< why nothing moves; empty: it does
};

/// How many texels an axis of the plane's picture has.
using TexelCounts = glm::vec2;

/// Begins to move the chosen vertices; nothing where none is chosen. `mouse` in the plane.
[[nodiscard]] std::optional<VertexMove> beginMove(const Session& session, const PlaneCoords& coords,
                                                  MoveKind kind, bool results, std::size_t held,
                                                  glm::vec2 mouse);

/// Moves them to where the mouse is, as one step of undo. `magnet`: how near 0 and 1 attract.
void followMouse(Session& session, const PlaneCoords& coords, VertexMove& move, glm::vec2 mouse,
                 const Snapping& snapping, TexelCounts texels, float magnet);

/// Keeps what the move did, or takes it back.
void endMove(Session& session, const VertexMove& move, bool keep);

/// A place that vertices come to rest at.
[[nodiscard]] glm::vec2 snapped(glm::vec2 place, Snap snap, TexelCounts texels, float magnet);

/// What buttons and menus are about: the chosen vertices where there are two or more, else all.
[[nodiscard]] std::vector<std::size_t> editedVertices(Session& session);

/// Moves the chosen vertices by a way in the plane.
void nudge(Session& session, const PlaneCoords& coords, glm::vec2 way);

/// Mirrors the edited vertices about their middle: `axis` 0 takes s from left to right, 1 turns t upside
/// down.
void mirrorVertices(Session& session, const PlaneCoords& coords, int axis);

/// Gives vertices other coordinates, as one step of undo.
void replaceCoords(Session& session, TexCoords coords, std::string_view what);

} // namespace texplorer::ui
