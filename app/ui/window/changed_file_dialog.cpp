// A file that another window or an editor has written since it was read here.

#include "app/ui/files/asking.h"
#include "app/ui/files/scene_saving.h"
#include "app/ui/language/translate.h"
#include "app/ui/widgets/change_table.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/window/dialog_parts.h"
#include "texplorer/text/printable.h"

#include <fmt/core.h>

#include <algorithm>
#include <variant>

namespace texplorer::ui {
namespace {

void overwriteTheirs(Session& session) {
    keepMine(session);
    save(session);
}

void useTheirs(Session& session) {
    if (std::holds_alternative<std::monostate>(session.asking.pending))
        return takeTheirs(session);
    session.document.changedFile.reset();
    finishPending(session); // the shown scene is discarded for the pending action
}

void saveElsewhere(Session& session) {
    session.document.changedFile.reset();
    askSaveAs(session);
}

void goBack(Session& session) {
    session.document.changedFile.reset();
    session.asking.pending = {};
}

/// One row per different parameter, as many as fit into the window.
void drawDifferences(const std::vector<SceneChange>& changes, float width) {
    const float line = ImGui::GetFrameHeight();
    const float maxHeight = ImGui::GetIO().DisplaySize.y * 0.5F;
    const float height = std::min(maxHeight, line * static_cast<float>(changes.size() + 2));
    if (!beginChangeTable({.from = N_("In the file"), .to = N_("Here")}, {width, height}))
        return;
    for (const SceneChange& change : changes) {
        changedParam(change);
        noteItem(fmt::format("changed:{}", change.path));
        changedValues(change);
    }
    ImGui::EndTable();
}

} // namespace

void drawChangedFile(const Session& session) {
    const std::shared_ptr<const ChangedFile> changed = session.document.changedFile;
    if (!changed) // another document is shown
        return act(session, [](Session& s) { s.asking.dialog = Dialog::None; });
    if (!beginModal("The file has changed"))
        return;
    const float em = ImGui::GetFontSize();
    const float width = std::min(em * 46, ImGui::GetIO().DisplaySize.x * 0.9F);
    ImGui::Dummy({width, 0});
    wrappedText(
        Sentence("Another program has changed {0} since it was read. Saving overwrites those changes.",
                 ProperName{printable(session.document.file.filename().string())}));
    ImGui::Dummy({0, em * 0.3F});
    if (changed->theirs) {
        drawDifferences(changed->changes, width);
    } else {
        plainWrappedText(printable(tr(Sentence("The file contains no scene now: {0}.",
                                               describe(changed->theirs.error())))),
                         color::problem);
        noteItem("changed:problem");
    }
    ImGui::Dummy({0, em * 0.3F});
    endWithAnswers(session, {{N_("Keep mine"), "changed:mine", overwriteTheirs, 0,
                              N_("Overwrites the file with the scene shown here.")},
                             {N_("Take theirs"), "changed:theirs", useTheirs, 0,
                              N_("Replaces the scene by the one in the file. Undo restores yours."),
                              changed->theirs.has_value()},
                             {N_("Save elsewhere"), "changed:elsewhere", saveElsewhere, key::enter,
                              N_("Saves under another name and keeps the file.\n"
                                 "Key Enter")}, // the action that loses nothing
                             {N_("Cancel"), "changed:cancel", goBack, key::escape}});
}

} // namespace texplorer::ui
