// The texture that is bound to the selected unit: which one, whether others have it too, and its parameters.

#include "app/ui/parameters/texture_section.h"

#include "app/ui/parameters/texture_lists.h"
#include "app/ui/widgets/button_width.h"
#include "app/ui/widgets/param_tips.h"
#include "app/ui/widgets/param_widgets.h"
#include "core/base/printable.h"
#include "core/scene/params/keys.h"

#include <fmt/core.h>

namespace texplorer::ui {
namespace {

std::string textureName(const Session& session, int index) {
    const Texture& texture = session.document.scene.textures[static_cast<std::size_t>(index)];
    std::string what(rowOf(texture.source).label); // of what the light sees
    if (texture.source == SourceKind::Pattern)
        what = rowOf(texture.pattern).label;
    else if (texture.source == SourceKind::File)
        what = printable(std::filesystem::path(texture.file).filename().string());
    return fmt::format("{}  {}", index, what);
}

void addTexture(Session& session) {
    Texture texture;
    texture.pattern = Pattern::UvTemplate;
    texture.mipmaps = MipPolicy::Generated;
    session.document.scene.textures.push_back(texture);
    selectedUnit(session).texture = static_cast<int>(session.document.scene.textures.size()) - 1;
    sealEdit(session);
    recordEdit(session, "Add texture");
}

/// Units that were bound to later textures go on showing the same ones.
void removeTexture(Session& session, int index) {
    Scene& scene = session.document.scene;
    scene.textures.erase(scene.textures.begin() + index);
    for (Pass& pass : scene.passes) {
        for (Unit& unit : pass.units) {
            if (unit.texture > index || (unit.texture == index && index > 0))
                --unit.texture;
            unit.enabled = unit.enabled && !scene.textures.empty(); // there is nothing left to enable
        }
    }
    sealEdit(session);
    recordEdit(session, "Remove texture");
}

/// Which texture is bound: choosing one here is glBindTexture, it is then both used by the unit and edited
/// below.
void textureChoice(Session& session) {
    Unit& unit = selectedUnit(session);
    const ParamRow* row = findParam(unitTable(), keyOf<&Unit::texture>());
    const bool bound = boundTexture(session) != nullptr;
    const std::string current = bound ? textureName(session, unit.texture) : "none";
    const float button = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.x / 2;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 2 * button);
    if (ImGui::BeginCombo("##bound", current.c_str())) {
        for (int i = 0; i < static_cast<int>(session.document.scene.textures.size()); ++i) {
            const std::string name = textureName(session, i);
            if (ImGui::Selectable(name.c_str(), i == unit.texture) && i != unit.texture) {
                unit.texture = i;
                sealEdit(session);
                recordEdit(session, row ? row->label : "Texture",
                           fmt::format("{}.{}", selectedUnitPath(session), keyOf<&Unit::texture>()));
                sealEdit(session);
            }
            noteItem(fmt::format("bind:{}", i));
        }
        ImGui::EndCombo();
    }
    noteItem("texture choice");
    if (row)
        helpTip(fmt::format("{}\n{}", formatCall(*row, Value(unit.texture)), row->help));
    const float gap = ImGui::GetStyle().ItemSpacing.x / 2;
    ImGui::SameLine(0, gap);
    if (squareButton("+", "add texture", "Add a texture and bind it to this unit",
                     session.document.scene.textures.size() < maxTextures))
        addTexture(session);
    ImGui::SameLine(0, gap);
    if (squareButton("−", "remove texture", "Remove this texture", bound))
        removeTexture(session, unit.texture);
}

/// The same settings, from now on for this unit alone.
void ownTexture(Session& session) {
    const Texture copy = *boundTexture(session);
    session.document.scene.textures.push_back(copy);
    selectedUnit(session).texture = static_cast<int>(session.document.scene.textures.size()) - 1;
    sealEdit(session);
    recordEdit(session, "Own texture");
    sealEdit(session);
}

/// Small pictures of its steps and levels, where it has any: made beside the window where that takes long.
std::shared_ptr<const LevelsSummary> summaryOf(Session& session, const Texture& texture) {
    if (texture.preparation.empty() && texture.mipmaps != MipPolicy::Given)
        return nullptr;
    return session.services.levels.summary(
        {session.document.images.picturesOf(texture), imageSettings(texture), selectedUnit(session).target});
}

/// What belongs below the rows of a group.
void listsAfter(std::string_view group, Session& session, std::size_t texture, const LevelsSummary* summary,
                const Pictures& pictures) {
    if (group == findParam(textureTable(), keyOf<&Texture::file>())->group)
        preparationList(session, texture, summary, pictures);
    if (group == findParam(textureTable(), keyOf<&Texture::mipmaps>())->group)
        levelList(session, texture, summary, pictures);
}

} // namespace

