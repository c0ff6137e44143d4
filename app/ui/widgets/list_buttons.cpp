#include "app/ui/widgets/list_buttons.h"

#include "app/ui/widgets/param_widgets.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <span>

namespace texplorer::ui {

namespace {

struct ListButton {
    ListEdit edit;
    const char* sign;
    std::string name;
    const char* help;
    bool enabled;
};

/// At the right end of the line.
std::optional<ListEdit> pressedOf(std::span<const ListButton> buttons) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const auto count = static_cast<float>(buttons.size());
    const float width = count * ImGui::GetFrameHeight() + (count - 1) * gap;
    std::optional<ListEdit> pressed;
    ImGui::SameLine(std::max(ImGui::GetCursorPosX(), ImGui::GetContentRegionMax().x - width));
    for (const ListButton& button : buttons) {
        if (&button != &buttons.front())
            ImGui::SameLine(0, gap);
        if (squareButton(button.sign, button.name, button.help, button.enabled))
            pressed = button.edit;
    }
    return pressed;
}

} // namespace

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
    ImGui::PushID(words.name); // other lists have the same buttons
    const auto pressed =
        pressedOf(std::array{ListButton{ListEdit::Add, "+", "add " + name, words.add, count < max},
                             ListButton{ListEdit::Up, "↑", name + " up", words.up, chosen > 0},
                             ListButton{ListEdit::Down, "↓", name + " down", words.down, chosen + 1 < count},
                             ListButton{ListEdit::Remove, "✕", "remove " + name, words.remove, count > min}});
    ImGui::PopID();
    return pressed;
}

std::optional<ListEdit> elementButtons(const ListWords& words, const std::string& path, std::size_t index,
                                       std::size_t count) {
    return pressedOf(
        std::array{ListButton{ListEdit::Up, "↑", path + "#up", words.up, index > 0},
                   ListButton{ListEdit::Down, "↓", path + "#down", words.down, index + 1 < count},
                   ListButton{ListEdit::Remove, "✕", path + "#remove", words.remove, true}});
}

} // namespace texplorer::ui
