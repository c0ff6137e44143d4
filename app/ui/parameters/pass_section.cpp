#include "app/ui/language/translate.h"
#include "app/ui/parameters/sections.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/list_buttons.h"
#include "app/ui/widgets/model_choice.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace texplorer::ui {
namespace {

/// Adds a copy after the selected pass, because most passes differ from the previous one in a few
/// parameters; moves or removes the selected pass.
void editPasses(const Session& session) {
    constexpr ListWords words{"pass",
                              N_("Add a copy of this pass after it"),
                              N_("Draw this pass earlier"),
                              N_("Draw this pass later"),
                              N_("Remove this pass"),
                              N_("Add pass"),
                              N_("Reorder passes"),
                              N_("Remove pass")};
    const auto chosen = static_cast<std::size_t>(session.look.selection.pass);
    const auto pressed = listButtons(words, chosen, presentScene(session).passes.size(), 1, maxPasses);
    if (!pressed)
        return;
    const std::string list = keyOf<&Scene::passes>();
    std::vector<Edit> edits{editOf(*pressed, list, chosen)};
    if (pressed == ListEdit::Add &&
        selectedPass(session).depthFunc == CompareFunc::Less) // no depth is less than the previous pass's
        edits.emplace_back(edit::Set{fmt::format("{}[{}].{}", list, chosen + 1, keyOf<&Pass::depthFunc>()),
                                     std::string(rowOf(CompareFunc::LessEqual).name)});
    submit(session, {.name = words.nameOf(*pressed), .edits = std::move(edits)});
}

void setModels(const Session& session, const std::vector<int>& models) {
    const auto pass = static_cast<std::size_t>(session.look.selection.pass);
    const std::string path = fmt::format("{}.{}", elementOf<&Scene::passes>(pass), keyOf<&Pass::models>());
    submit(session, {.name = N_("Models of the pass"),
                     .edits = {edit::Set{path, fmt::format("{}", fmt::join(models, ","))}},
                     .path = path});
}

/// One model of the list: a tick, and, if it is drawn, buttons that draw it earlier or later. Returns whether
/// the list changed.
bool modelOfPass(std::vector<int>& named, int index, std::size_t place, const Sentence& name) {
    const float button = ImGui::GetFrameHeight();
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    bool draws = place < named.size();
    ImGui::BeginDisabled(draws && named.size() == 1); // disable the pass instead of drawing nothing
    const bool ticked = ImGui::Checkbox(tr(Sentence("{0}  {1}", index, name)).c_str(), &draws);
    noteItem(fmt::format("pass models:{}", index));
    ImGui::EndDisabled();
    if (ticked) {
        if (draws)
            named.push_back(index);
        else
            std::erase(named, index);
        return true;
    }
    if (!draws)
        return false;
    ImGui::SameLine(std::max(ImGui::GetCursorPosX(), ImGui::GetContentRegionMax().x - 2 * button - gap));
    const bool up = squareButton("↑", fmt::format("pass models:{} up", index),
                                 "Draw this model earlier in the pass", place > 0);
    ImGui::SameLine(0, gap);
    const bool down = squareButton("↓", fmt::format("pass models:{} down", index),
                                   "Draw this model later in the pass", place + 1 < named.size());
    if (up || down)
        std::swap(named[place], named[up ? place - 1 : place + 1]);
    return up || down;
}

/// All models, or the ticked ones.
void modelsOfPass(const Session& session) {
    const std::vector<Model>& models = presentScene(session).models;
    const std::vector<int>& named = selectedPass(session).models;
    std::vector<int> order = named; // followed by those that it leaves out
    for (int i = 0; i < static_cast<int>(models.size()); ++i) {
        if (std::ranges::find(named, i) == named.end())
            order.push_back(i);
    }
    caption("Models");
    bool all = named.empty();
    if (ImGui::Checkbox(label("All models"), &all))
        setModels(session, all ? std::vector<int>{} : order);
    item("pass models:all", "Whether this pass draws all models in order, or only the selected ones");
    if (named.empty())
        return;
    for (std::size_t place = 0; place < order.size(); ++place) {
        const int index = order[place];
        ImGui::PushID(index);
        std::vector<int> edited = named;
        if (modelOfPass(edited, index, place, shownNameOf(models[static_cast<std::size_t>(index)])))
            setModels(session, edited);
        ImGui::PopID();
    }
}

/// Where a button has a dot, it is in its upper right corner.
void drawDot() {
    const ImVec2 corner(ImGui::GetItemRectMax().x, ImGui::GetItemRectMin().y);
    const float radius = ImGui::GetFontSize() * 0.16F;
    ImGui::GetWindowDrawList()->AddCircleFilled({corner.x - 2.2F * radius, corner.y + 2.2F * radius}, radius,
                                                color::t);
}

/// A button with the number of a pass.
bool passButton(const Pass& pass, int number, float width, bool isChosen) {
    const bool pressed = markedButton(fmt::format("{}##pass", number).c_str(), isChosen, {width, 0});
    noteItem(fmt::format("pass:{}", number));
    if (pass.enabled)
        drawDot();
    const char* state = pass.enabled ? N_("This pass is drawn.") : N_("This pass is not drawn.");
    helpTip(pass.name.empty() ? state : Sentence("{0}\n{1}", ProperName{pass.name}, state));
    return pressed;
}

} // namespace

