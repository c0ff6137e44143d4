#pragma once

#include "app/ui/model/session.h"
#include "texplorer/scene/params/params.h"

#include <glm/vec4.hpp>

#include <array>
#include <optional>
#include <string>

namespace texplorer::ui {

/// The values of vertices that the list shows. Shapes other than meshes have only editable coordinates.
enum class VertexPart : std::uint8_t { Coordinates, Position, Normal, Color };

/// One part of the vertex values, as four numbers of which some are used.
struct VertexPartRow {
    VertexPart part;
    const char* label;
    std::array<const char*, 4> names; ///< the column headings
    int components;
    Range range;
    std::string (*path)(const Session& session);
    glm::vec4 (*read)(const Scene& scene, const Model& model, std::size_t vertex);
    void (*write)(const Scene& scene, Model& model, std::size_t vertex, glm::vec4 value, bool together);
    Sentence::Key<std::size_t> edit; ///< the name in Undo, with the vertex
    const char* help;
};

[[nodiscard]] const VertexPartRow& rowOf(VertexPart part);

/// A list of the selected model's mesh.
[[nodiscard]] std::string meshPath(const Session& session, const std::string& key);

/// The state of the tab.
struct VerticesTabState {
    std::optional<std::size_t> revealed; ///< the vertex that the list was already scrolled to
    std::string shownParam;              ///< Look's, when the list was last drawn
    VertexPart part = VertexPart::Coordinates;
    bool together = true; ///< vertices at one place move together
};

/// What changes the selected model, or all of its coordinates.
void drawVertexButtons(const Session& session, VerticesTabState& state);

void drawVerticesTab(const Session& session, VerticesTabState& state);

} // namespace texplorer::ui
