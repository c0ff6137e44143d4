#include "app/ui/details/vertices_tab.h"

#include "app/ui/language/translate.h"
#include "app/ui/model/notice.h"
#include "app/ui/model/tex_coord_edits.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/model_choice.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/same_line.h"
#include "app/ui/widgets/theme.h"
#include "texplorer/scene/mesh_edits.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/sent_vertices.h"
#include "texplorer/scene/tex_coords.h"

#include <fmt/core.h>
#include <glm/glm.hpp>
#include <imgui_internal.h> // whether a number is being typed

#include <algorithm>
#include <utility>

namespace texplorer::ui {
namespace {

/// Longer lists draw only their visible rows.
constexpr std::size_t longList = 100;

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
    button("Reset", N_("Resets to the coordinates of the mesh"), "Reset coordinates",
           [](TexCoords& c) { c.clear(); });
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

void partButtons(const Session& session, VerticesTabState& state) {
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

/// The edited list while it is drawn.
struct List {
    const VertexPartRow& part;
    std::string path;
    const TexCoords& coords; ///< for VertexPart::Coordinates
    /// For VertexPart::Coordinates: whose coordinates each has (coordSources). Else empty.
    const std::vector<std::optional<std::uint32_t>>& sources;
    int components;
    bool together;
    std::optional<std::size_t>& revealed; ///< VerticesTabState's
};

/// Its row is in sight.
void chooseVertex(const Session& session, const List& list, std::size_t vertex) {
    list.revealed = vertex;
    act(session, [vertex](Session& changed) { changed.look.selection.vertex = vertex; });
}

glm::vec4 valueOf(const Session& session, const List& list, std::size_t vertex) {
    return list.part.read ? list.part.read(presentScene(session), *selectedModel(session), vertex)
                          : list.coords[vertex];
}

/// The letter of a component next to its colour on the left of the number, if there is room.
void nameField(const char* letter, int component) {
    const float em = ImGui::GetFontSize();
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    // A wide field has an arrow there, and its number is centred.
    const float left = low.x + em * (high.x - low.x < em * 6 ? 0.4F : 1.1F);
    if (ImGui::TempInputIsActive(ImGui::GetItemID()) || high.x - low.x < em * 4)
        return;
    ImGui::GetWindowDrawList()->AddText({left, low.y + ImGui::GetStyle().FramePadding.y},
                                        componentColor(component), letter);
    noteDrawn(fmt::format("field letter:{}", letter), {left, low.y}, {left + em, high.y});
}

/// The width of the column with the calls.
float callWidth() {
    return ImGui::CalcTextSize("glTexCoord").x;
}

/// A checkbox, and if the call is left out, whose coordinates the vertex has.
void callCell(const Session& session, const List& list, std::size_t vertex) {
    const std::optional<std::uint32_t> source = list.sources[vertex];
    bool sends = source == vertex;
    ImGui::TableNextColumn();
    if (ImGui::Checkbox("##call", &sends)) {
        chooseVertex(session, list, vertex);
        submitLeftOut(session, vertex, !sends);
    }
    item(fmt::format("glTexCoord:{}", vertex),
         "Off: the vertex is sent without glTexCoord. It has the coordinates of the vertex sent before it, "
         "whose number is shown; the first ones have 0, 0.");
    if (source == vertex)
        return;
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    plainText(source ? "= " + std::to_string(*source) : "= 0, 0", color::dim);
}

void vertexRow(const Session& session, const List& list, std::size_t vertex) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(static_cast<int>(vertex));
    const bool chosen = session.look.selection.vertex == vertex;
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, chosen ? color::chosen : color::dim);
    const std::string name = std::to_string(vertex);
    if (ImGui::Selectable(name.c_str(), chosen))
        chooseVertex(session, list, vertex);
    noteItem("vertex:" + name);
    ImGui::PopStyleColor();
    glm::vec4 value = valueOf(session, list, vertex);
    bool changed = false;
    const bool isLeftOut = !list.sources.empty() && list.sources[vertex] != vertex;
    if (isLeftOut) // kept for when it is sent again
        ImGui::PushStyleVar(ImGuiStyleVar_Alpha, ImGui::GetStyle().Alpha * 0.5F);
    for (int i = 0; i < list.components; ++i) {
        ImGui::TableNextColumn();
        ImGui::PushID(i);
        ImGui::SetNextItemWidth(-1);
        changed |= dragNumber("##number", value[i], list.part.range, i);
        nameField(list.part.names.at(static_cast<std::size_t>(i)), i);
        if (ImGui::IsItemActivated())
            chooseVertex(session, list, vertex);
        noteItem(fmt::format("{}[{}][{}]", list.path, name, i));
        sealAfterItem(session);
        ImGui::PopID();
    }
    if (isLeftOut)
        ImGui::PopStyleVar();
    if (!list.sources.empty())
        callCell(session, list, vertex);
    ImGui::PopID();
    if (!changed)
        return;
    const Selection& selection = session.look.selection;
    submitDrag(
        session, Sentence(list.part.edit, vertex),
        [&](Scene& scene) {
            Model& model = selectedModel(scene, selection);
            if (list.part.write)
                list.part.write(scene, model, vertex, value, list.together);
            else
                setTexCoord(model, selectedMesh(session), selection.unit, vertex, value);
        },
        list.path);
}

/// `reveal`: a row to scroll to.
void faceTable(const Session& session, const List& list, const std::vector<std::uint32_t>& vertices,
               std::optional<std::size_t> reveal) {
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_SizingStretchSame | ImGuiTableFlags_NoSavedSettings;
    const float top = ImGui::GetCursorPosY();
    const float height = ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().CellPadding.y;
    const bool hasCalls = !list.sources.empty();
    if (!ImGui::BeginTable("face", 1 + list.components + (hasCalls ? 1 : 0), flags))
        return;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFontSize() * 2.2F);
    for (int i = 0; i < list.components; ++i)
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    if (hasCalls)
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, callWidth());
    const auto rows = [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i)
            if (vertices[i] < list.coords.size())
                vertexRow(session, list, vertices[i]);
    };
    if (vertices.size() <= longList) {
        rows(0, vertices.size());
    } else {
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(vertices.size()), height);
        while (clipper.Step())
            rows(static_cast<std::size_t>(clipper.DisplayStart),
                 static_cast<std::size_t>(clipper.DisplayEnd));
    }
    ImGui::EndTable();
    if (reveal)
        ImGui::SetScrollFromPosY(top - ImGui::GetScrollY() + height * (static_cast<float>(*reveal) + 0.5F),
                                 0.5F);
}

