#include "app/ui/widgets/param_parts.h"

#include <fmt/core.h>
#include <imgui.h>

#include <array>
#include <cmath>

namespace texplorer::ui {
namespace {

constexpr std::array axisLetters{"x", "y", "z", "w"};
constexpr ImGuiColorEditFlags colorLook =
    ImGuiColorEditFlags_AlphaBar | ImGuiColorEditFlags_AlphaPreviewHalf | ImGuiColorEditFlags_Float;
constexpr std::array coordinateLetters{"s", "t", "r", "q"};

struct NumberCell {
    float& number;
    int component;
    const char* letter; ///< nullptr: none
    int id;
};

/// A number for each of these cells, so many in a line.
template<class CellAt>
bool numberGrid(const Session& session, const ParamRow& row, const std::string& path, int count, int perLine,
                const CellAt& cellAt) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const auto columns = static_cast<float>(perLine);
    const float width = std::floor((ImGui::CalcItemWidth() - gap * (columns - 1)) / columns);
    bool changed = false;
    ImGui::BeginGroup();
    for (int i = 0; i < count; ++i) {
        if (i % perLine > 0)
            ImGui::SameLine(0, gap);
        const NumberCell cell = cellAt(i);
        ImGui::PushID(cell.id);
        ImGui::SetNextItemWidth(width);
        changed |= dragNumber("##number", cell.number, row.range, cell.component, nullptr, cell.letter);
        noteItem(fmt::format("{}[{}]", path, cell.id));
        sealAfterItem(session);
        ImGui::PopID();
    }
    ImGui::EndGroup();
    return changed;
}

} // namespace

bool colorControl(const glm::vec4& value) {
    const ImVec4 shown(value.x, value.y, value.z, value.w);
    const ImVec2 size(ImGui::CalcItemWidth(), ImGui::GetFrameHeight());
    if (ImGui::ColorButton("##value", shown, colorLook | ImGuiColorEditFlags_NoTooltip, size))
        ImGui::OpenPopup("picker");
    return false;
}

bool colorPicker(const Session& session, glm::vec4& value, const std::string& name) {
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 15);
    const bool changed =
        ImGui::ColorPicker4("##picker", &value.x,
                            colorLook | ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_DisplayRGB |
                                ImGuiColorEditFlags_DisplayHex);
    noteItem(name);
    sealAfterItem(session); // before the edit: a press is already an edit
    return changed;
}

bool vectorControl(const Session& session, const ParamRow& row, std::span<float> numbers,
                   const std::string& path) {
    const auto count = static_cast<int>(numbers.size());
    return numberGrid(session, row, path, count, count, [&](int i) {
        const auto at = static_cast<std::size_t>(i);
        return NumberCell{numbers[at], i, axisLetters.at(at), i};
    });
}

bool matrixControl(const Session& session, const ParamRow& row, glm::mat4& value, const std::string& path) {
    return numberGrid(session, row, path, 16, 4, [&](int i) {
        const int line = i / 4;
        const int column = i % 4;
        const char* letter = column == 0 ? coordinateLetters.at(static_cast<std::size_t>(line)) : nullptr;
        return NumberCell{value[column][line], line, letter, column * 4 + line};
    });
}

} // namespace texplorer::ui
