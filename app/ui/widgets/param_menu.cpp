#include "app/ui/language/translate.h"
#include "app/ui/model/sheet_choice.h"
#include "app/ui/model/timeline_edits.h"
#include "app/ui/state/pinned.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/palette.h"
#include "app/ui/widgets/param_parts.h"
#include "app/ui/widgets/popups.h"
#include "texplorer/scene/params/key_edits.h"
#include "texplorer/scene/params/value_words.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

namespace texplorer::ui {
namespace {

/// An item with its name in tests, "path#menu:name".
bool rowItem(const Sentence& words, const std::string& path, std::string_view name, const Sentence& help = {},
             bool enabled = true) {
    const bool pressed = ImGui::MenuItem(label(words).c_str(), nullptr, false, enabled);
    noteItem(fmt::format("{}#menu:{}", path, name));
    if (!help.empty())
        helpTip(help);
    return pressed;
}

/// Menu items for the key frames of a row.
void keyItems(const Session& session, const std::string& path) {
    const Timeline& timeline = presentScene(session).timeline;
    const float time = presentKeyTime(session);
    ImGui::Separator();
    if (const std::optional<std::size_t> here = keyAt(timeline, path, time)) {
        if (rowItem(Sentence("Remove the key frame at {0:.2f} s", time), path, "key"))
            removeKey(session, *here);
    } else if (rowItem(Sentence("Add key frame at {0:.2f} s", time), path, "key",
                       N_("Stores the present value at this time. The parameter moves from each key frame to "
                          "the next. The timeline lists them."))) {
        addKey(session, path, time);
    }
    if (!hasKeys(timeline, path))
        return;
    if (rowItem(N_("Show its key frames"), path, "timeline"))
        act(session, [](Session& changed) { changed.window.wantedTab = Tab::Timeline; });
    if (rowItem(N_("Remove its key frames"), path, "no-keys", N_("The parameter keeps its present value.")))
        removeKeys(session, path);
}

constexpr std::array sheetSides{std::pair(N_("Vary on a sheet: rows"), "rows"),
                                std::pair(N_("Vary on a sheet: columns"), "columns")};

} // namespace

void opensParamMenu() {
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right) || isMenuAsked())
        ImGui::OpenPopup("row");
}

bool paramMenu(const Session& session, const ParamRow& row, const std::string& path, const Value& initial,
               bool changed) {
    if (!beginPopup("row"))
        return false;
    caption(glNameOf(row).empty() ? Sentence(row.label)
                                  : Sentence("{0} · {1}", row.label, ProperName{glNameOf(row)}));
    const bool resets = rowItem(resetWords(row, initial), path, "reset", {}, changed);
    const bool isThere = isEssential(path);
    const bool pinned = isPinned(session.settings, path);
    if (rowItem(pinned ? N_("Unpin from Essentials") : N_("Pin to Essentials"), path, "pin",
                isThere  ? N_("It is in Essentials already")
                : pinned ? N_("Removes it from Essentials")
                         : N_("Shows it at the end of Essentials, for the selected texture, unit or model"),
                !isThere))
        act(session, [path](Session& s) { togglePin(s.settings, path); });
    keyItems(session, path);
    if (canSweep(row)) {
        ImGui::Separator();
        for (std::size_t side = 0; side < sheetSides.size(); ++side) {
            const auto& [words, name] = sheetSides[side];
            if (rowItem(words, path, name,
                        N_("Shows the scene with each of its values on the sheet of variations.")))
                act(session, [path, side](Session& s) { varyOnSheet(s, path, side); });
        }
    }
    endPopup();
    return resets;
}

Sentence resetWords(const ParamRow& row, const Value& initial) {
    const Sentence words = wordsOf(row, initial);
    return words.empty() ? Sentence("Reset to nothing") : Sentence("Reset to {0}", words);
}

void keySign(const Session& session, const std::string& path) {
    const Timeline& timeline = presentScene(session).timeline;
    if (!hasKeys(timeline, path))
        return;
    const float em = ImGui::GetFontSize();
    const float time = presentKeyTime(session);
    const std::optional<std::size_t> here = keyAt(timeline, path, time);
    ImGui::SameLine(0, em * 0.25F);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton("key", {em * 0.8F, ImGui::GetFrameHeight()});
    noteItem(path + "#key");
    const ImVec2 at(low.x + em * 0.4F, low.y + ImGui::GetFrameHeight() / 2);
    const float radius = em * 0.34F;
    const ImVec2 top(at.x, at.y - radius);
    const ImVec2 right(at.x + radius, at.y);
    const ImVec2 bottom(at.x, at.y + radius);
    const ImVec2 left(at.x - radius, at.y);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    if (here)
        draw.AddQuadFilled(top, right, bottom, left, color::accent);
    else
        draw.AddQuad(top, right, bottom, left, color::accent, std::max(1.0F, em / 12));
    helpTip(here ? Sentence("It has a key frame at {0:.2f} s. Click to remove it.", time)
                 : Sentence("It has key frames, and an edit adds one at {0:.2f} s. Click to add one with the "
                            "present value.",
                            time));
    if (pressed && here)
        removeKey(session, *here);
    else if (pressed)
        addKey(session, path, time);
}

} // namespace texplorer::ui
