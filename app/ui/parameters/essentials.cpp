#include "app/ui/language/translate.h"
#include "app/ui/model/tex_coord_edits.h"
#include "app/ui/parameters/sections.h"
#include "app/ui/state/pinned.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/model_choice.h"
#include "app/ui/widgets/param_names.h"
#include "texplorer/base/translatable.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/sent_vertices.h"
#include "texplorer/scene/tex_coords.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace texplorer::ui {
namespace {

const ParamRow& essentialRow(const StructTable& table, std::string_view key) {
    return *findParam(table, key); // keys of existing rows
}

void stepVertex(const Session& session, bool forwards) {
    const std::size_t count = selectedMesh(session).vertices.size();
    const std::optional<std::size_t> vertex = session.look.selection.vertex;
    const std::size_t next = vertex ? (*vertex + 1) % count : 0;
    const std::size_t previous = vertex && *vertex > 0 ? *vertex - 1 : count - 1;
    act(session, [to = forwards ? next : previous](Session& changed) { changed.look.selection.vertex = to; });
}

/// s and t of the selected vertex as draggable numbers.
void vertexNumbers(const Session& session, float width) {
    const Selection& selection = session.look.selection;
    const std::size_t vertex = *selection.vertex;
    const Mesh& mesh = selectedMesh(session);
    glm::vec4 value = effectiveTexCoord(*selectedModel(session), mesh, selection.unit, vertex);
    constexpr std::array names{N_("vertex s"), N_("vertex t")};
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const bool isLeftOut = coordSource(*selectedModel(session), mesh, selection.unit, vertex) != vertex;
    if (isLeftOut)
        ImGui::PushStyleVar(ImGuiStyleVar_Alpha, ImGui::GetStyle().Alpha * 0.5F);
    for (int i = 0; i < 2; ++i) {
        ImGui::PushID(i);
        plainText(i == 0 ? "s" : "t", componentColor(i));
        ImGui::SameLine(0, gap / 2);
        ImGui::SetNextItemWidth(std::max(1.0F, width - ImGui::GetFontSize() * 0.6F - gap / 2));
        if (dragNumber("##coordinate", value[i], coordRange, i)) {
            submitDrag(
                session, Sentence("Move vertex {0}", vertex),
                [&](Scene& scene) {
                    setTexCoord(selectedModel(scene, selection), mesh, selection.unit, vertex, value);
                },
                fmt::format("models[{}].texCoords{}", selection.model, selection.unit));
        }
        noteItem(names.at(static_cast<std::size_t>(i)));
        sealAfterItem(session);
        if (isLeftOut)
            helpTip(Sentence("glTexCoord of vertex {0} is left out: its coordinate has no effect", vertex));
        else
            helpTip(i == 0
                        ? "The vertex's s: 0 is the left edge of the image, 1 the right edge. Drag it, or "
                          "double-click to type a number."
                        : N_("The vertex's t: 0 is the lower edge of the image, 1 the upper edge. Drag it, "
                             "or double-click to type a number."));
        ImGui::PopID();
        if (i == 0)
            ImGui::SameLine(0, gap);
    }
    if (isLeftOut)
        ImGui::PopStyleVar();
}

void vertexLine(const Session& session) {
    const Model* model = selectedModel(session);
    const std::size_t count = selectedMesh(session).vertices.size();
    const std::optional<std::size_t> vertex = session.look.selection.vertex;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    labelText(N_("Vertex"), vertex ? color::chosen : color::text);
    if (model && count > 0)
        helpTip(Sentence("Vertex 0 to {0} of model {1} ({2})", count - 1, session.look.selection.model,
                         shownNameOf(*model)));
    ImGui::SameLine(0, gap);
    if (squareButton("◀", N_("previous vertex"), "The previous vertex", count > 0))
        stepVertex(session, false);
    ImGui::SameLine(0, gap / 2);
    if (vertex) {
        const std::string number = std::to_string(*vertex);
        plainText(number, color::chosen);
        noteItem("vertex number");
        ImGui::SameLine(0, gap / 2);
    }
    if (squareButton("▶", N_("next vertex"), "The next vertex", count > 0))
        stepVertex(session, true);
    ImGui::SameLine(0, gap);
    if (!vertex || count == 0) {
        constexpr const char* how = N_("Click a vertex in either view.");
        const float room = ImGui::GetContentRegionAvail().x;
        if (wrappedSize(tr(how), room).y > ImGui::GetFontSize() * 2.5F)
            ImGui::NewLine(); // instead of a word or a letter in each line
        dimWrappedText(how);
        noteItem("no vertex");
        return;
    }
    vertexNumbers(session, std::floor((ImGui::GetContentRegionAvail().x - gap) / 2));
}

/// "s [Repeat] [Mirror] …": the letter in its colour, and the choices to the right of it.
void wrapLine(const Session& session, const Owner& owner, const ParamRow& row, int axis) {
    constexpr std::array letters{"s", "t", "r"};
    ImGui::AlignTextToFramePadding();
    plainText(letters.at(static_cast<std::size_t>(axis)), componentColor(axis));
    helpTip(row.help);
    ImGui::SameLine(0, 0);
    ImGui::SetCursorPosX(ImGui::GetCursorStartPos().x + ImGui::GetFontSize() * 0.9F);
    paramControl(session, owner, row, ImGui::GetContentRegionAvail().x, 2);
}

/// A line with a caption on the left and a colour on the right.
void captionWithColor(const Session& session, const char* words, const Owner& owner, const ParamRow& row) {
    labelText(words);
    const std::string_view name = shownName(session.settings, row);
    const float width = ImGui::CalcTextSize(tr(name).c_str()).x;
    const float left = ImGui::GetItemRectSize().x + ImGui::GetCursorStartPos().x + ImGui::GetFontSize();
    for (const float swatch : {4.0F, 2.2F}) { // a small swatch is better than another line
        const float at = ImGui::GetContentRegionMax().x - swatch * ImGui::GetFontSize() - width -
                         ImGui::GetStyle().ItemInnerSpacing.x;
        if (at <= left)
            continue;
        ImGui::SameLine(at);
        break;
    }
    const Finding* idle = idleReasonOf(session.document.findings, owner.pathOf(row));
    text(name, idle ? color::dim : color::text);
    helpTip(idle ? Sentence("{0}\n{1}", row.help, Sentence("No effect now: {0}.", idle->sentence))
                 : Sentence(row.help));
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    paramControl(session, owner, row, ImGui::GetContentRegionAvail().x);
}

void wrapBlock(const Session& session, const Owner& owner) {
    const StructTable& table = textureTable();
    captionWithColor(session, N_("Wrap"), owner, essentialRow(table, keyOf<&Texture::borderColor>()));
    const std::array rows{&essentialRow(table, keyOf<&Texture::wrapS>()),
                          &essentialRow(table, keyOf<&Texture::wrapT>()),
                          &essentialRow(table, keyOf<&Texture::wrapR>())};
    const int axes = std::max(2, coordinatesOf(selectedUnit(session).target));
    for (int axis = 0; axis < axes; ++axis) {
        const ParamRow& row = *rows.at(static_cast<std::size_t>(axis));
        if (session.settings.glNames)
            paramWidget(session, owner, row);
        else
            wrapLine(session, owner, row, axis);
    }
}

/// Space between groups.
void blockEnds() {
    ImGui::Dummy({0, std::floor(ImGui::GetStyle().ItemSpacing.y * 0.5F)});
}

void textureBlock(const Session& session, const Pictures& pictures) {
    const Owner owner = textureOwner(session);
    const StructTable& table = textureTable();
    imageChoice(session, pictures);
    blockEnds();
    paramWidget(session, owner, essentialRow(table, keyOf<&Texture::magFilter>()));
    paramWidget(session, owner, essentialRow(table, keyOf<&Texture::minFilter>()));
    anisotropyLine(session, owner, essentialRow(table, keyOf<&Texture::maxAnisotropy>()));
    blockEnds();
    wrapBlock(session, owner);
}

void environmentBlock(const Session& session) {
    const Owner owner = unitOwner(session);
    const StructTable& table = unitTable();
    captionWithColor(session, N_("Environment"), owner, essentialRow(table, keyOf<&Unit::envColor>()));
    paramControl(session, owner, essentialRow(table, keyOf<&Unit::envMode>()),
                 ImGui::GetContentRegionAvail().x, 3);
    environmentLine(session);
}

void matrixBlock(const Session& session) {
    const std::size_t steps = matrixStepCount(session);
    labelText(N_("Texture matrix"));
    ImGui::SameLine();
    dimText(steps == 0 ? N_("identity") : Sentence::plural("{0} step", "{0} steps", steps));
    if (steps > 0) {
        ImGui::SameLine();
        if (smallButton(label("Edit")))
            session.out.wantedSection = Section::Matrix;
        item("edit matrix", "Shows the steps of the texture matrix");
    }
    motionButtons(session);
}

void pinnedRows(const Session& session) {
    if (session.settings.pinned.empty())
        return;
    bool captioned = false;
    for (const ShownStruct& place : shownStructs(session)) {
        for (const ParamRow& row : place.table->params) {
            const std::string path = place.owner.pathOf(row);
            if (isEssential(path) || !isPinned(session.settings, path))
                continue;
            if (!captioned)
                caption("Pinned");
            captioned = true;
            paramWidget(session, place.owner, row);
        }
    }
}

} // namespace

void essentials(const Session& session, const Pictures& pictures) {
    vertexLine(session);
    blockEnds();
    if (boundTexture(session))
        textureBlock(session, pictures);
    else
        wrappedText("No texture is bound to this unit. Switch the unit on to get one.");
    blockEnds();
    environmentBlock(session);
    paramWidget(session, materialOwner(session), essentialRow(materialTable(), keyOf<&Material::color>()));
    blockEnds();
    matrixBlock(session);
    pinnedRows(session);
}

} // namespace texplorer::ui
