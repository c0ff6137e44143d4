#include "app/ui/widgets/tip.h"

#include "app/ui/language/translate.h"
#include "app/ui/widgets/fonts.h"
#include "app/ui/widgets/inset_placement.h"
#include "app/ui/widgets/widget_places.h"
#include "app/ui/widgets/wrapped_text.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/text/printable.h"

#include <fmt/core.h>
#include <imgui_internal.h> // the positions of windows

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace texplorer::ui {
namespace {

constexpr float tipWidth = 26; ///< in letters' heights

// Global, like Dear ImGui's context, for the frame that is being drawn.
float roomForHints = 0;
Hint hintSaid;

Box boxOf(const ImGuiWindow& window) {
    return {window.Pos, {window.Pos.x + window.Size.x, window.Pos.y + window.Size.y}};
}

/// Areas that a tip should not cover.
std::vector<Box> keptInSight(const ImGuiWindow& window) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    std::vector<Box> kept{{{window.Pos.x, low.y}, {window.Pos.x + window.Size.x, high.y}}};
    for (const ImGuiPopupData& popup : ImGui::GetCurrentContext()->OpenPopupStack) {
        if (popup.Window && (popup.Window->Flags & ImGuiWindowFlags_Modal) == 0)
            kept.push_back(boxOf(*popup.Window));
    }
    const ImGuiWindow* view = ImGui::FindWindowByName(N_("View"));
    if (view && view->WasActive && window.RootWindow != view)
        kept.push_back(boxOf(*view));
    return kept;
}

ImVec2 tipPlace(ImVec2 size) {
    const ImGuiWindow& window = *ImGui::GetCurrentWindowRead();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const ImGuiWindow* status = ImGui::FindWindowByName(N_("Status"));
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    const float lowest = (status ? status->Pos.y : display.y) - gap - size.y;
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const Box panel = boxOf(*window.RootWindow);
    const std::array places{ImVec2(low.x, high.y + gap),
                            ImVec2(low.x, low.y - gap - size.y),
                            ImVec2(panel.high.x + gap, low.y),
                            ImVec2(panel.low.x - gap - size.x, low.y),
                            ImVec2(low.x, lowest),
                            ImVec2(panel.high.x + gap, lowest)};
    const std::vector<Box> kept = keptInSight(window);
    ImVec2 best;
    float least = -1;
    for (const ImVec2& each : places) {
        const ImVec2 at(std::clamp(each.x, 0.0F, std::max(0.0F, display.x - size.x)),
                        std::clamp(each.y, 0.0F, std::max(0.0F, display.y - size.y)));
        float hidden = 0;
        for (const Box& box : kept)
            hidden += sharedArea({at, {at.x + size.x, at.y + size.y}}, box);
        if (least < 0 || hidden < least) {
            best = at;
            least = hidden;
        }
    }
    return best;
}

} // namespace

void beginHints(float room) {
    roomForHints = room;
    hintSaid = {};
}

Hint endHints() {
    roomForHints = 0;
    return std::exchange(hintSaid, {});
}

bool fitsBelow(const Sentence& words) {
    return roomForHints > 0 && words.english().find('\n') == std::string_view::npos &&
           ImGui::CalcTextSize(tr(words).c_str()).x <= roomForHints;
}

void hint(Sentence words, bool isProblem) {
    noteItem(fmt::format("hint:{}", words));
    hintSaid = {std::move(words), isProblem};
}

void showTip(std::span<const TipLine> lines) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float room = ImGui::GetFontSize() * tipWidth;
    ImVec2 size{0, -style.ItemSpacing.y};
    for (const TipLine& line : lines) {
        if (line.code)
            ImGui::PushFont(codeFont());
        const ImVec2 each = wrappedSize(line.words, room);
        if (line.code)
            ImGui::PopFont();
        size = {std::max(size.x, each.x), size.y + each.y + style.ItemSpacing.y};
    }
    ImGui::SetNextWindowPos(
        tipPlace({size.x + 2 * style.WindowPadding.x, size.y + 2 * style.WindowPadding.y}));
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(style.WindowPadding.x + room);
    for (const TipLine& line : lines) {
        ImGui::PushStyleColor(ImGuiCol_Text, line.ink); // independent of its item's colour
        if (line.code)
            ImGui::PushFont(codeFont());
        plainText(line.words);
        if (line.code)
            ImGui::PopFont();
        ImGui::PopStyleColor();
    }
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool wantsHelp() {
    // Disabled items need a tip most of all.
    return ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) &&
           !ImGui::IsMouseDown(ImGuiMouseButton_Left);
}

bool hasJustClicked() {
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 way(io.MousePos.x - io.MouseClickedPos[0].x, io.MousePos.y - io.MouseClickedPos[0].y);
    const float near = ImGui::GetFontSize() * 0.4F;
    return io.MouseClickedTime[0] > 0 && way.x * way.x + way.y * way.y < near * near;
}

void helpTip(const Sentence& words) {
    if (!wantsHelp())
        return;
    if (fitsBelow(words))
        return hint(words);
    if (ImGui::IsItemHovered() && hasJustClicked())
        return;
    const TipLine line{printable(tr(words), LineBreaks::Keep)};
    showTip({&line, 1});
}

void item(std::string_view name, const Sentence& help) {
    noteItem(name);
    helpTip(help);
}

} // namespace texplorer::ui
