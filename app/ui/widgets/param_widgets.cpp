#include "app/ui/widgets/param_widgets.h"

#include "app/ui/model/findings.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/param_tips.h"
#include "app/ui/widgets/problem_sign.h"
#include "app/ui/widgets/text_field.h"
#include "app/ui/widgets/theme.h"
#include "core/scene/params/param_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace texplorer::ui {
namespace {

constexpr float labelShare = 0.44F; ///< of a line's width
constexpr float narrowest = 7.5F;   ///< of a control beside its label, in letters' heights

/// Wide controls get a line of their own below the label.
bool isWide(Kind kind) {
    return kind == Kind::Vec3 || kind == Kind::Vec4 || kind == Kind::Matrix;
}

float textWidth(std::string_view words) {
    return ImGui::CalcTextSize(words.data(), words.data() + words.size()).x;
}

bool enumWidget(const Owner& owner, const ParamRow& row, EnumValue& value, const std::string& path) {
    const auto labelOf = [&](const EnumRow& choice) {
        return owner.labelOf ? owner.labelOf(row, choice) : std::string(choice.label);
    };
    const EnumRow* current = findRow(row.choices, value.number);
    const float room =
        ImGui::CalcItemWidth() - ImGui::GetFrameHeight() - 2 * ImGui::GetStyle().FramePadding.x;
    const std::string preview = fitted(current ? labelOf(*current) : "?", room);
    bool changed = false;
    if (ImGui::BeginCombo("##value", preview.c_str(), ImGuiComboFlags_HeightLargest)) {
        ImGui::PushStyleColor(ImGuiCol_Text, color::text); // the list of a dim row isn't dim
        float names = 0;
        for (const EnumRow& choice : row.choices)
            names = std::max(names, textWidth(labelOf(choice)));
        std::string_view group;
        for (const EnumRow& choice : row.choices) {
            if (choice.group != group)
                caption(choice.group);
            group = choice.group;
            const std::string label = fmt::format("{}##{}", labelOf(choice), choice.name);
            const bool isCurrent = choice.value == value.number;
            if (ImGui::Selectable(label.c_str(), isCurrent)) {
                changed = !isCurrent;
                value.number = choice.value;
            }
            noteItem(fmt::format("{}={}", path, choice.name));
            choiceTip(choice);
            if (isCurrent)
                ImGui::SetItemDefaultFocus();
            if (choice.name.starts_with("GL_")) {
                ImGui::SameLine(names + ImGui::GetFontSize() * 2);
                ImGui::PushFont(codeFont());
                dimText(choice.name);
                ImGui::PopFont();
            }
        }
        ImGui::PopStyleColor();
        ImGui::EndCombo();
    }
    return changed;
}

bool colorWidget(glm::vec4& value) {
    constexpr ImGuiColorEditFlags look =
        ImGuiColorEditFlags_AlphaBar | ImGuiColorEditFlags_AlphaPreviewHalf | ImGuiColorEditFlags_Float;
    const ImVec4 shown(value.x, value.y, value.z, value.w);
    const ImVec2 size(ImGui::CalcItemWidth(), ImGui::GetFrameHeight());
    if (ImGui::ColorButton("##value", shown, look | ImGuiColorEditFlags_NoTooltip, size))
        ImGui::OpenPopup("picker");
    return false;
}

/// The popup of colorWidget; apart from it, so that the swatch stays the "last item" of the line.
bool colorPopup(Session& session, glm::vec4& value, const std::string& path) {
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

std::string numberFormat(const Range& range) {
    const int decimals = range.step >= 0.5F ? 1 : range.step >= 0.01F ? 2 : 3;
    std::string format = fmt::format("%.{}f", decimals);
    if (range.unit == "deg")
        return format + "°";
    if (range.unit == "deg/s")
        return format + "°/s";
    if (range.unit.empty())
        return format;
    return format + (range.unit.starts_with('/') ? "" : " ") + std::string(range.unit);
}

/// The last widget is a number that one drags: arrows at both ends say so where there is room, and so does
/// the mouse.
void markDraggable() {
    const bool hot = ImGui::IsItemHovered() || ImGui::IsItemActive();
    if (ImGui::IsItemHovered())
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const float em = ImGui::GetFontSize();
    if (ImGui::GetIO().WantTextInput || high.x - low.x < em * 6)
        return;
    const ImU32 tint = hot ? color::text : IM_COL32(142, 150, 162, 110);
    const float y = (low.y + high.y) / 2;
    const float size = em * 0.2F;
    const float left = low.x + em * 0.7F;
    const float right = high.x - em * 0.7F;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddTriangleFilled({left - size, y}, {left, y - size}, {left, y + size}, tint);
    draw.AddTriangleFilled({right + size, y}, {right, y + size}, {right, y - size}, tint);
}

template<class Vector>
bool vectorWidget(Session& session, const ParamRow& row, Vector& value, const std::string& path) {
    constexpr int count = Vector::length();
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = std::floor((ImGui::CalcItemWidth() - gap * (count - 1)) / count);
    bool changed = false;
    for (int i = 0; i < count; ++i) {
        if (i > 0)
            ImGui::SameLine(0, gap);
        ImGui::PushID(i);
        ImGui::SetNextItemWidth(width);
        changed |= dragNumber("##component", value[i], row.range, i);
        noteItem(fmt::format("{}[{}]", path, i));
        sealAfterItem(session);
        ImGui::PopID();
    }
    return changed;
}

/// Row by row as one writes a matrix down, though OpenGL keeps it column by column.
bool matrixWidget(Session& session, const ParamRow& row, glm::mat4& value, const std::string& path) {
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
        changed |= dragNumber("##element", value[i % 4][i / 4], row.range, i / 4);
        noteItem(fmt::format("{}[{}]", path, element));
        sealAfterItem(session);
        ImGui::PopID();
    }
    ImGui::EndGroup();
    return changed;
}

/// Draws the control; true where `value` changed.
bool control(Session& session, const Owner& owner, const ParamRow& row, Value& value,
             const std::string& path) {
    switch (row.kind) {
    case Kind::Bool:
        return ImGui::Checkbox("##value", &std::get<bool>(value));
    case Kind::Int: {
        int& number = std::get<int>(value);
        const bool changed =
            ImGui::DragInt("##value", &number, row.range.step, static_cast<int>(row.range.min),
                           static_cast<int>(row.range.max), "%d", ImGuiSliderFlags_AlwaysClamp);
        markDraggable();
        return changed;
    }
    case Kind::Float:
        return dragNumber("##value", std::get<float>(value), row.range, -1);
    case Kind::Vec3:
        return vectorWidget(session, row, std::get<glm::vec3>(value), path);
    case Kind::Vec4:
        return vectorWidget(session, row, std::get<glm::vec4>(value), path);
    case Kind::Color:
        return colorWidget(std::get<glm::vec4>(value));
    case Kind::Enum:
        return enumWidget(owner, row, std::get<EnumValue>(value), path);
    case Kind::Text:
        return textField("##value", std::get<std::string>(value), ImGuiInputTextFlags_EnterReturnsTrue);
    case Kind::Matrix:
        return matrixWidget(session, row, std::get<glm::mat4>(value), path);
    case Kind::PointList:
    case Kind::ColorList:
    case Kind::TexCoordList:
    case Kind::IndexList:
        return false; // the vertex list, the texture space and the pass section edit these
    }
    return false;
}

bool isContinuous(Kind kind) {
    return kind == Kind::Int || kind == Kind::Float || kind == Kind::Vec3 || kind == Kind::Vec4 ||
           kind == Kind::Color || kind == Kind::Matrix;
}

bool assign(Session& session, const Owner& owner, const ParamRow& row, const Value& value,
            const std::string& path) {
    if (value == row.read(owner.values))
        return false;
    if (const Result<void> fits = checkValue(row, value); !fits) {
        session.window.notice = {fmt::format("{}: {}", row.label, fits.error().message), {}};
        return false;
    }
    if (owner.accepts && !owner.accepts(row, value))
        return false;
    row.write(owner.values, value);
    recordEdit(session, row.label, path);
    if (!isContinuous(row.kind))
        sealEdit(session);
    return true;
}

} // namespace

