#include "app/ui/model/preview.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/param_names.h"
#include "app/ui/widgets/param_parts.h"
#include "app/ui/widgets/param_tips.h"
#include "app/ui/widgets/popups.h"
#include "app/ui/widgets/theme.h"

#include <algorithm>
#include <span>

namespace texplorer::ui {
namespace {

constexpr std::size_t maxSegments = 8;
/// How many choices a list shows at once: of a longer one, each group after the first is a submenu.
constexpr std::size_t maxListed = 40;

/// The name of a row's choice in this place.
std::string nameOfChoice(const Session& session, const Owner& owner, const ParamRow& row,
                         const EnumRow& choice) {
    return owner.labelOf ? owner.labelOf(row, choice) : std::string(shownName(session.settings, choice));
}

/// The tip of the last widget, a choice: its name, its help, and a preview of the picture.
void offerChoice(const Session& session, const ParamRow& row, const EnumRow& choice, const std::string& path,
                 bool isCurrent) {
    noteItem(fmt::format("{}={}", path, choice.name));
    choiceTip(choice);
    if (isCurrent || !ImGui::IsItemHovered())
        return;
    preview(session, fmt::format("{}={}", path, choice.name), Sentence("{0}: {1}", row.label, choice.label),
            [&](Scene& scene) { (void)setParam(scene, path, choice.name); });
}

std::vector<Segment> segmentsOf(const Session& session, const Owner& owner, const ParamRow& row) {
    std::vector<Segment> segments;
    for (const EnumRow& choice : row.choices)
        segments.push_back(
            {owner.labelOf ? owner.labelOf(row, choice) : std::string(shownBrief(session.settings, choice)),
             choice.group});
    return segments;
}

bool listOfChoices(const Session& session, const Owner& owner, const ParamRow& row, EnumValue& value,
                   const std::string& path) {
    const EnumRow* current = findRow(row.choices, value.number);
    const float room = listRoom(ImGui::CalcItemWidth());
    const std::string full = current ? nameOfChoice(session, owner, row, *current) : "?";
    const bool hasRoom = owner.labelOf || !current || textWidth(full) <= room;
    const std::string shown =
        fitted(hasRoom ? full : std::string(shownBrief(session.settings, *current)), room);
    bool changed = false;
    if (!beginCombo("##value", shown.c_str(), ImGuiComboFlags_HeightLargest))
        return false;
    ImGui::PushStyleColor(ImGuiCol_Text, color::text); // the list of a dim row isn't dim
    float names = 0;
    for (const EnumRow& choice : row.choices)
        names = std::max(names, textWidth(nameOfChoice(session, owner, row, choice)));
    const auto drawChoice = [&](const EnumRow& choice) {
        const std::string name = nameOfChoice(session, owner, row, choice);
        const bool isCurrent = choice.value == value.number;
        if (ImGui::Selectable(label(fmt::format("{}##{}", name, choice.name)).c_str(), isCurrent)) {
            changed = !isCurrent;
            value.number = choice.value;
        }
        offerChoice(session, row, choice, path, isCurrent);
        if (isCurrent)
            ImGui::SetItemDefaultFocus();
        const std::string_view other = session.settings.glNames ? choice.label : choice.name;
        if (!choice.since.empty()) {
            ImGui::SameLine(names + ImGui::GetFontSize() * 2);
            ImGui::PushFont(codeFont());
            dimText(other);
            ImGui::PopFont();
        }
    };
    for (std::span<const EnumRow> rest = row.choices; !rest.empty();) {
        const std::string_view group = rest.front().group;
        const auto end = std::ranges::find_if(rest, [&](const EnumRow& each) { return each.group != group; });
        const auto choices = rest.first(static_cast<std::size_t>(end - rest.begin()));
        const bool isMenu = row.choices.size() > maxListed && rest.data() != row.choices.data();
        rest = rest.subspan(choices.size());
        const bool isOpen = !isMenu || beginMenu(label(group).c_str());
        if (isMenu)
            noteItem(fmt::format("{}#group {}", path, group));
        else if (!group.empty())
            caption(group);
        if (isOpen)
            std::ranges::for_each(choices, drawChoice);
        if (isMenu && isOpen)
            endMenu();
    }
    ImGui::PopStyleColor();
    endCombo();
    return changed;
}

} // namespace

std::optional<SegmentPlan> planChoices(const Session& session, const Owner& owner, const ParamRow& row,
                                       float width, std::size_t maxLines) {
    if (row.kind != Kind::Enum || row.choices.size() > maxSegments)
        return std::nullopt;
    return planSegments(segmentsOf(session, owner, row), width, maxLines);
}

bool enumControl(const Session& session, const Owner& owner, const ParamRow& row, EnumValue& value,
                 const std::string& path, const std::optional<SegmentPlan>& plan,
                 std::optional<ImU32> chosenInk) {
    if (!plan)
        return listOfChoices(session, owner, row, value, path);
    const EnumRow* current = findRow(row.choices, value.number);
    const auto chosen =
        current ? std::optional(static_cast<std::size_t>(current - row.choices.data())) : std::nullopt;
    const auto pressed = drawSegments(
        segmentsOf(session, owner, row), *plan, chosen,
        [&](std::size_t number) { offerChoice(session, row, row.choices[number], path, number == chosen); },
        chosenInk);
    if (!pressed || pressed == chosen)
        return false;
    value.number = row.choices[*pressed].value;
    return true;
}

} // namespace texplorer::ui
