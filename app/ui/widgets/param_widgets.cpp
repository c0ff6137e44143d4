#include "app/ui/widgets/param_widgets.h"

#include "app/ui/language/translate.h"
#include "app/ui/model/findings.h"
#include "app/ui/model/notice.h"
#include "app/ui/model/timeline_edits.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/hover_link.h"
#include "app/ui/widgets/param_names.h"
#include "app/ui/widgets/param_tips.h"
#include "app/ui/widgets/text_field.h"
#include "texplorer/scene/params/key_edits.h"
#include "texplorer/scene/params/param_text.h"

#include <fmt/core.h>
#include <imgui_internal.h> // the indentation of lines, also in a table

#include <algorithm>
#include <cmath>
#include <utility>

namespace texplorer::ui {
namespace {

constexpr float labelShare = 0.44F;       ///< of a line's width
constexpr float minControlWidth = 7.5F;   ///< of a control next to its label, in letters' heights
constexpr float resetRoom = 1.3F;         ///< of ↺ and the gap before it, in letters' heights
constexpr float wideColumn = 37.3F;       ///< room for two columns of lines, in letters' heights: 560 pixels
constexpr std::size_t maxButtonLines = 3; ///< of the buttons of a choice

/// Wide controls get their own line below the label.
bool isWide(Kind kind) {
    return kind == Kind::Vec3 || kind == Kind::Vec4 || kind == Kind::Matrix;
}

/// The value of a row while its control is drawn.
struct Line {
    std::string path;
    Value value;
    Value initial;
    bool changed;           ///< differs from the initial value
    const Finding* idle;    ///< why it has no effect at present; nullptr: it has
    const Finding* problem; ///< its problem; nullptr: none
    bool edited = false;
    bool reset = false;
    bool hasSign = true;               ///< shows ↺ if it differs from the initial value
    std::optional<SegmentPlan> plan{}; ///< of a choice that shows all its names
    std::optional<ImU32> chosenInk{};  ///< of the selected name
    std::optional<float> slidesTo{};   ///< the end of the slider, for a number with a slider
};

/// The meaning of the initial value, if its number says nothing.
const char* insteadOfNumber(const ParamRow& row, const Line& line) {
    return row.range.initially.empty() || line.changed ? nullptr : row.range.initially.data();
}

bool intWidget(const ParamRow& row, int& value, const char* instead) {
    const bool typing = ImGui::TempInputIsActive(ImGui::GetID("##value")); // reads the number by the format
    const bool changed = dragInt("##value", value, row.range.step, static_cast<int>(row.range.min),
                                 static_cast<int>(row.range.max), instead && !typing ? tr(instead) : "%d");
    markDraggable();
    return changed;
}

/// Draws the control; returns true if the line's value changed.
bool control(const Session& session, const Owner& owner, const ParamRow& row, Line& line) {
    Value& value = line.value;
    switch (row.kind) {
    case Kind::Bool:
        return ImGui::Checkbox("##value", &std::get<bool>(value));
    case Kind::Int:
        return intWidget(row, std::get<int>(value), insteadOfNumber(row, line));
    case Kind::Float:
        return line.slidesTo
                   ? slideNumber("##value", std::get<float>(value), row.range, *line.slidesTo)
                   : dragNumber("##value", std::get<float>(value), row.range, -1, insteadOfNumber(row, line));
    case Kind::Vec3:
        return vectorControl(session, row, {&std::get<glm::vec3>(value).x, 3}, line.path);
    case Kind::Vec4:
        return vectorControl(session, row, {&std::get<glm::vec4>(value).x, 4}, line.path);
    case Kind::Color:
        return colorControl(std::get<glm::vec4>(value));
    case Kind::Enum:
        return enumControl(session, owner, row, std::get<EnumValue>(value), line.path, line.plan,
                           line.chosenInk);
    case Kind::Text:
        return textField("##value", std::get<std::string>(value), ImGuiInputTextFlags_EnterReturnsTrue);
    case Kind::Matrix:
        return matrixControl(session, row, std::get<glm::mat4>(value), line.path);
    case Kind::PointList:
    case Kind::ColorList:
    case Kind::TexCoordList:
    case Kind::IndexList:
        return false; // edited in the vertex list, the texture space and the pass section
    }
    return false;
}

bool isContinuous(Kind kind) {
    return kind == Kind::Int || kind == Kind::Float || kind == Kind::Vec3 || kind == Kind::Vec4 ||
           kind == Kind::Color || kind == Kind::Matrix;
}

/// The name in the history: several choices in a row would otherwise all be "Wrap s".
Sentence wordsOfEdit(const ParamRow& row, const Value& value) {
    const EnumRow* choice =
        row.kind == Kind::Enum ? findRow(row.choices, std::get<EnumValue>(value).number) : nullptr;
    return choice ? Sentence("{0}: {1}", row.label, choice->label) : Sentence(row.label);
}

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

/// Scrolls to a requested control and frames it.
void showWanted(const Session& session, const Line& line) {
    if (line.path == session.out.wantedParam) {
        ImGui::SetScrollHereY(0.4F);
        session.out.wantedParam.clear();
    }
    if (line.path != session.look.shownParam)
        return;
    frameItem(ImGui::GetFontSize() * 0.15F, color::problem, ImGui::GetStyle().FrameRounding);
}

void drawControl(const Session& session, const Owner& owner, const ParamRow& row, Line& line, float width,
                 ImU32 ink) {
    constexpr float dimShare = 0.35F; // of a swatch, which has no text to dim
    ImGui::SetNextItemWidth(width);
    ImGui::PushStyleColor(ImGuiCol_Text, line.idle ? color::dim : ink);
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, line.idle && row.kind == Kind::Color ? dimShare : 1.0F);
    line.edited = control(session, owner, row, line);
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    if (!isWide(row.kind)) {
        noteItem(line.path);
        sealAfterItem(session);
    }
    if (line.idle)
        noteItem(line.path + "#inert");
    paramTip(row, line.value, line.initial, selectedUnit(session).target, line.idle, line.problem,
             line.hasSign);
    linkHover(session, line.path);
    opensParamMenu();
    showWanted(session, line);
    if (row.kind == Kind::Color && ImGui::BeginPopup("picker")) {
        line.edited |= colorPicker(session, std::get<glm::vec4>(line.value), line.path + "#picker");
        ImGui::EndPopup();
    }
}

/// Submits the user's change of a line.
void finish(const Session& session, const Owner& owner, const ParamRow& row, const Line& line) {
    if (line.edited && !line.reset)
        assignParam(session, owner, row, line.value);
    if (!line.reset)
        return;
    sealEdit(session);
    assignParam(session, owner, row, line.initial);
    sealEdit(session);
}

/// The sign ↺ of a changed line, which resets it.
void resetSign(const ParamRow& row, Line& line) {
    const float em = ImGui::GetFontSize();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, ImGui::GetStyle().FramePadding.y});
    ImGui::PushStyleColor(ImGuiCol_Button, 0);
    ImGui::PushStyleColor(ImGuiCol_Text, color::changed);
    line.reset |= ImGui::Button("↺", {em, 0});
    noteItem(line.path + "#reset");
    ImGui::PopStyleColor(2);
    ImGui::PopStyleVar();
    helpTip(resetWords(row, line.initial));
}