void sealAfterItem(Session& session) {
    if (ImGui::IsItemDeactivated())
        sealEdit(session);
}

bool squareButton(const char* label, std::string_view name, std::string_view help, bool enabled) {
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button(label, {ImGui::GetFrameHeight(), 0});
    noteItem(name);
    ImGui::EndDisabled();
    helpTip(help);
    return pressed && enabled;
}

void caption(std::string_view words) {
    ImGui::Dummy({0, ImGui::GetFontSize() * 0.15F});
    dimText(words);
}

bool dragNumber(const char* id, float& value, const Range& range, int component) {
    const std::string format =
        component >= 0 ? numberFormat({range.min, range.max, range.step, {}}) : numberFormat(range);
    const bool changed = ImGui::DragFloat(id, &value, range.step, range.min, range.max, format.c_str(),
                                          ImGuiSliderFlags_AlwaysClamp);
    markDraggable();
    if (component >= 0) {
        const ImVec2 low = ImGui::GetItemRectMin();
        ImGui::GetWindowDrawList()->AddRectFilled(
            low, {low.x + ImGui::GetFontSize() * 0.2F, ImGui::GetItemRectMax().y}, componentColor(component),
            ImGui::GetStyle().FrameRounding, ImDrawFlags_RoundCornersLeft);
    }
    return changed;
}