std::string sharersText(const Session& session, int unit) {
    const Scene& scene = session.document.scene;
    const auto selected = static_cast<std::size_t>(session.window.selection.pass);
    const auto asked = static_cast<std::size_t>(unit);
    const int texture = scene.passes[selected].units[asked].texture;
    std::string names;
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        for (std::size_t u = 0; u < maxUnits; ++u) {
            const Unit& other = scene.passes[p].units[u];
            if (!other.enabled || other.texture != texture || (p == selected && u == asked))
                continue;
            names += fmt::format("{}{}{}", names.empty() ? "unit " : ", unit ", u,
                                 p == selected ? "" : fmt::format(" of pass {}", p));
        }
    }
    return boundTexture(session) ? names : "";
}

void sharingNote(Session& session, const char* id) {
    const std::string sharers = sharersText(session, session.window.selection.unit);
    if (sharers.empty())
        return;
    const Unit& unit = selectedUnit(session);
    const std::string words = fmt::format(
        "{}{} with {}", unit.enabled ? "Shares texture " : "Would share texture ", unit.texture, sharers);
    ImGui::PushID(id);
    ImGui::PushTextWrapPos(0);
    dimText(words);
    ImGui::PopTextWrapPos();
    noteItem("shares texture");
    helpTip(
        "What is set under Texture is then set for all of them: image, filters, wrap modes and levels "
        "belong to the texture object. Environment, matrix and generated coordinates belong to each unit.");
    const char* label = "Give it its own";
    const float width = buttonWidth(label);
    if (ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width <
        ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x)
        ImGui::SameLine();
    ImGui::BeginDisabled(session.document.scene.textures.size() >= maxTextures);
    if (ImGui::SmallButton(label))
        ownTexture(session);
    noteItem("own texture");
    ImGui::EndDisabled();
    helpTip("A copy of this texture, which belongs to this unit alone");
    ImGui::PopID();
}

void textureSection(Session& session, const Pictures& pictures) {
    textureChoice(session);
    sharingNote(session, "of the texture");
    Texture* texture = boundTexture(session);
    if (!texture) {
        ImGui::TextWrapped("No texture is bound to this unit. Add one with +.");
        return;
    }
    static const Texture initial;
    const auto index = static_cast<std::size_t>(selectedUnit(session).texture);
    const std::string path = elementOf<&Scene::textures>(index);
    const Owner owner{texture, &initial, path, [&](const ParamRow& row, const Value& value) {
                          return acceptsFile(session, path, texture->file, row, value);
                      }};
    const std::shared_ptr<const LevelsSummary> summary = summaryOf(session, *texture);
    std::string_view group;
    std::string_view captioned;
    for (const ParamRow& row : textureTable().params) {
        if (row.group != group)
            listsAfter(group, session, index, summary.get(), pictures);
        group = row.group;
        if (!isRelevant(session, owner, row))
            continue;
        if (captioned != group)
            caption(group);
        captioned = group;
        paramWidget(session, owner, row);
    }
}

} // namespace texplorer::ui