/// `sign`: the room for ↺ next to it; 0: the colour shows the change, for buttons that of the chosen one.
void controlAlone(const Session& session, const Owner& owner, const ParamRow& row, Line line, float width,
                  float sign = 0) {
    ImGui::PushID(line.path.c_str());
    line.hasSign = sign > 0;
    ImU32 ink = line.problem && line.problem->severity <= Severity::Warning ? color::problem
                : line.changed && !line.hasSign                             ? color::changed
                                                                            : color::text;
    if (line.plan && !line.idle)
        line.chosenInk = std::exchange(ink, color::text);
    drawControl(session, owner, row, line, width - sign, ink);
    if (line.problem)
        noteItem(line.path + "#problem");
    if (line.hasSign) {
        const float em = ImGui::GetFontSize();
        ImGui::SameLine(0, sign - em);
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {segmentGap(), segmentGap()}); // as after the buttons
        line.changed ? resetSign(row, line) : ImGui::Dummy({em, 0});
        ImGui::PopStyleVar();
    }
    line.reset |= paramMenu(session, row, line.path, line.initial, line.changed);
    ImGui::PopID();
    finish(session, owner, row, line);
}

/// One below the other, or in two columns if there is room.
void drawRows(const Session& session, const Owner& owner, const std::vector<const ParamRow*>& rows) {
    const bool two = ImGui::GetContentRegionAvail().x >= wideColumn * ImGui::GetFontSize() && rows.size() > 1;
    if (!two) {
        for (const ParamRow* row : rows)
            paramWidget(session, owner, *row);
        return;
    }
    const std::string id = fmt::format("{}##{}", owner.path, rows.front()->key);
    if (!ImGui::BeginTable(id.c_str(), 2,
                           ImGuiTableFlags_SizingStretchSame | ImGuiTableFlags_NoSavedSettings))
        return;
    for (const ParamRow* row : rows) {
        ImGui::TableNextColumn();
        paramWidget(session, owner, *row);
    }
    ImGui::EndTable();
}