namespace {

/// A row's value while its control is drawn.
struct Line {
    std::string path;
    Value value;
    Value initial;
    bool changed;           ///< it isn't the initial value
    const Finding* idle;    ///< why it changes nothing at present; nullptr: it matters
    const Finding* problem; ///< what is wrong with it
    bool edited = false;
    bool reset = false;
};

Line lineOf(const Session& session, const Owner& owner, const ParamRow& row) {
    const std::string path = owner.pathOf(row);
    const Value value = row.read(owner.values);
    const Value initial = row.read(owner.initial);
    return {path,
            value,
            initial,
            value != initial,
            idleReasonOf(session.document.findings, path),
            problemOf(session.document.findings, path)};
}

/// Scrolls to a control that was asked for, and frames it.
void showWanted(Session& session, const Line& line) {
    if (line.path == session.window.wantedParam) {
        ImGui::SetScrollHereY(0.4F);
        session.window.wantedParam.clear();
    }
    if (line.path != session.window.shownParam)
        return;
    const float margin = ImGui::GetFontSize() * 0.15F;
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddRect({low.x - margin, low.y - margin}, {high.x + margin, high.y + margin},
                                        color::problem, ImGui::GetStyle().FrameRounding);
}

void drawControl(Session& session, const Owner& owner, const ParamRow& row, Line& line, float width,
                 ImU32 ink) {
    constexpr float dimShare = 0.35F; // of a swatch, which has no text to be dim
    ImGui::SetNextItemWidth(width);
    ImGui::PushStyleColor(ImGuiCol_Text, line.idle ? color::dim : ink);
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, line.idle && row.kind == Kind::Color ? dimShare : 1.0F);
    line.edited = control(session, owner, row, line.value, line.path);
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    if (!isWide(row.kind)) {
        noteItem(line.path);
        sealAfterItem(session);
    }
    if (line.idle)
        noteItem(line.path + "#inert");
    paramTip(row, line.value, line.initial, selectedUnit(session).target, line.idle, line.problem);
    line.reset |= line.changed && ImGui::IsItemClicked(ImGuiMouseButton_Right);
    showWanted(session, line);
    if (row.kind == Kind::Color)
        line.edited |= colorPopup(session, std::get<glm::vec4>(line.value), line.path);
}

