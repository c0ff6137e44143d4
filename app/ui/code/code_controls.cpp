#include "app/ui/code/commands_tab.h"
#include "app/ui/language/translate.h"
#include "app/ui/model/findings.h"
#include "app/ui/widgets/hover_link.h"
#include "app/ui/widgets/param_parts.h"
#include "app/ui/widgets/param_place.h"
#include "app/ui/widgets/param_tips.h"
#include "app/ui/widgets/popups.h"
#include "app/ui/widgets/theme.h"

#include <fmt/core.h>
#include <imgui_internal.h> // whether a number is being typed

#include <algorithm>
#include <array>

namespace texplorer::ui {
namespace {

constexpr float digitsTyped = 9; ///< room for them, in letters

float codeWidth(const emit::Part& part) {
    return ImGui::CalcTextSize(part.text.c_str(), part.text.c_str() + part.text.size()).x;
}

ImU32 codeInk(const emit::Part& part, const CodeLook& look) {
    if (look.isChanged)
        return color::changed;
    if (look.isFaint)
        return color::dim;
    constexpr std::array inks{color::text,    color::text,    color::uniform, // in the order of Kind
                              color::keyword, color::keyword, color::dim};
    return inks.at(static_cast<std::size_t>(part.kind));
}

/// Underlines the last widget: it can be used.
void codeUnderline(ImU32 ink) {
    constexpr float resting = 0.45F;
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    ImVec4 tint = ImGui::ColorConvertU32ToFloat4(ink);
    if (!ImGui::IsItemHovered() && !ImGui::IsItemActive())
        tint.w *= resting;
    const float thick = std::max(1.0F, ImGui::GetFontSize() / 15);
    ImGui::GetWindowDrawList()->AddRectFilled({low.x, high.y - thick}, {high.x, high.y},
                                              ImGui::ColorConvertFloat4ToU32(tint));
}

/// The tooltip of a value.
void codeTip(const Session& session, const ParamPlace& place, const std::string& path, int component) {
    if (!ImGui::IsItemHovered() || ImGui::IsItemActive())
        return;
    ImGui::PushFont(nullptr); // words, not code
    if (place.vertex) {
        const bool isCoord = place.row->kind == Kind::TexCoordList;
        const std::string_view names = isCoord ? "strq" : place.row->kind == Kind::ColorList ? "rgba" : "xyz";
        const ProperName name{names.substr(std::min(static_cast<std::size_t>(component), names.size()), 1)};
        const Sentence label = std::string(place.row->label);
        const std::size_t shared = sharedFrom(place);
        helpTip(isCoord ? Sentence("Coordinate {0} of vertex {1}: drag it, or double-click to type", name,
                                   *place.vertex)
                : shared > 1 ? Sentence("{0}, vertices {1} to {2}, {3}: drag it, or double-click to type",
                                        label, *place.vertex, *place.vertex + shared - 1, name)
                             : Sentence("{0}, vertex {1}, {2}: drag it, or double-click to type", label,
                                        *place.vertex, name));
    } else {
        const Value value = place.row->read(place.owner.values);
        paramTip(*place.row, value, value, selectedUnit(session).target,
                 idleReasonOf(session.document.findings, path), problemOf(session.document.findings, path));
    }
    ImGui::PopFont();
}

/// A number in code that can be dragged, and typed after a double click.
float codeNumber(const Session& session, const emit::Part& part, ParamPlace place, const CodeLook& look) {
    const float width = codeWidth(part);
    const Range range = rangeOf(place);
    const std::string format = fmt::format("%.{}f", place.row->kind == Kind::Int ? 0 : decimalsOf(range));
    const bool isTyped = ImGui::TempInputIsActive(ImGui::GetID("##number"));
    const float sign = part.negated ? -1.0F : 1.0F;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float room = isTyped ? std::max(width, look.letter * digitsTyped) : width;
    float shown = sign * numberAt(place, part.component);
    constexpr ImU32 unseen = 0;
    ImGui::SetNextItemWidth(room);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0});
    if (!isTyped) // the text's own notation is drawn over it
        for (const ImGuiCol each :
             {ImGuiCol_Text, ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive})
            ImGui::PushStyleColor(each, unseen);
    const float low = part.negated ? -range.max : range.min;
    const float high = part.negated ? -range.min : range.max;
    const bool edited = dragFloat("##number", shown, range.step, low, high, format.c_str());
    ImGui::PopStyleVar();
    if (!isTyped) {
        ImGui::PopStyleColor(4);
        if (ImGui::IsItemHovered())
            ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
        const ImU32 ink = codeInk(part, look);
        ImGui::GetWindowDrawList()->AddText(at, ink, part.text.c_str());
        const bool isCoordinate = part.component >= 0 && place.row->kind != Kind::Color;
        codeUnderline(isCoordinate && part.component < 4 ? componentColor(part.component) : ink);
    }
    // Those that shared the value when the edit began: during a drag it may equal the next one's for a
    // moment.
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    if (ImGui::IsItemActivated())
        storage.SetInt(ImGui::GetItemID(), static_cast<int>(sharedFrom(place)));
    place.vertices = static_cast<std::size_t>(storage.GetInt(ImGui::GetItemID(), 1));
    if (edited && !(isTyped && ImGui::IsItemActive())) // a typed number is used when it is complete
        assignNumber(session, place, part.component, shown == 0 ? 0.0F : sign * shown);
    sealAfterItem(session);
    return room;
}