void passChoice(const Session& session) {
    const std::vector<Pass>& passes = presentScene(session).passes;
    if (passes.size() < 2)
        return;
    const float words = ImGui::CalcTextSize(tr("Pass")).x;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float room = ImGui::GetContentRegionAvail().x;
    const auto count = static_cast<float>(passes.size());
    float left = room - words - gap * (count + 1);
    const bool ownLine = left < count * ImGui::GetFontSize() * 1.2F; // the buttons are below the word
    if (ownLine)
        left = room - gap * (count - 1);
    const float width = std::clamp(std::floor(left / count), 1.0F, ImGui::GetFrameHeight() * 1.3F);
    labelText("Pass");
    for (int i = 0; i < static_cast<int>(passes.size()); ++i) {
        if (i > 0 || !ownLine)
            ImGui::SameLine(0, gap * (i == 0 ? 2.0F : 1.0F));
        if (passButton(passes[static_cast<std::size_t>(i)], i, width, i == session.look.selection.pass))
            act(session, [i](Session& changed) { changed.look.selection.pass = i; });
    }
    bool steps = session.view.stepsThroughPasses;
    if (ImGui::Checkbox(label("Step: only up to this pass"), &steps))
        act(session, [steps](Session& changed) { changed.view.stepsThroughPasses = steps; });
    item("step through passes",
         "Hides the passes after the selected one. Select 0, 1, 2 … to see them added one by one");
}

void passSection(const Session& session) {
    labelText(Sentence("Pass {0}", session.look.selection.pass), color::dim);
    editPasses(session);
    const std::vector<ShownStruct> places = shownStructs(session, Section::Pass); // the pass and its fog
    const Owner& owner = places.front().owner;
    // The switch needs no caption, and the models are next to the name.
    const StructTable& table = passTable();
    const auto rest = std::ranges::find(table.params, memberId<&Pass::models>, &ParamRow::member) + 1;
    for (auto row = table.params.begin(); row != rest; ++row)
        paramWidget(session, owner, *row);
    modelsOfPass(session);
    paramRows(session, owner, {table.name, {rest, table.params.end()}, table.children});
    RowOptions options;
    options.folds = [&](const ParamRow& row) {
        return !selectedPass(session).fog.enabled && row.member != memberId<&Fog::enabled>;
    };
    paramRows(session, places.back().owner, fogTable(), options);
}

} // namespace texplorer::ui