/// Writes what the user did to a line. True where the value changed.
bool finish(Session& session, const Owner& owner, const ParamRow& row, const Line& line) {
    if (!line.reset)
        return line.edited && assign(session, owner, row, line.value, line.path);
    sealEdit(session);
    const bool changed = assign(session, owner, row, line.initial, line.path);
    sealEdit(session);
    return changed;
}

} // namespace

bool paramControl(Session& session, const Owner& owner, const ParamRow& row, float width) {
    Line line = lineOf(session, owner, row);
    ImGui::PushID(line.path.c_str());
    drawControl(session, owner, row, line, width,
                line.problem && line.problem->severity <= Severity::Warning ? color::problem
                : line.changed                                              ? color::changed
                                                                            : color::text);
    if (line.problem)
        noteItem(line.path + "#problem");
    ImGui::PopID();
    return finish(session, owner, row, line);
}

bool paramWidget(Session& session, const Owner& owner, const ParamRow& row) {
    if (isList(row.kind))
        return false;
    Line line = lineOf(session, owner, row);

    ImGui::PushID(line.path.c_str());
    const float em = ImGui::GetFontSize();
    // Controls stand below each other, beside lines that are indented, too.
    const float indent = ImGui::GetCursorPosX() - ImGui::GetWindowContentRegionMin().x;
    const float full = ImGui::GetContentRegionAvail().x;
    const float resetWidth = em * 1.3F;
    // A label that is a little wider than its column takes some of the control's.
    const float needed = textWidth(row.label) + (line.problem ? em * 1.2F : 0) + em * 0.4F;
    const float labelWidth = std::floor(std::max((indent + full) * labelShare - indent, needed));
    const float least = row.kind == Kind::Bool ? ImGui::GetFrameHeight() : em * narrowest;
    const bool isNarrow = full - labelWidth - resetWidth < least;
    const bool ownLine = isWide(row.kind) || isNarrow;

    ImGui::BeginGroup();
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, line.idle      ? color::dim
                                         : line.changed ? color::changed
                                                        : color::text);
    text(row.label);
    ImGui::PopStyleColor();
    paramTip(row, line.value, line.initial, selectedUnit(session).target, line.idle, line.problem);
    line.reset = line.changed && ImGui::IsItemClicked(ImGuiMouseButton_Right);
    if (line.problem) {
        ImGui::SameLine(0, em * 0.35F);
        problemSign(session, line.path, *line.problem);
    }
    float controlWidth = full - resetWidth;
    if (!ownLine) {
        ImGui::SameLine(labelWidth); // from where the group begins
        controlWidth -= labelWidth;
    }
    drawControl(session, owner, row, line, controlWidth, color::text);
    if (line.changed) {
        ImGui::SameLine(full - em);
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, ImGui::GetStyle().FramePadding.y});
        ImGui::PushStyleColor(ImGuiCol_Button, 0);
        ImGui::PushStyleColor(ImGuiCol_Text, color::changed);
        line.reset |= ImGui::Button("↺", {em, 0});
        noteItem(line.path + "#reset");
        ImGui::PopStyleColor(2);
        ImGui::PopStyleVar();
        helpTip("Back to " + formatValue(row, line.initial));
    }
    ImGui::EndGroup();
    ImGui::PopID();
    return finish(session, owner, row, line);
}

bool isRelevant(const Session& session, const Owner& owner, const ParamRow& row) {
    return !isList(row.kind) && !isUnused(session, owner.pathOf(row));
}

void paramRows(Session& session, const Owner& owner, const StructTable& table) {
    std::string_view group;
    bool groupsDiffer = false;
    for (const ParamRow& row : table.params)
        groupsDiffer |= row.group != table.params.front().group;
    for (const ParamRow& row : table.params) {
        if (!isRelevant(session, owner, row))
            continue;
        if (groupsDiffer && row.group != group)
            caption(row.group);
        group = row.group;
        paramWidget(session, owner, row);
    }
}

} // namespace texplorer::ui