/// Rows without effect are folded: still available, but out of the way.
void drawFolded(const Session& session, const Owner& owner, const std::vector<const ParamRow*>& rows) {
    if (rows.empty())
        return;
    const auto isAskedFor = [&](const ParamRow* row) {
        return owner.pathOf(*row) == session.out.wantedParam;
    };
    if (std::ranges::any_of(rows, isAskedFor))
        ImGui::SetNextItemOpen(true);
    ImGui::PushID(owner.path.c_str());
    ImGui::PushStyleColor(ImGuiCol_Text, color::dim);
    const bool open = ImGui::TreeNodeEx(
        "folded", nodeHeight() | ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen,
        "%s", tr(Sentence("No effect here ({0})", rows.size())).c_str());
    ImGui::PopStyleColor();
    item(owner.path + "#no effect", "Settings that the present choices don't use");
    ImGui::PopID();
    if (open)
        drawRows(session, owner, rows);
}

} // namespace

void assignParam(const Session& session, const Owner& owner, const ParamRow& row, const Value& value) {
    if (value == row.read(owner.values))
        return;
    if (const Result<void> fits = checkValue(row, value); !fits) {
        return act(session, [text = Sentence("{0}: {1}", row.label, fits.error().message)](Session& told) {
            say(told, text);
        });
    }
    if (owner.accepts && !owner.accepts(row, value))
        return;
    const std::string path = owner.pathOf(row);
    submit(session, {.name = wordsOfEdit(row, value),
                     .edits = {edit::Set{path, formatValue(row, value)}},
                     .path = path,
                     .continues = isContinuous(row.kind)});
}

bool squareButton(const char* sign, std::string_view name, const Sentence& help, bool enabled) {
    return button(sign, name, help, enabled, ImGui::GetFrameHeight());
}

void paramControl(const Session& session, const Owner& owner, const ParamRow& row, float width,
                  std::size_t lines) {
    Line line = lineOf(session, owner, row);
    const float sign = ImGui::GetFontSize() * resetRoom;
    line.plan = planChoices(session, owner, row, width, lines);
    auto narrower = line.plan ? planChoices(session, owner, row, width - sign, lines) : std::nullopt;
    if (!narrower || narrower->lines.size() > line.plan->lines.size()) // the sign is not worth another line
        return controlAlone(session, owner, row, std::move(line), width);
    line.plan = std::move(narrower);
    controlAlone(session, owner, row, std::move(line), width, sign);
}

void paramSlider(const Session& session, const Owner& owner, const ParamRow& row, float width, float end) {
    Line line = lineOf(session, owner, row);
    line.slidesTo = end;
    controlAlone(session, owner, row, std::move(line), width);
}