/// The names of the columns in their colours.
void header(const List& list) {
    const float indent = ImGui::GetFontSize() * 2.2F + ImGui::GetStyle().CellPadding.x * 2;
    const float calls = list.sources.empty() ? 0 : callWidth() + ImGui::GetStyle().CellPadding.x * 2;
    const float room = ImGui::GetContentRegionAvail().x - indent - calls;
    const float width = room / static_cast<float>(list.components);
    for (int i = 0; i < list.components; ++i) {
        ImGui::SameLine(indent + width * (static_cast<float>(i) + 0.5F));
        plainText(list.part.names.at(static_cast<std::size_t>(i)), componentColor(i));
    }
    if (list.sources.empty())
        return;
    ImGui::SameLine(indent + room + ImGui::GetStyle().CellPadding.x);
    plainText("glTexCoord", color::dim);
}

/// Vertices that belong to no part of the primitive; they are not listed elsewhere.
std::vector<std::uint32_t> leftOver(const Mesh& mesh) {
    std::vector<bool> taken(mesh.vertices.size());
    for (const Face& face : mesh.faces)
        for (const std::uint32_t vertex : face.vertices)
            taken[vertex] = true;
    std::vector<std::uint32_t> rest;
    for (std::uint32_t vertex = 0; vertex < taken.size(); ++vertex)
        if (!taken[vertex])
            rest.push_back(vertex);
    return rest;
}

