#include "app/ui/language/translate.h"
#include "app/ui/model/notice.h"
#include "app/ui/parameters/sections.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/theme.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace texplorer::ui {
namespace {

/// A pattern that no texture of the scene has; brick, or else the first.
Pattern freshPattern(const Scene& scene) {
    const auto isTaken = [&](Pattern pattern) {
        return std::ranges::any_of(scene.textures, [&](const Texture& each) {
            return each.source == SourceKind::Pattern && each.pattern == pattern;
        });
    };
    constexpr std::array liked{Pattern::Brick,  Pattern::UvTemplate, Pattern::CheckerRed,
                               Pattern::Planet, Pattern::Gradient,   Pattern::Tree};
    const auto found = std::ranges::find_if_not(liked, isTaken);
    return found == liked.end() ? liked.front() : *found;
}

/// Copies the settings to a texture for this unit alone.
void ownTexture(const Session& session) {
    const std::size_t added = presentScene(session).textures.size();
    const auto copied = static_cast<std::size_t>(selectedUnit(session).texture);
    submit(session,
           {.name = N_("Own texture"),
            .edits = {edit::Insert{keyOf<&Scene::textures>(), added, copied},
                      edit::Set{fmt::format("{}.{}", selectedUnitPath(session), keyOf<&Unit::texture>()),
                                std::to_string(added)}}});
}

void drawThumbnail(const Session& session, const Pictures& pictures, const Unit& unit, int number, ImVec2 low,
                   float extent) {
    const ImVec2 high(low.x + extent, low.y + extent);
    ImGui::GetWindowDrawList()->AddRectFilled(low, high, color::ground);
    const Texture* texture = textureOf(presentScene(session), unit);
    const std::shared_ptr<const Image> image =
        texture ? thumbnailOf(session, *texture, unit.target) : nullptr;
    if (!image || image->empty())
        return;
    noteDrawn(fmt::format("picture:unit {}", number), low, high);
    constexpr float offAlpha = 0.3F;
    drawImage(pictures, image, low, high, ImGui::GetColorU32(ImVec4(1, 1, 1, unit.enabled ? 1 : offAlpha)));
}

Sentence unitTip(const Session& session, int number) {
    const Unit& unit = presentScene(session)
                           .passes[static_cast<std::size_t>(session.look.selection.pass)]
                           .units[static_cast<std::size_t>(number)];
    const Sentence sharers = sharersText(session, number);
    if (!textureOf(presentScene(session), unit))
        return {N_("Texture unit {0} has no texture and gets one when switched on."), number};
    if (!sharers.empty() && unit == Unit{})
        return {N_("Texture unit {0} is off and gets its own texture when switched on."), number};
    if (!sharers.empty() && unit.enabled)
        return {N_("Texture unit {0} is on and shares texture {1} with {2}."), number, unit.texture, sharers};
    if (!sharers.empty())
        return {N_("Texture unit {0} is off. When on, it shares texture {1} with {2}."), number, unit.texture,
                sharers};
    return unit.enabled ? Sentence("Texture unit {0} is on and has texture {1}.", number, unit.texture)
                        : Sentence("Texture unit {0} is off; it has texture {1}.", number, unit.texture);
}

void drawUnit(const Session& session, const Pictures& pictures, int number, float width, float height) {
    const Unit& unit = selectedPass(session).units[static_cast<std::size_t>(number)];
    const bool isChosen = session.look.selection.unit == number;
    const float em = ImGui::GetFontSize();
    const float pad = std::floor(em * 0.2F);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const std::string shown = std::to_string(number);
    const float digit = ImGui::CalcTextSize(shown.c_str()).x;
    const float toggle =
        std::floor(std::clamp(width - digit - 3 * pad, em * 0.6F, std::max(em * 1.2F, targetHeight() / 2)));
    ImGui::PushID(number);
    if (overlappedItem([&] { return markedButton("##unit", isChosen, {width, height}); })) // by the switch
        act(session, [number](Session& changed) { changed.look.selection.unit = number; });
    item(fmt::format("unit:{}", number), unitTip(session, number));
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    if (isChosen)
        draw.AddRectFilled({low.x + pad, low.y + height - std::ceil(pad * 0.7F)},
                           {low.x + width - pad, low.y + height}, ImGui::GetColorU32(ImGuiCol_CheckMark));
    const float extent = std::min(height - 2 * pad, em * 1.6F);
    const float textAt = low.x + 2 * pad + extent;
    const bool hasRoom = textAt + digit + toggle + 2 * pad <= low.x + width;
    if (hasRoom)
        drawThumbnail(session, pictures, unit, number, {low.x + pad, low.y + (height - extent) / 2}, extent);
    draw.AddText({hasRoom ? textAt : low.x + pad, low.y + (height - em) / 2},
                 unit.enabled ? color::text : color::dim, shown.c_str());

    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        {ImGui::GetStyle().FramePadding.x, std::floor((toggle - em) / 2)});
    ImGui::PushStyleColor(ImGuiCol_FrameBg, ImGui::GetColorU32(ImGuiCol_WindowBg));
    ImGui::SetCursorScreenPos({low.x + width - toggle - pad, low.y + (height - toggle) / 2});
    bool on = unit.enabled;
    if (ImGui::Checkbox("##on", &on))
        switchUnit(session, number, on);
    item(fmt::format("unit:{} on", number),
         on ? Sentence("Switches texture unit {0} off: its texture has no effect", number)
            : Sentence("Switches texture unit {0} on", number));
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    ImGui::PopID();
}