void paramWidget(const Session& session, const Owner& owner, const ParamRow& row) {
    if (isList(row.kind))
        return;
    Line line = lineOf(session, owner, row);

    ImGui::PushID(line.path.c_str());
    const float em = ImGui::GetFontSize();
    // Controls are aligned one below the other, also in indented lines.
    const float indent = ImGui::GetCurrentWindowRead()->DC.Indent.x - ImGui::GetStyle().WindowPadding.x;
    const float full = ImGui::GetContentRegionAvail().x;
    const float resetWidth = em * resetRoom;
    const std::string_view name = shownName(session.settings, row);
    // A label that is slightly wider than its column takes some of the control's width.
    const float needed = textWidth(name) + (line.problem ? em * 1.2F : 0) +
                         (hasKeys(presentScene(session).timeline, line.path) ? em * 1.1F : 0) + em * 0.4F;
    const float labelWidth = std::floor(std::max((indent + full) * labelShare - indent, needed));
    const float minWidth = row.kind == Kind::Bool ? ImGui::GetFrameHeight() : em * minControlWidth;
    const float beside = full - labelWidth - resetWidth;
    line.plan = planChoices(session, owner, row, beside, 1);
    const bool isNarrow = beside < minWidth && !line.plan;
    const bool hasLines = !line.plan && (line.plan = planChoices(session, owner, row, full, maxButtonLines));
    const bool ownLine = isWide(row.kind) || isNarrow || hasLines;

    ImGui::BeginGroup();
    labelText(name, line.idle ? color::dim : line.changed ? color::changed : color::text);
    noteItem(line.path + "#label");
    linkHover(session, line.path);
    paramTip(row, line.value, line.initial, selectedUnit(session).target, line.idle, line.problem);
    opensParamMenu();
    if (isWide(row.kind) && !row.range.unit.empty()) { // its fields have room only for the numbers
        ImGui::SameLine(0, em * 0.35F);
        dimPlainText(unitText(row.range));
        noteItem(line.path + "#unit");
    }
    if (line.problem) {
        ImGui::SameLine(0, em * 0.35F);
        problemSign(session, line.path, *line.problem);
    }
    keySign(session, line.path);
    float controlWidth = hasLines ? full : full - resetWidth;
    const auto resetAtEnd = [&] {
        if (!line.changed)
            return;
        ImGui::SameLine(full - em);
        resetSign(row, line);
    };
    if (hasLines) {
        resetAtEnd();
    } else if (!ownLine) {
        ImGui::SameLine(labelWidth); // from the start of the group
        controlWidth -= labelWidth;
    }
    drawControl(session, owner, row, line, controlWidth, color::text);
    if (!hasLines)
        resetAtEnd();
    ImGui::EndGroup();
    line.reset |= paramMenu(session, row, line.path, line.initial, line.changed);
    ImGui::PopID();
    finish(session, owner, row, line);
}

bool isRelevant(const Session& session, const Owner& owner, const ParamRow& row) {
    return !isList(row.kind) && !isUnused(session, owner.pathOf(row));
}

void paramRows(const Session& session, const Owner& owner, const StructTable& table,
               const RowOptions& options) {
    const bool hasGroups = std::ranges::any_of(
        table.params, [&](const ParamRow& row) { return row.group != table.params.front().group; });
    std::vector<const ParamRow*> folded;
    std::vector<const ParamRow*> rows; // of one group
    const auto isOver = [&](std::string_view group) {
        if (!rows.empty()) {
            const bool saysSo = rows.front()->label == group; // a title would repeat it
            if (options.captions && hasGroups && !saysSo)
                caption(group);
            drawRows(session, owner, rows);
        }
        rows.clear();
        if (options.after)
            options.after(group);
    };
    for (std::size_t i = 0; i < table.params.size(); ++i) {
        const ParamRow& row = table.params[i];
        const bool isLeftOut = isList(row.kind) || (options.leavesOut && options.leavesOut(row));
        if (!isLeftOut) {
            const bool folds = !isRelevant(session, owner, row) || (options.folds && options.folds(row));
            (folds ? folded : rows).push_back(&row);
        }
        if (i + 1 == table.params.size() || table.params[i + 1].group != row.group)
            isOver(row.group);
    }
    drawFolded(session, owner, folded);
}

} // namespace texplorer::ui
