#include "app/ui/files/texture_file.h"
#include "app/ui/language/translate.h"
#include "app/ui/parameters/sections.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/panel_menus.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/popups.h"
#include "app/ui/window/dialog_parts.h"
#include "app/ui/window/window_parts.h"
#include "texplorer/s3tc/encode.h"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

namespace texplorer::ui {
namespace {

constexpr float listWidth = 16; // in heights of a letter

void choose(const Session& session, const std::function<void(TextureSaving&)>& change) {
    act(session, [change](Session& changed) { change(changed.saving); });
}

const char* helpOfFormat(std::string_view name) {
    if (name == "DDS")
        return N_("All levels, and the faces of a cube map, as blocks or pixels.");
    return name == "PNG" ? N_("One level without losses, in small files.") : N_("One level without losses.");
}

void fileLine(const Session& session) {
    lineName(N_("Format"));
    bool isFirst = true;
    for (const std::string_view name : {"DDS", "PNG", "TGA", "BMP"}) {
        if (!std::exchange(isFirst, false))
            ImGui::SameLine(0, ImGui::GetFontSize() * 0.8F);
        if (ImGui::RadioButton(std::string(name).c_str(), session.saving.file == name))
            choose(session, [name](TextureSaving& saving) { saving.file = name; });
        item(fmt::format("texture:{}", name), helpOfFormat(name));
    }
}

/// A line with a list, whose items `offer` draws. Returns whether it is open.
bool listLine(const char* words, const char* id, const std::string& shown, const char* whyNot,
              const Sentence& help, const std::function<void()>& offer) {
    lineName(words);
    ImGui::BeginDisabled(whyNot != nullptr);
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * listWidth);
    const bool open = beginCombo(id, shown.c_str(), ImGuiComboFlags_HeightLargest);
    if (open) {
        offer();
        if (isKeyPressed(key::escape, false)) // of the list, not of the dialog
            ImGui::CloseCurrentPopup();
        endCombo();
    }
    ImGui::EndDisabled();
    item(fmt::format("texture:{}", id + 2), whyNot ? whyNot : help);
    return open;
}

/// An item of a list.
void choice(const Session& session, const std::string& shown, std::string_view name, const Sentence& help,
            bool isChosen, const std::function<void(TextureSaving&)>& change) {
    if (ImGui::Selectable(fmt::format("{}##{}", shown, name).c_str(), isChosen))
        choose(session, change);
    item(fmt::format("texture:{}", name), help);
}

bool blocksLine(const Session& session, const LevelPlan& plan) {
    const TextureSaving& saving = session.saving;
    const std::string asTexture = tr(plan.blocks ? Sentence("As the texture: {0}", rowOf(*plan.blocks).label)
                                                 : N_("As the texture: none"));
    const std::string shown = saving.blocks == SavedBlocks::AsTexture ? asTexture
                              : saving.blocks == SavedBlocks::None    ? std::string(tr("None"))
                                                                      : tr(rowOf(saving.format).label);
    return listLine(N_("Compression"), "##blocks", shown,
                    saving.hasAllLevels() ? nullptr : N_("Only DDS files can be compressed in blocks."),
                    N_("The format of the file's blocks"), [&] {
                        choice(session, asTexture, "as texture", N_("Keeps the blocks that the texture has."),
                               saving.blocks == SavedBlocks::AsTexture,
                               [](TextureSaving& changed) { changed.blocks = SavedBlocks::AsTexture; });
                        choice(session, tr("None"), "none", N_("Eight bits a component"),
                               saving.blocks == SavedBlocks::None,
                               [](TextureSaving& changed) { changed.blocks = SavedBlocks::None; });
                        for (const EnumRow& row : blockFormatRows) {
                            const auto format = static_cast<BlockFormat>(row.value);
                            if (isEncoded(format))
                                choice(session, tr(row.label), row.name, row.help,
                                       saving.blocks == SavedBlocks::Chosen && saving.format == format,
                                       [format](TextureSaving& changed) {
                                           changed.blocks = SavedBlocks::Chosen;
                                           changed.format = format;
                                       });
                        }
                    });
}

void qualityLine(const Session& session) {
    const Texture* texture = boundTexture(session);
    const bool encodes = texture && session.saving.encodes(*texture);
    lineName(N_("Quality"));
    for (const EnumRow& row : encodeQualityRows) {
        if (&row != &encodeQualityRows.front())
            ImGui::SameLine(0, ImGui::GetFontSize() * 0.8F);
        const auto quality = static_cast<EncodeQuality>(row.value);
        ImGui::BeginDisabled(!encodes);
        if (ImGui::RadioButton(label(row.label).c_str(), session.saving.quality == quality))
            choose(session, [quality](TextureSaving& changed) { changed.quality = quality; });
        ImGui::EndDisabled();
        item(fmt::format("texture:{}", row.name),
             encodes ? row.help : N_("No blocks are made for this file."));
    }
}

std::string nameOf(const PlannedLevel& level) {
    return fmt::format("{}: {} × {}", level.number, level.width, level.height);
}

bool levelLine(const Session& session, const LevelPlan& plan) {
    const TextureSaving& saving = session.saving;
    const auto chosen = std::ranges::find(plan.levels, saving.level, &PlannedLevel::number);
    const std::string shown = saving.hasAllLevels()         ? std::string(tr("All levels"))
                              : chosen == plan.levels.end() ? std::to_string(saving.level)
                                                            : nameOf(*chosen);
    return listLine(
        N_("Level"), "##level", shown, saving.hasAllLevels() ? N_("A DDS file has all levels.") : nullptr,
        N_("The level that is written"), [&] {
            for (const PlannedLevel& level : plan.levels)
                choice(session, nameOf(level), fmt::format("level {}", level.number), {},
                       level.number == saving.level,
                       [number = level.number](TextureSaving& changed) { changed.level = number; });
        });
}

/// What will be written, or why nothing can be.
void summary(const Result<std::vector<PlannedLevel>>& levels) {
    const ImVec2 from = ImGui::GetCursorPos();
    if (!levels) {
        wrappedText(describe(levels.error()), color::problem);
        noteItem("texture:problem");
    } else {
        dimText(Sentence("{0} × {1} texels, {2}. The window stays usable meanwhile.", levels->front().width,
                         levels->front().height,
                         Sentence::plural("{0} level", "{0} levels", levels->size())));
    }
    // The height does not depend on the text, so that the buttons stay in place.
    ImGui::SetCursorPos({from.x, from.y + ImGui::GetTextLineHeightWithSpacing() * 2.2F});
}

} // namespace

