#include "app/ui/parameters/pass_section.h"

#include "app/ui/model/explaining.h"
#include "app/ui/widgets/number_choice.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/widget_places.h"
#include "core/scene/params/keys.h"

#include <algorithm>
#include <cassert>
#include <string_view>
#include <utility>
#include <vector>

namespace texplorer::ui {
namespace {

void passesChanged(Session& session, std::string_view what) {
    sealEdit(session);
    recordEdit(session, what);
    sealEdit(session);
    clearTexel(session); // its pass has another number
}

/// After the one that is chosen, and like it: most passes differ from the one before in a few things.
void addPass(Session& session) {
    std::vector<Pass>& passes = session.document.scene.passes;
    Pass copy = selectedPass(session);
    if (copy.depthFunc == CompareFunc::Less) // no depth is less than that of the pass before
        copy.depthFunc = CompareFunc::LessEqual;
    int& chosen = session.window.selection.pass;
    ++chosen;
    passes.insert(passes.begin() + chosen, copy);
    passesChanged(session, "Add pass");
}

void removePass(Session& session) {
    std::vector<Pass>& passes = session.document.scene.passes;
    int& chosen = session.window.selection.pass;
    passes.erase(passes.begin() + chosen);
    chosen = std::min(chosen, static_cast<int>(passes.size()) - 1);
    passesChanged(session, "Remove pass");
}

void movePass(Session& session, int by) {
    std::vector<Pass>& passes = session.document.scene.passes;
    int& chosen = session.window.selection.pass;
    std::swap(passes[static_cast<std::size_t>(chosen)], passes[static_cast<std::size_t>(chosen + by)]);
    chosen += by;
    passesChanged(session, "Reorder passes");
}

/// What one does with passes, at the right end of a line.
void passButtons(Session& session) {
    const std::size_t count = session.document.scene.passes.size();
    const int chosen = session.window.selection.pass;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float button = ImGui::GetFrameHeight();
    ImGui::SameLine(std::max(ImGui::GetCursorPosX(), ImGui::GetContentRegionMax().x - 4 * button - 3 * gap));
    if (squareButton("+", "add pass", "Add a pass after this one, and like it", count < maxPasses))
        return addPass(session);
    ImGui::SameLine(0, gap);
    if (squareButton("↑", "pass up", "Draw this pass earlier", chosen > 0))
        return movePass(session, -1);
    ImGui::SameLine(0, gap);
    if (squareButton("↓", "pass down", "Draw this pass later", static_cast<std::size_t>(chosen) + 1 < count))
        return movePass(session, 1);
    ImGui::SameLine(0, gap);
    if (squareButton("✕", "remove pass", "Remove this pass", count > 1))
        removePass(session);
}

} // namespace

void passChoice(Session& session) {
    const std::vector<Pass>& passes = session.document.scene.passes;
    if (passes.size() < 2)
        return;
    std::vector<NumberChoice> choices;
    choices.reserve(passes.size());
    for (const Pass& pass : passes)
        choices.push_back({pass.enabled, pass.enabled ? "This pass is drawn." : "This pass is not drawn."});
    numberChoice("Pass", "Pass", "pass", choices, session.window.selection.pass);
}

void passSection(Session& session) {
    static const Pass initial;
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("Pass %d", session.window.selection.pass);
    ImGui::PushID("passes"); // there are other buttons with a +
    passButtons(session);
    ImGui::PopID();
    const auto chosen = static_cast<std::size_t>(session.window.selection.pass);
    const Owner owner{&selectedPass(session), &initial, elementOf<&Scene::passes>(chosen)};
    const StructTable& table = passTable(); // begins with the switch, which needs no caption
    assert(table.params.front().member == memberId<&Pass::enabled>);
    paramWidget(session, owner, table.params.front());
    paramRows(session, owner, {table.name, table.params.subspan(1), table.children});
}

} // namespace texplorer::ui
