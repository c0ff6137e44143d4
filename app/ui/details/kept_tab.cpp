// The tab "A and B": the differences from the kept state A, which can be applied.

#include "app/ui/details/kept_tab.h"

#include "app/ui/language/translate.h"
#include "app/ui/model/findings.h"
#include "app/ui/model/kept.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/change_table.h"
#include "app/ui/widgets/param_widgets.h"

#include <fmt/core.h>

namespace texplorer::ui {
namespace {

void followScene(const Session& session, KeptTabState& state) {
    const auto& kept = session.document.kept.scene;
    if (state.kept == kept && state.now == presentScene(session))
        return;
    state.kept = kept;
    state.now = presentScene(session);
    state.changes = changesSinceKept(session);
}

void beforeKeeping(const Session& session) {
    wrappedText("Keep the scene as A and change something. T switches between A and now, Shift+T shows "
                "both in one picture, and each difference is listed here.");
    if (ImGui::Button(label("Keep as A")))
        act(session, keepAsA);
    noteItem("a-b tab:keep");
}

void keptButtons(const Session& session, std::size_t count) {
    if (button("Keep as A", N_("a-b tab:keep"),
               "Keeps the present scene as A.\n"
               "Key K"))
        act(session, keepAsA);
    ImGui::SameLine();
    if (button(isKeptShown(session) ? N_("Show now") : N_("Show A"), N_("a-b tab:flip"),
               "Shows A or the present scene "
               "in the view.\n"
               "Key T"))
        act(session, flipKept);
    ImGui::SameLine();
    if (button(isKeptBeside(session) ? N_("One picture") : N_("Split"), N_("a-b tab:split"),
               "Shows both in one picture, or one again.\n"
               "Key Shift+T"))
        act(session, splitKept);
    ImGui::SameLine();
    if (button("Take over all", N_("a-b tab:take all"), "Restores A. Undo reverts it.", count > 0))
        takeAllFromKept(session);
}

void drawChanges(const Session& session, const std::vector<SceneChange>& changes) {
    const char* take = N_("Take over");
    if (!beginChangeTable({.from = "A", .to = N_("Now"), .action = buttonWidth(take)}))
        return;
    for (const SceneChange& change : changes) {
        ImGui::PushID(change.path.c_str());
        changedParam(change);
        noteItem(fmt::format("change:{}", change.path));
        if (ImGui::IsItemHovered())
            ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        helpTip(Sentence("{0}\nClick: show the setting", ProperName{change.path}));
        if (ImGui::IsItemClicked())
            act(session, [path = change.path](Session& s) { reveal(s, path); });
        changedValues(change);
        ImGui::TableNextColumn();
        if (smallButton(label(take)))
            takeFromKept(session, change);
        item(fmt::format("take:{}", change.path),
             Sentence("Sets {0} to the value in A: {1}", change.label, change.from));
        ImGui::PopID();
    }
    ImGui::EndTable();
}

} // namespace

void drawKeptTab(const Session& session, KeptTabState& state) {
    followScene(session, state);
    if (!session.document.kept.scene)
        return beforeKeeping(session);
    keptButtons(session, state.changes.size());
    if (state.changes.empty()) {
        dimText("Only the camera differs from A.");
        noteItem("a-b tab:same");
        return;
    }
    drawChanges(session, state.changes);
}

} // namespace texplorer::ui