/// What an edit of the texture affects, with a button to give the unit its own.
void reachLine(const Session& session) {
    const Sentence sharers = sharersText(session, session.look.selection.unit);
    const Unit& unit = selectedUnit(session);
    if (sharers.empty() || unit == Unit{}) // a unit that was never enabled gets its own
        return;
    dimWrappedText(unit.enabled ? Sentence("Texture {0}: this unit and {1}", unit.texture, sharers)
                                : Sentence("Texture {0}: {1}, and this unit when on", unit.texture, sharers));
    item("shares texture",
         "They share the texture's settings: image, filters, wrap modes and levels belong to the "
         "texture object. Environment, matrix and generated coordinates belong to each unit.");
    const char* give = N_("Make a copy");
    if (ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + buttonWidth(give) <
        ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x)
        ImGui::SameLine();
    ImGui::BeginDisabled(presentScene(session).textures.size() >= maxTextures);
    if (smallButton(label(give)))
        ownTexture(session);
    noteItem("own texture");
    ImGui::EndDisabled();
    helpTip("Gives this unit its own copy of the texture");
}

} // namespace

void switchUnit(const Session& session, int unit, bool on) {
    const Scene& scene = presentScene(session);
    const Unit& switched = selectedPass(session).units[static_cast<std::size_t>(unit)];
    const bool neverOn = switched == Unit{} && !sharersText(session, unit).empty();
    const bool wantsTexture = on && (neverOn || !textureOf(scene, switched));
    const std::size_t added = scene.textures.size();
    if (wantsTexture && added >= maxTextures && !textureOf(scene, switched))
        return act(session, [](Session& told) {
            say(told, N_("The scene can have no more textures, and a unit needs one."));
        });
    Selection selection = session.look.selection;
    selection.unit = unit;
    std::vector<Edit> edits;
    if (wantsTexture && added < maxTextures)
        edits = addedTexture(session, unit, freshPattern(scene));
    const std::string path = fmt::format("{}.{}", unitPath(selection), keyOf<&Unit::enabled>());
    edits.emplace_back(edit::Set{path, on ? "true" : "false"});
    submit(session, {.name = on ? N_("Switch unit on") : N_("Switch unit off"),
                     .edits = std::move(edits),
                     .path = path,
                     .select = std::move(selection)});
}

std::vector<Edit> addedTexture(const Session& session, int unit, Pattern pattern) {
    Selection selection = session.look.selection;
    selection.unit = unit;
    const std::size_t added = presentScene(session).textures.size();
    const std::string texture = elementOf<&Scene::textures>(added) + ".";
    return {
        edit::Insert{keyOf<&Scene::textures>(), added},
        edit::Set{texture + keyOf<&Texture::pattern>(), std::string(rowOf(pattern).name)},
        edit::Set{texture + keyOf<&Texture::mipmaps>(), std::string(rowOf(MipPolicy::Generated).name)},
        edit::Set{fmt::format("{}.{}", unitPath(selection), keyOf<&Unit::texture>()), std::to_string(added)}};
}

Sentence sharersText(const Session& session, int unit) {
    const Scene& scene = presentScene(session);
    const auto selected = static_cast<std::size_t>(session.look.selection.pass);
    const auto asked = static_cast<std::size_t>(unit);
    const int texture = scene.passes[selected].units[asked].texture;
    std::vector<Sentence> names;
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        for (std::size_t u = 0; u < maxUnits; ++u) {
            const Unit& other = scene.passes[p].units[u];
            if (!other.enabled || other.texture != texture || (p == selected && u == asked))
                continue;
            names.push_back(p == selected ? Sentence("unit {0}", u) : Sentence("unit {0} of pass {1}", u, p));
        }
    }
    return textureOf(scene, scene.passes[selected].units[asked]) ? Sentence::joined("{0}, {1}", names) : "";
}

void unitBar(const Session& session, const Pictures& pictures) {
    const float em = ImGui::GetFontSize();
    const float gap = std::floor(em * 0.25F);
    const float height = std::max(std::floor(em * 2), targetHeight());
    const float room = ImGui::GetContentRegionAvail().x;
    float words = ImGui::CalcTextSize(tr("Unit")).x + 2 * gap;
    if (room - words < em * 8) // the numbers and switches need it
        words = 0;
    const float width = std::floor((room - words - (maxUnits - 1) * gap) / maxUnits);
    const ImVec2 low = ImGui::GetCursorPos();
    ImGui::SetCursorPosY(low.y + (height - em) / 2);
    if (words > 0)
        text("Unit");
    for (int i = 0; i < maxUnits; ++i) {
        ImGui::SetCursorPos({low.x + words + static_cast<float>(i) * (width + gap), low.y});
        drawUnit(session, pictures, i, std::max(1.0F, width), height);
    }
    ImGui::SetCursorPos({low.x, low.y + height + gap});
    reachLine(session);
}

} // namespace texplorer::ui
