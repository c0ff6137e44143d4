#include "app/ui/language/translate.h"
#include "app/ui/model/kept.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/window/shortcuts.h"
#include "app/ui/window/window_parts.h"

#include <array>

namespace texplorer::ui {
namespace {

/// The actions with A, for the menu and, while a state is kept, for the row.
struct KeptRow {
    const char* name;
    const char* label;
    const char* brief;         ///< in the row; nullptr: only in the menu
    std::string_view shortcut; ///< the name of its row; empty: none
    const char* help;
    bool needsKept;
    void (*act)(Session& session);
    bool (*isOn)(const Session& session) = nullptr;
};

constexpr std::array keptRows{
    KeptRow{"keep", N_("Keep as A"), N_("Keep as A"), "keep",
            N_("Keeps the present scene as A, to compare later changes with it."), false, keepAsA},
    KeptRow{"flip", N_("Show A"), "A", "flip",
            N_("Switches between A and the present scene. An edit switches back to the present scene."), true,
            flipKept, isKeptShown},
    KeptRow{"split", N_("Split A and now"), N_("A | now"), "split",
            N_("Shows both in one picture. Drag the seam."), true, splitKept, isKeptBeside},
    KeptRow{"list", N_("Differences"), nullptr, "",
            N_("Lists the differences from A. Each can be taken over."), true,
            [](Session& session) { session.window.wantedTab = Tab::Kept; }},
    KeptRow{"take", N_("Take over all of A"), nullptr, "",
            N_("Restores A, seen from the present camera. Undo reverts it."), true,
            [](Session& session) { takeAllFromKept(session); }},
    KeptRow{"forget", N_("Forget A"), nullptr, "", N_("Ends the comparison."), true, forgetKept},
};

bool isInRow(const Session& session, const KeptRow& row) {
    return row.brief && (!row.needsKept || session.document.kept.scene);
}

bool isOn(const Session& session, const KeptRow& row) {
    return row.isOn && row.isOn(session);
}

/// The key of the action; empty: none.
std::string keyOf(const Session& session, const KeptRow& row) {
    return row.shortcut.empty() ? std::string() : keysOf(session, row.shortcut);
}

Sentence helpOf(const Session& session, const KeptRow& row) {
    const std::string key = keyOf(session, row);
    return key.empty() ? Sentence(row.help)
                       : Sentence("{0}\n{1}", row.help, Sentence("Key {0}", ProperName{key}));
}

} // namespace

void drawKeptMenu(const Session& session) {
    for (const KeptRow& row : keptRows) {
        if (ImGui::MenuItem(label(row.label), keyOf(session, row).c_str(), isOn(session, row),
                            !row.needsKept || session.document.kept.scene))
            act(session, row.act);
        item(fmt::format("a-b:{}", row.name), row.help);
    }
}

float keptControlsWidth(const Session& session) {
    float width = ImGui::GetFontSize();
    for (const KeptRow& row : keptRows)
        width +=
            isInRow(session, row) ? buttonWidth(row.brief) + ImGui::GetStyle().ItemInnerSpacing.x / 2 : 0;
    return width;
}

void drawKeptControls(const Session& session, float available) {
    if (keptControlsWidth(session) > available)
        return;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x / 2;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetFontSize());
    ImGui::SetCursorPosY((ImGui::GetWindowHeight() - ImGui::GetFrameHeight()) / 2);
    for (const KeptRow& row : keptRows) {
        if (!isInRow(session, row))
            continue;
        if (flatButton(label(row.brief), isOn(session, row)))
            act(session, row.act);
        item(fmt::format("a-b row:{}", row.name), helpOf(session, row));
        ImGui::SameLine(0, gap);
    }
}

} // namespace texplorer::ui