/// A popup of words, opened by code.
bool beginCodePopup(const char* name) {
    if (!beginPopup(name))
        return false;
    ImGui::PushFont(nullptr); // the default one
    const float em = ImGui::GetFontSize();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {em * 0.5F, std::max(em * 0.3F, targetHeight() - em)});
    return true;
}

void endCodePopup() {
    ImGui::PopStyleVar();
    ImGui::PopFont();
    endPopup();
}

/// The list of choices of the last widget.
void codeChoices(const Session& session, const ParamPlace& place, const std::string& path) {
    if (!beginCodePopup("choices"))
        return;
    const EnumValue now = std::get<EnumValue>(place.row->read(place.owner.values));
    float names = 0;
    for (const EnumRow& choice : place.row->choices)
        names = std::max(names, ImGui::CalcTextSize(tr(choice.label).c_str()).x);
    for (const EnumRow& choice : place.row->choices) {
        const bool isNow = choice.value == now.number;
        if (ImGui::Selectable(label(fmt::format("{}##{}", choice.label, choice.name)).c_str(), isNow))
            assignParam(session, place.owner, *place.row, EnumValue{choice.value});
        noteItem(fmt::format("command:{}={}", path, choice.name));
        choiceTip(choice);
        if (!choice.since.empty()) {
            ImGui::SameLine(names + ImGui::GetFontSize() * 2);
            ImGui::PushFont(codeFont());
            ImGui::TextDisabled("%s", choice.name.data());
            ImGui::PopFont();
        }
    }
    endCodePopup();
}

/// Clickable words.
bool codeButton(const emit::Part& part, const CodeLook& look) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton("##word", {codeWidth(part), ImGui::GetFontSize()});
    const ImU32 ink = codeInk(part, look);
    if (ImGui::IsItemHovered())
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    ImGui::GetWindowDrawList()->AddText(at, ink, part.text.c_str());
    if (part.kind == emit::Part::Kind::Choice || part.kind == emit::Part::Kind::Switch)
        codeUnderline(ink);
    return pressed;
}

/// Goes to the control of a call, opens the list of a choice or turns a switch.
void pressCode(const Session& session, const emit::Part& part, const ParamPlace* place) {
    if (part.kind != emit::Part::Kind::Choice && part.kind != emit::Part::Kind::Switch)
        return act(session, [path = part.path](Session& s) { reveal(s, path); });
    if (place && part.kind == emit::Part::Kind::Choice && place->row->kind == Kind::Enum)
        ImGui::OpenPopup("choices");
    if (place && part.kind == emit::Part::Kind::Switch && place->row->kind == Kind::Bool)
        assignParam(session, place->owner, *place->row,
                    !std::get<bool>(place->row->read(place->owner.values)));
}

} // namespace

float codePart(const Session& session, const emit::Part& part, const CodeLook& look) {
    using Kind = emit::Part::Kind;
    float width = codeWidth(part);
    if (part.path.empty() || part.kind == Kind::Plain || part.kind == Kind::Comment) {
        plainText(part.text, codeInk(part, look));
        linkHover(session, part.path);
        return width;
    }
    ImGui::PushID(
        fmt::format("{} {} {} {}", part.path, part.component, static_cast<int>(part.kind), part.occurrence)
            .c_str());
    const std::optional<ParamPlace> place = placeOf(presentScene(session), part.path);
    if (part.kind != Kind::Number) {
        if (codeButton(part, look))
            pressCode(session, part, place ? &*place : nullptr);
    } else if (place) {
        width = codeNumber(session, part, *place, look);
    }
    if (part.occurrence == 0)
        noteItem(part.kind == Kind::Call ? fmt::format("call:{}", part.path)
                 : part.component < 0    ? fmt::format("command:{}", part.path)
                                         : fmt::format("command:{}[{}]", part.path, part.component));
    linkHover(session, part.path);
    if (place)
        codeTip(session, *place, part.path, part.component);
    if (place && part.kind == Kind::Choice)
        codeChoices(session, *place, part.path);
    ImGui::PopID();
    return width;
}

float codeSwatch(const Session& session, const emit::Line& line, const CodeLook& look) {
    const auto number = std::ranges::find(line.parts, emit::Part::Kind::Number, &emit::Part::kind);
    if (number == line.parts.end())
        return 0;
    const std::optional<ParamPlace> place = placeOf(presentScene(session), number->path);
    if (!place || place->row->kind != Kind::Color)
        return 0;
    const float side = ImGui::GetFontSize();
    Value value = place->row->read(place->owner.values);
    glm::vec4& shown = std::get<glm::vec4>(value);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + look.letter);
    ImGui::PushID(number->path.c_str());
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, 0});
    ImGui::SetNextItemWidth(side);
    colorControl(shown);
    ImGui::PopStyleVar();
    noteItem(fmt::format("command:{}#color", number->path));
    linkHover(session, number->path);
    if (beginCodePopup("picker")) {
        if (colorPicker(session, shown, fmt::format("command:{}#picker", number->path)))
            assignParam(session, place->owner, *place->row, value);
        endCodePopup();
    }
    ImGui::PopID();
    return look.letter + side;
}

} // namespace texplorer::ui
