#include "app/ui/details/commands_tab.h"

#include "app/ui/model/commands.h"
#include "app/ui/widgets/button_width.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/theme.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::ui {

namespace {

/// As lines of a program.
std::string asText(const std::vector<Command>& commands) {
    std::string text;
    for (const Command& command : commands)
        text += command.kind == Command::Kind::Heading ? fmt::format("/* {} */\n", command.text)
                                                       : command.text + "\n";
    return text;
}

void toolRow(const std::vector<Command>& commands) {
    const char* copy = "Copy";
    const float width = buttonWidth(copy);
    const char* caption = "Calls that set an initial value are dim";
    if (ImGui::GetContentRegionAvail().x > ImGui::CalcTextSize(caption).x + width) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("%s", caption);
        ImGui::SameLine();
    }
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - width);
    if (ImGui::Button(copy))
        ImGui::SetClipboardText(asText(commands).c_str());
    noteItem("copy commands");
    helpTip("Copies the calls, those of initial values, too");
}

} // namespace

void drawCommandsTab(const Session& session, CommandsTabState& state) {
    const std::vector<Command> commands = commandsOf(session.document.scene);
    toolRow(commands);
    ImGui::BeginChild("commands");
    ImGui::PushFont(codeFont());
    const float letter = ImGui::CalcTextSize("M").x;
    const auto columns =
        static_cast<std::size_t>(std::max(16.0F, ImGui::GetContentRegionAvail().x / letter - 1));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, ImGui::GetFontSize() * 0.15F});
    for (const Command& command : commands) {
        if (command.kind == Command::Kind::Heading) {
            ImGui::Dummy({0, ImGui::GetFontSize() * 0.3F});
            ImGui::TextDisabled("/* %s */", command.text.c_str());
            continue;
        }
        const bool last =
            !session.document.lastChanged.empty() && command.path == session.document.lastChanged;
        ImGui::PushStyleColor(ImGuiCol_Text, last              ? color::changed
                                             : command.changed ? color::text
                                                               : color::dim);
        ImGui::BeginGroup();
        for (const std::string& line : wrapCall(command.text, columns))
            ImGui::TextUnformatted(line.c_str());
        ImGui::EndGroup();
        ImGui::PopStyleColor();
        if (last)
            ImGui::GetWindowDrawList()->AddRectFilled(
                {ImGui::GetItemRectMin().x - letter, ImGui::GetItemRectMin().y},
                {ImGui::GetItemRectMin().x - letter * 0.6F, ImGui::GetItemRectMax().y}, color::changed);
        if (last && state.revealed != command.path)
            ImGui::SetScrollHereY(0.5F);
        noteItem("command:" + command.path);
    }
    state.revealed = session.document.lastChanged;
    ImGui::PopStyleVar();
    ImGui::PopFont();
    ImGui::EndChild();
}

} // namespace texplorer::ui
