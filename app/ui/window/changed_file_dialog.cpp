// A file that another window or an editor has written since it was read here.

#include "app/ui/window/changed_file_dialog.h"

#include "app/ui/model/asking.h"
#include "app/ui/model/scene_saving.h"
#include "app/ui/widgets/change_table.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/modal.h"
#include "app/ui/widgets/param_tips.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/wrapped_text.h"
#include "app/ui/window/dialog_button.h"
#include "core/text/printable.h"

#include <fmt/core.h>

#include <algorithm>
#include <variant>

namespace texplorer::ui {
namespace {

enum class Decision { None, Mine, Theirs, Elsewhere, Cancel };

void decide(Session& session, Decision decision) {
    session.window.dialog = Dialog::None;
    if (decision == Decision::Mine) {
        keepMine(session);
        return save(session);
    }
    if (decision == Decision::Theirs && std::holds_alternative<std::monostate>(session.window.pending))
        return takeTheirs(session);
    session.document.changedFile.reset();
    if (decision == Decision::Theirs)
        return finishPending(session); // the shown scene is discarded for the pending action
    if (decision == Decision::Elsewhere)
        return askSaveAs(session);
    session.window.pending = {};
}

/// One row per different parameter, as many as fit into the window.
void drawDifferences(const std::vector<SceneChange>& changes, float width) {
    const float line = ImGui::GetFrameHeight();
    const float maxHeight = ImGui::GetIO().DisplaySize.y * 0.5F;
    const float height = std::min(maxHeight, line * static_cast<float>(changes.size() + 2));
    if (!beginChangeTable({.from = "In the file", .to = "Here"}, {width, height}))
        return;
    for (const SceneChange& change : changes) {
        changedParam(change);
        noteItem(fmt::format("changed:{}", change.path));
        changedValues(change);
    }
    ImGui::EndTable();
}

Decision decisionButtons(bool readable) {
    Decision decision = Decision::None;
    const auto button = [&](const char* words, Decision means, const char* name, const char* help) {
        if (dialogButton(words))
            decision = means;
        noteItem(name);
        helpTip(help);
        ImGui::SameLine();
    };
    button("Keep mine", Decision::Mine, "changed:mine", "Overwrites the file with the scene shown here.");
    ImGui::BeginDisabled(!readable);
    button("Take theirs", Decision::Theirs, "changed:theirs",
           "Replaces the scene by the one in the file. Undo restores yours.");
    ImGui::EndDisabled();
    button("Save elsewhere", Decision::Elsewhere, "changed:elsewhere",
           "Saves under another name and keeps the file.\n"
           "Key Enter");
    if (isKeyPressed(key::enter, false)) // the action that loses nothing
        decision = Decision::Elsewhere;
    if (dialogButton("Cancel") || isKeyPressed(key::escape, false))
        decision = Decision::Cancel;
    noteItem("changed:cancel");
    return decision;
}

} // namespace

void drawChangedFile(const Session& session) {
    const std::shared_ptr<const ChangedFile> changed = session.document.changedFile;
    if (!changed) { // another document is shown
        change(session, [](WindowState& window) { window.dialog = Dialog::None; });
        return;
    }
    if (!beginModal("The file has changed"))
        return;
    const float em = ImGui::GetFontSize();
    const float width = std::min(em * 46, ImGui::GetIO().DisplaySize.x * 0.9F);
    ImGui::Dummy({width, 0});
    wrappedText(
        fmt::format("Another program has changed {} since it was read. Saving overwrites those changes.",
                    printable(session.document.file.filename().string())));
    ImGui::Dummy({0, em * 0.3F});
    if (changed->theirs) {
        drawDifferences(changed->changes, width);
    } else {
        ImGui::PushStyleColor(ImGuiCol_Text, color::problem);
        wrappedText(
            fmt::format("The file contains no scene now: {}.", printable(describe(changed->theirs.error()))));
        ImGui::PopStyleColor();
        noteItem("changed:problem");
    }
    ImGui::Dummy({0, em * 0.3F});
    const Decision decision = decisionButtons(changed->theirs.has_value());
    if (decision != Decision::None)
        ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    if (decision != Decision::None)
        act(session, [decision](Session& s) { decide(s, decision); });
}

} // namespace texplorer::ui