void vertexGroup(const Session& session, const List& list, const Sentence& name,
                 const std::vector<std::uint32_t>& vertices, bool opened, bool reveal) {
    std::optional<std::size_t> chosenRow;
    if (const auto& chosen = session.look.selection.vertex) {
        const auto found = std::ranges::find(vertices, static_cast<std::uint32_t>(*chosen));
        if (found != vertices.end())
            chosenRow = static_cast<std::size_t>(found - vertices.begin());
    }
    if (reveal && chosenRow)
        ImGui::SetNextItemOpen(true);
    const ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen |
                                     (opened ? ImGuiTreeNodeFlags_DefaultOpen : 0) |
                                     (chosenRow ? ImGuiTreeNodeFlags_Selected : 0);
    if (chosenRow)
        ImGui::PushStyleColor(ImGuiCol_Text, color::chosen);
    const bool open = ImGui::TreeNodeEx(label(name).c_str(), flags);
    if (chosenRow)
        ImGui::PopStyleColor();
    noteItem("face:" + name.english());
    if (open)
        faceTable(session, list, vertices, reveal ? chosenRow : std::nullopt);
}

} // namespace

void drawVerticesTab(const Session& session, VerticesTabState& state) {
    if (!selectedModel(session)) {
        wrappedText("The scene has no model.");
        return;
    }
    const float checkbox =
        ImGui::CalcTextSize("r, q").x + ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x;
    const float room = ImGui::GetContentRegionAvail().x - checkbox - ImGui::GetStyle().ItemSpacing.x;
    const float min = ImGui::GetFontSize() * 9;
    modelChoice(session, min, std::max(min, room));
    ImGui::SameLine(ImGui::GetContentRegionMax().x - checkbox);
    bool showRq = session.window.showRq;
    if (ImGui::Checkbox("r, q", &showRq))
        act(session, [showRq](Session& changed) { changed.window.showRq = showRq; });
    item("show r, q", "Shows the third and fourth coordinate: r for volumes, q for projected textures");
    partButtons(session, state);
    const bool own = selectedModel(session)->shape == Shape::Mesh;
    const VertexPartRow& part = rowOf(own ? state.part : VertexPart::Coordinates);
    const std::string path = part.path(session);
    const Finding* idle = idleReasonOf(session.document.findings, path);
    if (idle) {
        dimText(Sentence("No effect now: {0}.", idle->sentence));
        noteItem("coordinates#inert");
    }

    const Mesh& mesh = selectedMesh(session);
    const TexCoords coords = effectiveTexCoords(*selectedModel(session), mesh, session.look.selection.unit);
    const auto usesRq = [](const glm::vec4& each) { return each.z != 0 || each.w != 1; };
    const bool two = part.part == VertexPart::Coordinates && !showRq && std::ranges::none_of(coords, usesRq);
    std::vector<std::optional<std::uint32_t>> sources;
    if (part.part == VertexPart::Coordinates)
        sources = coordSources(*selectedModel(session), mesh, session.look.selection.unit);
    const List list{part, path, coords, sources, two ? 2 : part.components, state.together, state.revealed};
    ImGui::BeginChild("vertices");
    if (idle)
        ImGui::PushStyleVar(ImGuiStyleVar_Alpha, ImGui::GetStyle().Alpha * 0.6F);
    ImGui::Dummy({0, 0});
    header(list);
    const bool reveal =
        std::exchange(state.revealed, session.look.selection.vertex) != session.look.selection.vertex;
    const bool few = mesh.faces.size() <= 6;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        vertexGroup(session, list, mesh.faces[i].name, mesh.faces[i].vertices, few, reveal);
        ImGui::PopID();
    }
    if (const std::vector<std::uint32_t> rest = own ? leftOver(mesh) : std::vector<std::uint32_t>{};
        !rest.empty())
        vertexGroup(session, list, N_("Not drawn"), rest, true, reveal);
    if (idle)
        ImGui::PopStyleVar();
    ImGui::EndChild();
}

} // namespace texplorer::ui
