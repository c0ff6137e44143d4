#include "app/ui/details/vertices_tab.h"

#include "app/ui/model/tex_coord_edits.h"
#include "app/ui/widgets/button_width.h"
#include "app/ui/widgets/model_choice.h"
#include "app/ui/widgets/param_tips.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/theme.h"
#include "core/scene/tex_coords.h"

#include <fmt/core.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <utility>

namespace texplorer::ui {
namespace {

std::string coordsPath(const Session& session) {
    return fmt::format("models[{}].texCoords{}", session.window.selection.model,
                       session.window.selection.unit);
}

void editAll(Session& session, const char* what, const std::function<void(TexCoords&)>& edit) {
    Model& model = *selectedModel(session);
    const int unit = session.window.selection.unit;
    TexCoords coords = effectiveTexCoords(model, selectedMesh(session), unit);
    edit(coords);
    for (glm::vec4& each : coords)
        each = glm::clamp(each, coordRange.min, coordRange.max);
    model.texCoords[static_cast<std::size_t>(unit)] = std::move(coords);
    sealEdit(session);
    recordEdit(session, what, coordsPath(session));
    sealEdit(session);
}

void editButtons(Session& session) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    bool first = true;
    const auto button = [&](const char* label, const char* help) {
        const float width = buttonWidth(label);
        if (!first) {
            ImGui::SameLine(0, gap);
            if (ImGui::GetContentRegionAvail().x <
                width) // goes on in the next line rather than off the panel
                ImGui::NewLine();
        }
        first = false;
        const bool pressed = ImGui::Button(label);
        noteItem(std::string("coords:") + label);
        helpTip(help);
        return pressed;
    };
    if (button("× 2", "All coordinates times 2: the image shows twice as often, half as big"))
        editAll(session, "Coordinates × 2", [](TexCoords& c) { scaleCoords(c, 2); });
    if (button("÷ 2", "All coordinates by 2"))
        editAll(session, "Coordinates ÷ 2", [](TexCoords& c) { scaleCoords(c, 0.5F); });
    if (button("Flip s", "s becomes 1 − s"))
        editAll(session, "Flip s", flipS);
    if (button("Flip t", "t becomes 1 − t"))
        editAll(session, "Flip t", flipT);
    if (button("90°", "Turns all coordinates by 90° about (0.5, 0.5)"))
        editAll(session, "Rotate coordinates", rotateQuarter);
    if (button("Reset", "Back to the coordinates of the mesh")) {
        selectedModel(session)->texCoords[static_cast<std::size_t>(session.window.selection.unit)].clear();
        sealEdit(session);
        recordEdit(session, "Reset coordinates", coordsPath(session));
        sealEdit(session);
    }
}

void vertexRow(Session& session, const TexCoords& coords, std::size_t vertex, int components) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(static_cast<int>(vertex));
    const bool chosen = session.window.selection.vertex == vertex;
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, chosen ? color::chosen : color::dim);
    const std::string name = std::to_string(vertex);
    if (ImGui::Selectable(name.c_str(), chosen))
        session.window.selection.vertex = vertex;
    noteItem("vertex:" + name);
    ImGui::PopStyleColor();
    glm::vec4 value = coords[vertex];
    bool changed = false;
    for (int i = 0; i < components; ++i) {
        ImGui::TableNextColumn();
        ImGui::PushID(i);
        ImGui::SetNextItemWidth(-1);
        changed |= dragNumber("##coord", value[i], coordRange, i);
        if (ImGui::IsItemActivated())
            session.window.selection.vertex = vertex;
        noteItem(fmt::format("{}[{}][{}]", coordsPath(session), name, i));
        sealAfterItem(session);
        ImGui::PopID();
    }
    ImGui::PopID();
    if (changed) {
        setTexCoord(*selectedModel(session), selectedMesh(session), session.window.selection.unit, vertex,
                    value);
        recordEdit(session, "Move vertex " + name, coordsPath(session));
    }
}

