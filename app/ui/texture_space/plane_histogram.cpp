#include "app/ui/texture_space/plane_histogram.h"

#include "app/ui/language/translate.h"
#include "app/ui/texture_space/plane_drawing.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_places.h"
#include "app/ui/widgets/wrapped_text.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace texplorer::ui {
namespace {

ImU32 componentTint(std::size_t component) {
    return component < 3 ? componentColor(static_cast<int>(component)) : color::text;
}

const char* componentLetter(std::size_t component) {
    return channelRows[component + 1].brief;
}

/// Red, green and blue, or the shown component.
std::vector<std::size_t> shownComponents(Channel channel) {
    if (channel == Channel::All)
        return {0, 1, 2};
    return {static_cast<std::size_t>(channel) - 1};
}

/// The bars of one component, with its letter in front.
void drawBars(ImDrawList& draw, const reference::TexelStatistics& statistics, std::size_t component,
              ImVec2 low, ImVec2 high) {
    const auto& counts = statistics.components[component].counts;
    const std::uint32_t most = std::max(1U, std::ranges::max(counts));
    const ImU32 tint = componentTint(component);
    const float em = ImGui::GetFontSize();
    draw.AddText({low.x + em * 0.2F, std::round((low.y + high.y) / 2 - em / 2)}, tint,
                 componentLetter(component));
    const float left = low.x + em * 1.1F;
    const float one = (high.x - left) / 256;
    for (int value = 0; value < 256; ++value) {
        const std::uint32_t count = counts[static_cast<std::size_t>(value)];
        if (count == 0)
            continue;
        // Rare values are visible, too.
        const float share = std::sqrt(static_cast<float>(count) / static_cast<float>(most));
        const float x = left + one * static_cast<float>(value);
        draw.AddRectFilled({x, high.y - (high.y - low.y) * share}, {x + std::max(1.0F, one), high.y}, tint);
    }
}

} // namespace

void drawHistogram(const LevelPicture& level, Channel channel, float width) {
    const float em = ImGui::GetFontSize();
    const float height = em * 4.5F;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::Dummy({width, height});
    noteItem("histogram");
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(low, {low.x + width, low.y + height}, color::ground, em * 0.2F);
    if (const reference::TexelStatistics* statistics = level.statistics()) {
        const std::vector<std::size_t> shown = shownComponents(channel);
        const float line = height / static_cast<float>(shown.size());
        for (std::size_t i = 0; i < shown.size(); ++i) {
            const float top = low.y + line * static_cast<float>(i);
            const ImVec2 from(low.x, top + 1);
            const ImVec2 to(low.x + width, top + line);
            drawBars(draw, *statistics, shown[i], from, to);
            noteDrawn(fmt::format("histogram:{}", componentLetter(shown[i])), from, to);
        }
    }
    const char* words = level.isComputing()       ? "Counting…"
                        : level.problem().empty() ? ""
                                                  : "There is no such level";
    if (*words == '\0')
        return;
    const ImVec2 size = ImGui::CalcTextSize(tr(words));
    const ImVec2 at(low.x + width - size.x - em * 0.5F, low.y + em * 0.3F);
    drawTextChip(draw, chipBox(at, size), em, color::text, tr(words));
    noteDrawn(std::string("histogram:") + words, at, {at.x + size.x, at.y + size.y});
}

void drawStatistics(const LevelPicture& level) {
    const reference::TexelStatistics* statistics = level.statistics();
    const ImVec2 size(ImGui::GetFontSize() * 16, 0);
    if (!statistics || !ImGui::BeginTable("statistics", 4, ImGuiTableFlags_SizingStretchSame, size))
        return;
    for (const char* name : {"", tr("min"), tr("max"), tr("mean")}) {
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", name);
    }
    for (std::size_t i = 0; i < statistics->components.size(); ++i) {
        const reference::ComponentStatistics& each = statistics->components[i];
        const std::string least = std::to_string(each.least);
        const std::string most = std::to_string(each.most);
        const std::string mean = fmt::format("{:.2f}", each.mean);
        ImGui::TableNextColumn();
        plainText(componentLetter(i), componentTint(i));
        for (const std::string& number : {least, most, mean}) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(number.c_str());
        }
        noteItem(fmt::format("statistics:{} {} {} {}", componentLetter(i), least, most, mean));
    }
    ImGui::EndTable();
}

} // namespace texplorer::ui
