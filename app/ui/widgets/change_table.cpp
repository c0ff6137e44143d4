#include "app/ui/widgets/change_table.h"

#include "app/ui/language/translate.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/param_widgets.h"

namespace texplorer::ui {
namespace {

/// Cut at the end of the column; a tooltip then shows all of it.
void valueCell(const Sentence& value, ImU32 ink) {
    ImGui::TableNextColumn();
    if (fittedText(value, ink))
        helpTip(value);
}

} // namespace

bool beginChangeTable(const ChangeColumns& columns, ImVec2 size) {
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_NoSavedSettings |
                                      ImGuiTableFlags_RowBg | ImGuiTableFlags_Resizable;
    const bool acts = columns.action > 0;
    if (!ImGui::BeginTable("changes", acts ? 4 : 3, flags, size))
        return false;
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn(label("Parameter"), ImGuiTableColumnFlags_WidthStretch, 1.6F);
    ImGui::TableSetupColumn(label(columns.from), ImGuiTableColumnFlags_WidthStretch, 1);
    ImGui::TableSetupColumn(label(columns.to), ImGuiTableColumnFlags_WidthStretch, 1);
    if (acts)
        ImGui::TableSetupColumn("##action", ImGuiTableColumnFlags_WidthFixed | ImGuiTableColumnFlags_NoResize,
                                columns.action);
    ImGui::TableHeadersRow();
    return true;
}

void changedParam(const SceneChange& change) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    fittedText(Sentence("{0}   {1}", change.label, ProperName{change.path}), color::text);
}

void changedValues(const SceneChange& change) {
    valueCell(change.from, color::dim);
    valueCell(change.to, color::changed);
}

} // namespace texplorer::ui
