// The tab "History": the undo steps as pictures of the view.

#include "app/ui/timeline/history_tab.h"

#include "app/ui/language/translate.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/theme.h"
#include "texplorer/base/sentence.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace texplorer::ui {
namespace {

constexpr float pictureWidth = 6.4F; // in widths of a letter m
constexpr float pictureHeight = 4;

Sentence stepName(const History& history, std::size_t step) {
    const Sentence& name = history.nameOf(step);
    return name.empty() ? N_("Start") : name;
}

/// The name of a step in at most two lines.
std::vector<std::string> nameLines(const Sentence& english, float room) {
    const std::string name = tr(english);
    const std::string lines = wrappedLines(name, room);
    const std::size_t end = lines.find('\n');
    if (end == std::string::npos)
        return {lines};
    const std::size_t rest = std::min(name.find_first_not_of(' ', end), name.size());
    return {lines.substr(0, end), fitted(ProperName{name.substr(rest)}, room)};
}

Sentence stepHelp(const History& history, std::size_t step) {
    const Sentence name = stepName(history, step);
    const std::size_t present = history.position();
    if (step == present)
        return {N_("{0}\nThe present state."), name};
    return step < present ? Sentence("{0}\nClick: undo {1}", name,
                                     Sentence::plural("{0} step", "{0} steps", present - step))
                          : Sentence("{0}\nClick: redo {1}", name,
                                     Sentence::plural("{0} step", "{0} steps", step - present));
}

/// Returns true if it was clicked.
bool stepCard(const History& history, std::size_t step, const Pictures& pictures) {
    const float em = ImGui::GetFontSize();
    const float pad = em * 0.3F;
    const ImVec2 picture(em * pictureWidth, em * pictureHeight);
    const ImVec2 size(picture.x + 2 * pad, picture.y + em * 2.45F + 2 * pad);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high(low.x + size.x, low.y + size.y);
    const bool clicked = ImGui::InvisibleButton(fmt::format("step {}", step).c_str(), size);
    item(fmt::format("history:{}", step), stepHelp(history, step));
    if (!ImGui::IsRectVisible(low, high))
        return clicked;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const bool present = step == history.position();
    const bool ahead = step > history.position();
    if (ImGui::IsItemHovered())
        draw.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_HeaderHovered), pad);
    const ImVec2 inside(low.x + pad, low.y + pad);
    draw.AddRectFilled(inside, {inside.x + picture.x, inside.y + picture.y}, color::ground);
    if (const std::shared_ptr<const Image>& image = history.pictureOf(step))
        drawImageIn(pictures, image, inside, picture,
                    std::min(picture.x / static_cast<float>(image->width),
                             picture.y / static_cast<float>(image->height)),
                    IM_COL32(255, 255, 255, ahead ? 90 : 255));
    if (present)
        draw.AddRect(low, high, color::chosen, pad, 0, em * 0.12F);
    const std::vector<std::string> name = nameLines(stepName(history, step), picture.x);
    for (std::size_t i = 0; i < name.size(); ++i)
        draw.AddText({inside.x, inside.y + picture.y + pad + em * 1.15F * static_cast<float>(i)},
                     ahead ? color::dim : color::text, name[i].c_str());
    return clicked;
}

} // namespace

void drawHistoryTab(const Session& session, HistoryTabState& state, const Pictures& pictures) {
    const History& history = session.document.history;
    ImGui::BeginChild("steps");
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float width = ImGui::GetFontSize() * (pictureWidth + 0.6F);
    const auto columns = std::max<std::size_t>(
        1, static_cast<std::size_t>((ImGui::GetContentRegionAvail().x + gap) / (width + gap)));
    for (std::size_t step = 0; step < history.size(); ++step) {
        if (step % columns > 0)
            ImGui::SameLine();
        if (stepCard(history, step, pictures))
            session.out.requests.emplace_back(GoToStep{step});
        if (step == history.position() && std::exchange(state.shown, step) != step)
            ImGui::SetScrollHereY();
    }
    ImGui::EndChild();
}

} // namespace texplorer::ui