void faceTable(Session& session, const Face& face, const TexCoords& coords, int components) {
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_SizingStretchSame | ImGuiTableFlags_NoSavedSettings;
    if (!ImGui::BeginTable("face", 1 + components, flags))
        return;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFontSize() * 2.2F);
    for (int i = 0; i < components; ++i)
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    for (const std::uint32_t vertex : face.vertices) {
        if (vertex < coords.size())
            vertexRow(session, coords, vertex, components);
    }
    ImGui::EndTable();
}

/// "s  t  r  q" over the columns, each in its colour.
void header(int components) {
    constexpr const char* names[] = {"s", "t", "r", "q"};
    const float indent = ImGui::GetFontSize() * 2.2F + ImGui::GetStyle().CellPadding.x * 2;
    const float width = (ImGui::GetContentRegionAvail().x - indent) / static_cast<float>(components);
    for (int i = 0; i < components; ++i) {
        ImGui::SameLine(indent + width * (static_cast<float>(i) + 0.5F));
        ImGui::PushStyleColor(ImGuiCol_Text, componentColor(i));
        ImGui::TextUnformatted(names[i]);
        ImGui::PopStyleColor();
    }
}

} // namespace

void drawVerticesTab(Session& session, VerticesTabState& state) {
    if (!selectedModel(session)) {
        ImGui::TextWrapped("The scene has no model.");
        return;
    }
    modelChoice(session, ImGui::GetFontSize() * 9);
    const float checkbox =
        ImGui::CalcTextSize("r, q").x + ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SameLine(ImGui::GetContentRegionMax().x - checkbox);
    ImGui::Checkbox("r, q", &session.window.showRq);
    noteItem("show r, q");
    helpTip("Shows the third and fourth coordinate: r for volumes, q for projected textures");
    editButtons(session);
    const Finding* idle = idleReasonOf(session.document.findings, coordsPath(session));
    if (idle) {
        dimText(fmt::format("No effect now: {}.", idle->sentence));
        noteItem("coordinates#inert");
    }

    const Mesh& mesh = selectedMesh(session);
    const TexCoords coords = effectiveTexCoords(*selectedModel(session), mesh, session.window.selection.unit);
    const auto usesRq = [](const glm::vec4& each) { return each.z != 0 || each.w != 1; };
    const int components = session.window.showRq || std::ranges::any_of(coords, usesRq) ? 4 : 2;
    ImGui::BeginChild("vertices");
    if (idle)
        ImGui::PushStyleVar(ImGuiStyleVar_Alpha, ImGui::GetStyle().Alpha * 0.6F);
    ImGui::Dummy({0, 0});
    header(components);
    const bool reveal = session.window.selection.vertex != state.revealed;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        const Face& face = mesh.faces[i];
        const bool holdsChosen =
            session.window.selection.vertex &&
            std::ranges::find(face.vertices, static_cast<std::uint32_t>(*session.window.selection.vertex)) !=
                face.vertices.end();
        if (reveal && holdsChosen)
            ImGui::SetNextItemOpen(true);
        ImGui::PushID(static_cast<int>(i));
        constexpr ImGuiTreeNodeFlags flags =
            ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen;
        const bool few = mesh.faces.size() <= 6;
        if (holdsChosen)
            ImGui::PushStyleColor(ImGuiCol_Text, color::chosen);
        const bool open =
            ImGui::TreeNodeEx(face.name.c_str(), flags | (few ? ImGuiTreeNodeFlags_DefaultOpen : 0));
        if (holdsChosen)
            ImGui::PopStyleColor();
        noteItem("face:" + face.name);
        if (open)
            faceTable(session, face, coords, components);
        if (reveal && holdsChosen)
            ImGui::SetScrollHereY(0.5F);
        ImGui::PopID();
    }
    state.revealed = session.window.selection.vertex;
    if (idle)
        ImGui::PopStyleVar();
    ImGui::EndChild();
}

} // namespace texplorer::ui
