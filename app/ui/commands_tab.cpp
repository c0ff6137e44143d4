#include "app/ui/commands.h"
#include "app/ui/panels.h"
#include "app/ui/param_widgets.h"
#include "app/ui/theme.h"

#include <algorithm>

namespace texplorer::ui {

void drawCommandsTab(Session& session) {
    ImGui::BeginChild("commands");
    ImGui::PushFont(codeFont());
    const float letter = ImGui::CalcTextSize("M").x;
    const auto columns =
        static_cast<std::size_t>(std::max(16.0F, ImGui::GetContentRegionAvail().x / letter - 1));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, ImGui::GetFontSize() * 0.15F});
    for (const Command& command : commandsOf(session.scene)) {
        if (command.kind == Command::Kind::Heading) {
            ImGui::Dummy({0, ImGui::GetFontSize() * 0.3F});
            ImGui::TextDisabled("/* %s */", command.text.c_str());
            continue;
        }
        const bool last = !session.lastChanged.empty() && command.path == session.lastChanged;
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
        if (last && session.revealedCommand != command.path)
            ImGui::SetScrollHereY(0.5F);
        noteItem(session, "command:" + command.path);
    }
    session.revealedCommand = session.lastChanged;
    ImGui::PopStyleVar();
    ImGui::PopFont();
    ImGui::EndChild();
}

} // namespace texplorer::ui
