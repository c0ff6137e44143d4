#include "app/ui/widgets/vector_controls.h"

#include "app/ui/widgets/drag_number.h"
#include "app/ui/widgets/param_widgets.h"

#include <fmt/core.h>
#include <imgui.h>

#include <array>
#include <cmath>

namespace texplorer::ui {
namespace {

constexpr std::array axisLetters{"x", "y", "z", "w"};
constexpr std::array coordinateLetters{"s", "t", "r", "q"};

template<class Vector>
bool vectorNumbers(const Session& session, const ParamRow& row, Vector& value, const std::string& path) {
    constexpr int count = Vector::length();
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = std::floor((ImGui::CalcItemWidth() - gap * (count - 1)) / count);
    bool changed = false;
    ImGui::BeginGroup();
    for (int i = 0; i < count; ++i) {
        if (i > 0)
            ImGui::SameLine(0, gap);
        ImGui::PushID(i);
        ImGui::SetNextItemWidth(width);
        changed |= dragNumber("##component", value[i], row.range, i, nullptr,
                              axisLetters.at(static_cast<std::size_t>(i)));
        noteItem(fmt::format("{}[{}]", path, i));
        sealAfterItem(session);
        ImGui::PopID();
    }
    ImGui::EndGroup();
    return changed;
}

} // namespace

bool colorControl(glm::vec4& value) {
    constexpr ImGuiColorEditFlags look =
        ImGuiColorEditFlags_AlphaBar | ImGuiColorEditFlags_AlphaPreviewHalf | ImGuiColorEditFlags_Float;
    const ImVec4 shown(value.x, value.y, value.z, value.w);
    const ImVec2 size(ImGui::CalcItemWidth(), ImGui::GetFrameHeight());
    if (ImGui::ColorButton("##value", shown, look | ImGuiColorEditFlags_NoTooltip, size))
        ImGui::OpenPopup("picker");
    return false;
}

bool colorPopup(const Session& session, glm::vec4& value, const std::string& path) {
    bool changed = false;
    if (ImGui::BeginPopup("picker")) {
        ImGui::SetNextItemWidth(ImGui::GetFontSize() * 15);
        changed = ImGui::ColorPicker4("##picker", &value.x,
                                      ImGuiColorEditFlags_AlphaBar | ImGuiColorEditFlags_AlphaPreviewHalf |
                                          ImGuiColorEditFlags_Float | ImGuiColorEditFlags_NoSidePreview |
                                          ImGuiColorEditFlags_DisplayRGB | ImGuiColorEditFlags_DisplayHex);
        noteItem(path + "#picker");
        sealAfterItem(session);
        ImGui::EndPopup();
    }
    return changed;
}

bool vectorControl(const Session& session, const ParamRow& row, glm::vec3& value, const std::string& path) {
    return vectorNumbers(session, row, value, path);
}

bool vectorControl(const Session& session, const ParamRow& row, glm::vec4& value, const std::string& path) {
    return vectorNumbers(session, row, value, path);
}

bool matrixControl(const Session& session, const ParamRow& row, glm::mat4& value, const std::string& path) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = std::floor((ImGui::CalcItemWidth() - gap * 3) / 4);
    bool changed = false;
    ImGui::BeginGroup();
    for (int i = 0; i < 16; ++i) {
        if (i % 4 > 0)
            ImGui::SameLine(0, gap);
        const int element = i % 4 * 4 + i / 4;
        ImGui::PushID(element);
        ImGui::SetNextItemWidth(width);
        changed |= dragNumber("##element", value[i % 4][i / 4], row.range, i / 4, nullptr,
                              i % 4 == 0 ? coordinateLetters.at(static_cast<std::size_t>(i / 4)) : nullptr);
        noteItem(fmt::format("{}[{}]", path, element));
        sealAfterItem(session);
        ImGui::PopID();
    }
    ImGui::EndGroup();
    return changed;
}

} // namespace texplorer::ui
