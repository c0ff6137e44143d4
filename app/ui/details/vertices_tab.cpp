#include "app/ui/details/vertices_tab.h"

#include "app/ui/language/translate.h"
#include "app/ui/model/findings.h"
#include "app/ui/model/tex_coord_edits.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/model_choice.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/theme.h"
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

/// The width of the column with the calls: in a narrow list that of a checkbox.
float callWidth(const List& list) {
    const float em = ImGui::GetFontSize();
    const float width = ImGui::CalcTextSize("glTexCoord").x;
    const float room = ImGui::GetWindowWidth() - width - 5 * em;
    return room / static_cast<float>(list.components) < 5 * em ? ImGui::GetFrameHeight() : width;
}

/// The width of the column with the numbers of vertices.
float numberWidth(const List& list) {
    return std::max(ImGui::GetFontSize() * 2.2F,
                    ImGui::CalcTextSize(std::to_string(list.coords.size()).c_str()).x);
}

bool isNarrow(const List& list) {
    return callWidth(list) <= ImGui::GetFrameHeight();
}

/// A checkbox, and if the call is left out, whose coordinates the vertex has.
void callCell(const Session& session, const List& list, std::size_t vertex) {
    const std::optional<std::uint32_t> source = list.sources[vertex];
    const std::vector<int>& leftOut =
        selectedModel(session)->noTexCoord[static_cast<std::size_t>(session.look.selection.unit)];
    bool sends = std::ranges::find(leftOut, static_cast<int>(vertex)) == leftOut.end();
    ImGui::TableNextColumn();
    if (ImGui::Checkbox("##call", &sends)) {
        chooseVertex(session, list, vertex);
        submitLeftOut(session, vertex, !sends);
    }
    item(fmt::format("glTexCoord:{}", vertex),
         "Off: the vertex is sent without glTexCoord. It has the coordinates of the vertex sent before it; "
         "the first ones have 0, 0.");
    if (source == vertex || isNarrow(list))
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
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, numberWidth(list));
    for (int i = 0; i < list.components; ++i)
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    if (hasCalls)
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, callWidth(list));
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
    const float indent = numberWidth(list) + ImGui::GetStyle().CellPadding.x * 2;
    const float calls = list.sources.empty() ? 0 : callWidth(list) + ImGui::GetStyle().CellPadding.x * 2;
    const float room = ImGui::GetContentRegionAvail().x - indent - calls;
    const float width = room / static_cast<float>(list.components);
    for (int i = 0; i < list.components; ++i) {
        ImGui::SameLine(indent + width * (static_cast<float>(i) + 0.5F));
        plainText(list.part.names.at(static_cast<std::size_t>(i)), componentColor(i));
    }
    if (list.sources.empty() || isNarrow(list))
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
    const ImGuiTreeNodeFlags flags =
        nodeHeight() | ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen |
        (opened ? ImGuiTreeNodeFlags_DefaultOpen : 0) | (chosenRow ? ImGuiTreeNodeFlags_Selected : 0);
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
    drawVertexButtons(session, state);
    const std::string& shown = session.look.shownParam;
    if (std::exchange(state.shownParam, shown) != shown && isOfCoords(shown)) {
        state.part = VertexPart::Coordinates;
        state.revealed.reset();
    }
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
