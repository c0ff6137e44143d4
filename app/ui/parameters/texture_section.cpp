// The texture bound to the selected unit: the choice and its parameters.

#include "app/ui/language/translate.h"
#include "app/ui/model/level_view.h"
#include "app/ui/parameters/sections.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/popups.h"
#include "app/ui/widgets/upload_edits.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/text/printable.h"

#include <fmt/core.h>

#include <filesystem>

namespace texplorer::ui {
namespace {

Sentence textureName(const Session& session, int index) {
    return {N_("{0}  {1}"), index,
            nameOfImage(presentScene(session).textures[static_cast<std::size_t>(index)])};
}

/// The choice of the bound texture. It acts as glBindTexture: the texture is both used by the unit and edited
/// below.
void textureChoice(const Session& session) {
    const Unit& unit = selectedUnit(session);
    const ParamRow* row = findParam(unitTable(), keyOf<&Unit::texture>());
    const bool bound = boundTexture(session) != nullptr;
    const Sentence current = bound ? textureName(session, unit.texture) : N_("None");
    const float button = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.x / 2;
    const float width = ImGui::GetContentRegionAvail().x - 2 * button;
    const std::string shown = fitted(current, listRoom(width));
    ImGui::SetNextItemWidth(width);
    if (beginCombo("##bound", shown.c_str())) {
        for (int i = 0; i < static_cast<int>(presentScene(session).textures.size()); ++i) {
            const std::string name = tr(textureName(session, i));
            if (ImGui::Selectable(name.c_str(), i == unit.texture) && i != unit.texture) {
                const std::string path =
                    fmt::format("{}.{}", selectedUnitPath(session), keyOf<&Unit::texture>());
                submit(session, {.name = std::string(row ? row->label : N_("Texture")),
                                 .edits = {edit::Set{path, std::to_string(i)}},
                                 .path = path});
            }
            noteItem(fmt::format("bind:{}", i));
        }
        endCombo();
    }
    noteItem("texture choice");
    if (row) {
        const Sentence help("{0}\n{1}", ProperName{formatCall(*row, Value(unit.texture))}, row->help);
        helpTip(shown == tr(current) ? help : Sentence("{0}\n{1}", current, help));
    }
    const float gap = ImGui::GetStyle().ItemSpacing.x / 2;
    ImGui::SameLine(0, gap);
    if (squareButton("+", N_("add texture"), "Add a texture and bind it to this unit",
                     presentScene(session).textures.size() < maxTextures))
        submit(session, {.name = N_("Add texture"),
                         .edits = addedTexture(session, session.look.selection.unit, Pattern::UvTemplate)});
    ImGui::SameLine(0, gap);
    if (squareButton("−", N_("remove texture"), "Remove this texture", bound))
        submit(session,
               {.name = N_("Remove texture"),
                .edits = {edit::Remove{keyOf<&Scene::textures>(), static_cast<std::size_t>(unit.texture)}}});
}

/// Closed at first: few textures need it.
void uploadGroup(const Session& session) {
    const Owner owner = uploadOwner(session);
    if (session.out.wantedParam.starts_with(owner.path + "."))
        ImGui::SetNextItemOpen(true);
    ImGui::PushStyleColor(ImGuiCol_Text, boundTexture(session)->upload.custom ? color::changed : color::text);
    const bool open = ImGui::TreeNodeEx(
        "upload", nodeHeight() | ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen,
        "%s", tr("Upload"));
    ImGui::PopStyleColor();
    item(owner.path + "#group", "What the program's memory holds of the image, and what glTexImage is told");
    if (open)
        paramRows(session, owner, uploadTable());
}

} // namespace

std::shared_ptr<const Image> thumbnailOf(const Session& session, const Texture& texture, Target target) {
    const std::shared_ptr<const LevelsSummary> summary =
        summaryOf(session, levelsOf(session, texture, target));
    return summary && !summary->levels.empty() ? summary->levels.front().second : nullptr;
}

Sentence nameOfImage(const Texture& texture) {
    if (texture.source == SourceKind::File)
        return ProperName{printable(std::filesystem::path(texture.file).filename().string())};
    return texture.source == SourceKind::Pattern ? rowOf(texture.pattern).label
                                                 : rowOf(texture.source).label; // of the light's view
}

void textureSection(const Session& session, const Pictures& pictures) {
    textureChoice(session);
    const Texture* texture = boundTexture(session);
    if (!texture) {
        wrappedText("No texture is bound to this unit. Add one with +.");
        return;
    }
    const auto index = static_cast<std::size_t>(selectedUnit(session).texture);
    const bool hasPictures = !texture->preparation.empty() || texture->mipmaps == MipPolicy::Given;
    const std::shared_ptr<const LevelsSummary> summary =
        hasPictures ? summaryOf(session, levelsOf(session, *texture, selectedUnit(session).target)) : nullptr;
    RowOptions options;
    options.after = [&](std::string_view group) {
        if (group == findParam(textureTable(), keyOf<&Texture::file>())->group) {
            preparationList(session, index, summary.get(), pictures);
            uploadGroup(session);
        }
        if (group == findParam(textureTable(), keyOf<&Texture::mipmaps>())->group) {
            levelList(session, index, summary.get(), pictures);
            subimageList(session, index);
        }
    };
    paramRows(session, textureOwner(session), textureTable(), options);
}

} // namespace texplorer::ui
