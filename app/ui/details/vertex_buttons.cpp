// The buttons above the list of vertices.

#include "app/ui/details/vertices_tab.h"
#include "app/ui/language/translate.h"
#include "app/ui/model/notice.h"
#include "app/ui/model/tex_coord_edits.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/same_line.h"
#include "texplorer/scene/mesh_edits.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/tex_coords.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace texplorer::ui {
namespace {

/// Buttons in a row that continue in the next line at the panel's edge.
class ButtonLine {
public:
    bool button(const char* words, std::string_view name, const char* help, bool enabled = true) {
        place(buttonWidth(words));
        return ui::button(words, name, help, enabled);
    }

    /// A button of a choice.
    bool choice(const char* words, std::string_view name, const char* help, bool chosen) {
        place(buttonWidth(words));
        const bool pressed = markedButton(label(words), chosen);
        item(name, help);
        return pressed;
    }

    void checkbox(const char* words, std::string_view name, const char* help, bool& value) {
        place(ImGui::CalcTextSize(tr(words)).x + ImGui::GetFrameHeight() +
              ImGui::GetStyle().ItemInnerSpacing.x);
        ImGui::Checkbox(label(words), &value);
        item(name, help);
    }

private:
    void place(float width) {
        if (!first_)
            sameLineFor(width, ImGui::GetStyle().ItemInnerSpacing.x);
        first_ = false;
    }

    bool first_ = true;
};

void coordButtons(const Session& session, ButtonLine& line) {
    const auto button = [&](const char* words, const char* help, const char* what, auto&& edit) {
        if (!line.button(words, std::string("coords:") + words, help))
            return;
        TexCoords coords =
            effectiveTexCoords(*selectedModel(session), selectedMesh(session), session.look.selection.unit);
        edit(coords);
        submitTexCoords(session, what, std::move(coords));
    };
    button("× 2", N_("Multiplies all coordinates by 2: the image appears twice as often at half the size"),
           "Coordinates × 2", [](TexCoords& c) { scaleCoords(c, 2); });
    button("÷ 2", N_("Divides all coordinates by 2"), "Coordinates ÷ 2",
           [](TexCoords& c) { scaleCoords(c, 0.5F); });
    button("Flip s", N_("s becomes 1 − s"), "Flip s", flipS);
    button("Flip t", N_("t becomes 1 − t"), "Flip t", flipT);
    button("90°", N_("Rotates all coordinates by 90° about (0.5, 0.5)"), "Rotate coordinates", rotateQuarter);
    if (line.button("Reset", "coords:Reset",
                    "Resets to the coordinates of the mesh, and sends all glTexCoord calls"))
        resetTexCoords(session);
}

/// Shows the positions of its vertices, which are edited most.
void makeMesh(const Session& session, VerticesTabState& state) {
    const Selection& selection = session.look.selection;
    Result<void> made;
    submit(
        session, "Make it a mesh",
        [&](Scene& scene) { made = turnIntoMesh(selectedModel(scene, selection)); },
        fmt::format("{}.{}", elementOf<&Scene::models>(static_cast<std::size_t>(selection.model)),
                    keyOf<&Model::shape>()));
    if (!made)
        return act(session, [error = made.error()](Session& s) { say(s, error); });
    state.part = VertexPart::Position;
}

/// Adds and removes vertices, in all lists and in the order.
void vertexButtons(const Session& session, ButtonLine& line) {
    const Model& model = *selectedModel(session);
    const std::optional<std::size_t> chosen = session.look.selection.vertex;
    const std::size_t count = model.mesh.positions.size();
    const bool isChosen = chosen && *chosen < count;
    const auto change = [&](const char* what, std::optional<std::size_t> next, auto&& edit) {
        const Selection& selection = session.look.selection;
        auto step = stepThat(
            session, what, [&](Scene& scene) { edit(selectedModel(scene, selection)); },
            meshPath(session, keyOf<&MeshData::positions>()));
        step.select = selection;
        step.select->vertex = next;
        submit(session, std::move(step));
    };
    const bool room = count < maxMeshVertices && model.mesh.indices.size() < maxMeshIndices;
    if (line.button("Append", N_("add vertex"),
                    "Adds a copy of the selected vertex, or the last one, at the end", room))
        change(N_("Add vertex"), count,
               [&](Model& edited) { appendVertex(edited, isChosen ? *chosen : count - 1); });
    if (line.button("Duplicate", N_("duplicate vertex"),
                    "Adds a copy of the selected vertex right after it, a new point of a strip or polygon",
                    room && isChosen))
        change(N_("Duplicate vertex"), *chosen + 1, [&](Model& edited) { duplicateVertex(edited, *chosen); });
    if (line.button("Remove", N_("remove vertex"),
                    "Removes the selected vertex. With indices, also removes its triangles", isChosen))
        change(N_("Remove vertex"), count == 1 ? std::nullopt : std::optional(std::min(*chosen, count - 2)),
               [&](Model& edited) { removeVertex(edited, *chosen); });
}

/// Removes an optional list of vertex values.
template<auto List>
void clearButton(const Session& session, ButtonLine& line, const VertexPartRow& part, const char* help) {
    const bool isEmpty = (selectedModel(session)->mesh.*List).empty();
    if (line.button("Clear", std::string("clear ") + part.label, help, !isEmpty))
        submit(
            session, Sentence("Clear {0}", part.label),
            [&](Scene& scene) { (selectedModel(scene, session.look.selection).mesh.*List).clear(); },
            part.path(session));
}

} // namespace

void drawVertexButtons(const Session& session, VerticesTabState& state) {
    ButtonLine line;
    if (selectedModel(session)->shape != Shape::Mesh) {
        coordButtons(session, line);
        if (line.button("Make it a mesh", N_("make mesh"),
                        "Converts the model to a mesh with the same vertices, which can be edited"))
            makeMesh(session, state);
        return;
    }
    for (const VertexPart part :
         {VertexPart::Coordinates, VertexPart::Position, VertexPart::Normal, VertexPart::Color}) {
        const VertexPartRow& row = rowOf(part);
        if (line.choice(row.label, std::string("show ") + row.label, row.help, state.part == part))
            state.part = part;
    }
    line = {};
    if (state.part == VertexPart::Coordinates)
        return coordButtons(session, line);
    vertexButtons(session, line);
    if (state.part == VertexPart::Position)
        line.checkbox(N_("Together"), N_("move together"), N_("Moves vertices at the same place together"),
                      state.together);
    else if (state.part == VertexPart::Normal)
        clearButton<&MeshData::normals>(session, line, rowOf(state.part),
                                        N_("Removes all normals: the surface faces +z"));
    else
        clearButton<&MeshData::colors>(session, line, rowOf(state.part),
                                       N_("Removes all colours: the material's colour is used"));
}

} // namespace texplorer::ui