void saveTextureItem(const Session& session) {
    const Sentence refusal = textureRefusal(session);
    if (menuItem("Save texture…", {}, refusal.empty()))
        act(session, [](Session& changed) { changed.asking.dialog = Dialog::Texture; });
    helpTip(refusal.empty() ? N_("Writes the selected unit's texture, with its levels, to an image file: "
                                 "compressed or not.")
                            : refusal);
}

void drawTextureDialog(const Session& session) {
    if (!beginModal("Save the texture"))
        return;
    const float em = ImGui::GetFontSize();
    ImGui::Dummy({em * 34, 0}); // wide enough for its sentences
    const LevelPlan plan = levelsToSave(session);
    if (const Texture* texture = boundTexture(session)) {
        lineName(N_("Texture"));
        text(Sentence("{0}  {1}", selectedUnit(session).texture, nameOfImage(*texture)));
        noteItem("texture:which");
    }
    fileLine(session);
    bool isListOpen = blocksLine(session, plan);
    qualityLine(session);
    isListOpen |= levelLine(session, plan);
    ImGui::Dummy({0, em * 0.3F});
    const Result<std::vector<PlannedLevel>> levels = savedLevels(session);
    summary(levels);
    endWithAnswers(session,
                   {{N_("Choose a file…"), "texture:choose",
                     [](Session& changed) { changed.asking.dialog = Dialog::SaveTexture; },
                     isListOpen ? 0 : key::enter, "", levels.has_value()},
                    {N_("Cancel"), "texture:cancel", [](Session&) {}, isListOpen ? 0 : key::escape}});
}

} // namespace texplorer::ui
