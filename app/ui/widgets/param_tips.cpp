#include "app/ui/widgets/param_tips.h"

#include "app/ui/model/findings.h"
#include "app/ui/widgets/hints.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/theme.h"
#include "core/base/printable.h"

#include <fmt/core.h>

namespace texplorer::ui {
namespace {

constexpr float tipWidth = 26; ///< of a tooltip, in letters' heights

/// "since OpenGL 1.4", or the extension that has it.
std::string originOf(const EnumRow& choice) {
    const bool extension = choice.since.starts_with("GL_");
    return (extension ? "from " : "since OpenGL ") + std::string(choice.since);
}

} // namespace

void text(std::string_view words) {
    ImGui::TextUnformatted(words.data(), words.data() + words.size());
}

void dimText(std::string_view words) {
    ImGui::PushStyleColor(ImGuiCol_Text, color::dim);
    text(words);
    ImGui::PopStyleColor();
}

void helpTip(std::string_view words) {
    // What is disabled most of all has to say why.
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) ||
        ImGui::IsMouseDown(ImGuiMouseButton_Left))
        return;
    if (fitsBelow(words))
        return hint(std::string(words));
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * tipWidth);
    text(printable(words, LineBreaks::Keep));
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void warningSign() {
    const float em = ImGui::GetFontSize();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::Dummy({em * 0.85F, ImGui::GetFrameHeight()});
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float top = low.y + ImGui::GetStyle().FramePadding.y;
    const float middle = low.x + em * 0.425F;
    draw.AddTriangleFilled({middle, top + em * 0.1F}, {low.x + em * 0.85F, top + em * 0.9F},
                           {low.x, top + em * 0.9F}, color::problem);
    draw.AddRectFilled({middle - em * 0.05F, top + em * 0.38F}, {middle + em * 0.05F, top + em * 0.64F},
                       color::ground);
    draw.AddRectFilled({middle - em * 0.05F, top + em * 0.7F}, {middle + em * 0.05F, top + em * 0.8F},
                       color::ground);
}

void noteSign() {
    const float em = ImGui::GetFontSize();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::Dummy({em * 0.85F, ImGui::GetFrameHeight()});
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 middle(low.x + em * 0.425F, low.y + ImGui::GetStyle().FramePadding.y + em * 0.5F);
    draw.AddCircleFilled(middle, em * 0.4F, color::dim);
    const auto stroke = [&](float from, float to) {
        draw.AddRectFilled({middle.x - em * 0.05F, middle.y + em * from},
                           {middle.x + em * 0.05F, middle.y + em * to}, color::ground);
    };
    stroke(-0.26F, -0.14F);
    stroke(-0.06F, 0.24F);
}

namespace {

/// In one line below, what matters most first: true where that has room for what has to be said.
bool hintParam(const ParamRow& row, const Value& value, const Value& initial, Target target,
               const Finding* idle, const Finding* problem) {
    const bool isWrong = problem && problem->severity <= Severity::Warning;
    std::string words = idle      ? fmt::format("No effect now: {}.", idle->sentence)
                        : problem ? sentenceOf(*problem)
                                  : std::string(row.help);
    if (!fitsBelow(words))
        return false;
    const auto add = [&words](const std::string& more) {
        if (std::string longer = words + "  ·  " + more; !more.empty() && fitsBelow(longer))
            words = std::move(longer);
    };
    if (idle || problem)
        add(std::string(row.help));
    add(formatCall(row, value, target));
    if (value != initial)
        add(fmt::format("Initially {}; ↺ resets it.", formatValue(row, initial)));
    hint(std::move(words), idle || isWrong);
    return true;
}

} // namespace

void paramTip(const ParamRow& row, const Value& value, const Value& initial, Target target,
              const Finding* idle, const Finding* problem) {
    // What is disabled most of all has to say why.
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) ||
        ImGui::IsMouseDown(ImGuiMouseButton_Left))
        return;
    if (hintParam(row, value, initial, target, idle, problem))
        return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * tipWidth);
    if (const std::string call = formatCall(row, value, target); !call.empty()) {
        ImGui::PushFont(codeFont());
        text(call);
        ImGui::PopFont();
    }
    text(row.help);
    if (row.kind == Kind::Text && !std::get<std::string>(value).empty())
        dimText(std::get<std::string>(value)); // the field shows the beginning
    if (row.kind == Kind::Enum) {
        if (const EnumRow* choice = findRow(row.choices, std::get<EnumValue>(value).number)) {
            dimText(fmt::format("{}: {}", choice->label, choice->help));
            if (!choice->since.empty())
                dimText(fmt::format("{}, {}", choice->name, originOf(*choice)));
        }
    }
    if (row.kind == Kind::Int || row.kind == Kind::Float || row.kind == Kind::Vec3 || row.kind == Kind::Vec4)
        dimText("Drag it, or double-click to type a number.");
    if (problem) {
        const bool isWrong = problem->severity <= Severity::Warning;
        ImGui::PushStyleColor(ImGuiCol_Text, isWrong ? color::problem : color::text);
        text(sentenceOf(*problem));
        ImGui::PopStyleColor();
    }
    ImGui::PushStyleColor(ImGuiCol_Text, color::problem);
    if (idle)
        text(fmt::format("No effect now: {}.", idle->sentence));
    ImGui::PopStyleColor();
    if (value != initial) {
        ImGui::PushStyleColor(ImGuiCol_Text, color::changed);
        text(fmt::format("Initially {}; ↺ resets it.", formatValue(row, initial)));
        ImGui::PopStyleColor();
    }
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void choiceTip(const EnumRow& choice) {
    if (!ImGui::IsItemHovered())
        return;
    if (fitsBelow(choice.help))
        return hint(std::string(choice.help));
    // Beside the list, so that it doesn't hide the next choices.
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth();
    if (right + ImGui::GetFontSize() * (tipWidth + 2) < ImGui::GetIO().DisplaySize.x)
        ImGui::SetNextWindowPos({right + ImGui::GetStyle().ItemSpacing.x, ImGui::GetItemRectMin().y});
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * tipWidth);
    text(choice.help);
    if (!choice.since.empty())
        dimText(originOf(choice));
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

} // namespace texplorer::ui
