#include "app/ui/widgets/list_buttons.h"

#include "app/ui/widgets/param_widgets.h"

#include <imgui.h>

#include <algorithm>
#include <string>

namespace texplorer::ui {

Edit editOf(ListEdit pressed, const std::string& list, std::size_t index) {
    switch (pressed) {
    case ListEdit::Add:
        return edit::Insert{list, index + 1, index};
    case ListEdit::Up:
        return edit::Move{list, index, index - 1};
    case ListEdit::Down:
        return edit::Move{list, index, index + 1};
    case ListEdit::Remove:
        break;
    }
    return edit::Remove{list, index};
}

std::optional<ListEdit> listButtons(const ListWords& words, std::size_t chosen, std::size_t count,
                                    std::size_t min, std::size_t max) {
    const std::string name = words.name;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float button = ImGui::GetFrameHeight();
    std::optional<ListEdit> pressed;
    ImGui::SameLine(std::max(ImGui::GetCursorPosX(), ImGui::GetContentRegionMax().x - 4 * button - 3 * gap));
    ImGui::PushID(words.name); // other lists have the same buttons
    if (squareButton("+", "add " + name, words.add, count < max))
        pressed = ListEdit::Add;
    ImGui::SameLine(0, gap);
    if (squareButton("↑", name + " up", words.up, chosen > 0))
        pressed = ListEdit::Up;
    ImGui::SameLine(0, gap);
    if (squareButton("↓", name + " down", words.down, chosen + 1 < count))
        pressed = ListEdit::Down;
    ImGui::SameLine(0, gap);
    if (squareButton("✕", "remove " + name, words.remove, count > min))
        pressed = ListEdit::Remove;
    ImGui::PopID();
    return pressed;
}

std::optional<ListEdit> elementButtons(const ListWords& words, const std::string& path, std::size_t index,
                                       std::size_t count) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float button = ImGui::GetFrameHeight();
    std::optional<ListEdit> pressed;
    ImGui::SameLine(std::max(ImGui::GetCursorPosX(), ImGui::GetContentRegionMax().x - 3 * button - 2 * gap));
    if (squareButton("↑", path + "#up", words.up, index > 0))
        pressed = ListEdit::Up;
    ImGui::SameLine(0, gap);
    if (squareButton("↓", path + "#down", words.down, index + 1 < count))
        pressed = ListEdit::Down;
    ImGui::SameLine(0, gap);
    if (squareButton("✕", path + "#remove", words.remove, true))
        pressed = ListEdit::Remove;
    return pressed;
}

} // namespace texplorer::ui
