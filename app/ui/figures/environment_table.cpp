#include "app/ui/figures/environment_table.h"

#include "app/ui/figures/plot.h"
#include "app/ui/language/translate.h"
#include "app/ui/model/preview.h"
#include "app/ui/model/table_colors.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/param_names.h"
#include "app/ui/widgets/param_tips.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/points.h"
#include "app/ui/widgets/same_line.h"
#include "app/ui/widgets/segments.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/reference/shading/equation_text.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace texplorer::ui {
namespace {

using reference::TableColors;
using reference::tableFormats;
using reference::tableModes;

/// The colours for which the table is computed.
struct ColorRow {
    const char* symbol;
    const char* words;
    glm::vec4 TableColors::*member;
    std::optional<glm::vec4> EnvironmentTableState::*own;
};
constexpr std::array colorRows{
    ColorRow{N_("Cp"),
             N_("Cp, Ap: the incoming colour from lighting, glColor or the unit before. Textbooks write Cf."),
             &TableColors::fragment, &EnvironmentTableState::fragment},
    ColorRow{N_("Ct"),
             N_("Ct, At: the filtered texel with all components of its image. Cs and As are the part that a "
                "format keeps; Lt and It are its red."),
             &TableColors::texel, &EnvironmentTableState::texel},
    ColorRow{N_("Cc"), N_("Cc, Ac: GL_TEXTURE_ENV_COLOR of the unit. Only GL_BLEND reads it."),
             &TableColors::constant, &EnvironmentTableState::constant},
};

bool hasOwnColors(const EnvironmentTableState& state) {
    return std::ranges::any_of(colorRows, [&](const ColorRow& row) { return (state.*row.own).has_value(); });
}

TableColors colorsOf(const EnvironmentTableState& state, const TableSubject& subject) {
    TableColors colors = subject.colors;
    for (const ColorRow& row : colorRows) {
        if (state.*row.own)
            colors.*row.member = *(state.*row.own);
    }
    return colors;
}

void colorEditors(EnvironmentTableState& state, const TableColors& colors) {
    const float em = ImGui::GetFontSize();
    const float inner = ImGui::GetStyle().ItemInnerSpacing.x;
    const float editor = em * 11.5F;
    for (const ColorRow& row : colorRows) {
        if (&row != &colorRows.front())
            sameLineFor(ImGui::CalcTextSize(row.symbol).x + inner + editor, em * 0.8F);
        ImGui::AlignTextToFramePadding();
        plainText(row.symbol, state.*row.own ? color::changed : color::text);
        helpTip(row.words);
        ImGui::SameLine(0, inner);
        ImGui::SetNextItemWidth(editor);
        glm::vec4 value = colors.*row.member;
        ImGui::PushID(row.symbol);
        if (ImGui::ColorEdit4("##color", &value.x,
                              ImGuiColorEditFlags_Uint8 | ImGuiColorEditFlags_AlphaBar |
                                  ImGuiColorEditFlags_AlphaPreviewHalf | ImGuiColorEditFlags_NoOptions))
            state.*row.own = glm::clamp(value, 0.0F, 1.0F);
        ImGui::PopID();
        item(fmt::format("table color:{}", row.symbol), row.words);
    }
}

struct ChoiceWords {
    const char* words;
    const char* tip;
};

/// Buttons in a row. Returns the pressed one.
std::optional<std::size_t> buttons(const char* name, std::span<const ChoiceWords> choices,
                                   std::size_t chosen) {
    const float em = ImGui::GetFontSize();
    float room = 0;
    for (const ChoiceWords& choice : choices)
        room += ImGui::CalcTextSize(tr(choice.words)).x + em * 0.8F;
    sameLineFor(room, em * 0.8F);
    ImGui::PushID(name);
    const auto pressed = drawSegments(
        segmentsOf(choices, &ChoiceWords::words), std::min(room, ImGui::GetContentRegionAvail().x), chosen,
        [&](std::size_t i) { item(fmt::format("{}:{}", name, choices[i].words), choices[i].tip); });
    ImGui::PopID();
    return pressed;
}

void tools(EnvironmentTableState& state, const TableSubject& subject, const CellPlan& plan) {
    constexpr std::array texts{
        ChoiceWords{N_("In symbols"), N_("The equations of each cell: colour, and below it alpha.")},
        ChoiceWords{
            N_("In numbers"),
            N_("The result of each cell for the colours above: red, green, blue and alpha, 0 to 255.")},
        ChoiceWords{N_("Pictures"), N_("The result of each cell for a small picture.")}};
    constexpr std::array pictures{
        ChoiceWords{N_("Texture"), N_("The pictures show the bound texture.")},
        ChoiceWords{N_("Gradient"), N_("The pictures show every hue, and every alpha from bottom to top.")}};
    if (!plan.hasBoth()) {
        const std::span<const ChoiceWords> offered = std::span(texts).first(plan.apart ? 3 : 2);
        const CellText shown =
            plan.apart || state.shows != CellText::Pictures ? state.shows : CellText::Symbols;
        if (const auto pressed = buttons(N_("table text"), offered, static_cast<std::size_t>(shown)))
            state.shows = static_cast<CellText>(*pressed);
    }
    if (subject.texels) {
        if (const auto pressed = buttons(N_("table picture"), pictures, state.gradient ? 1 : 0))
            state.gradient = *pressed == 1;
    }
    if (hasOwnColors(state)) {
        const char* words = subject.probed ? N_("Back to the pixel") : N_("Back to the scene");
        sameLineFor(buttonWidth(words), ImGui::GetFontSize() * 0.8F);
        if (ImGui::Button(label(words)))
            state.fragment = state.texel = state.constant = std::nullopt;
        item("table:reset", "Resets the colours to those of the scene.");
    }
}

/// The source of the colours, and instructions.
void sentence(const EnvironmentTableState& state, const TableSubject& subject) {
    const char* words =
        hasOwnColors(state)
            ? N_("Point at a cell to preview it, click to apply it. The colours are your own.")
        : subject.probed
            ? N_("Point at a cell to preview it, click to apply it. The colours are those of the explained "
                 "pixel.")
            : N_("Point at a cell to preview it, click to apply it. Explain a pixel to use its colours.");
    if (sameLineFor(ImGui::GetFontSize() * 16, ImGui::GetFontSize() * 0.8F))
        ImGui::AlignTextToFramePadding();
    if (fittedText(words, color::dim))
        helpTip(words);
    noteItem("table:sentence");
}

struct CellPlace {
    std::size_t column;
    std::size_t row;
    [[nodiscard]] EnvMode mode() const { return tableModes.at(column); }
    [[nodiscard]] BaseFormat format() const { return tableFormats.at(row); }
};

std::string nameOf(const CellPlace& cell) {
    return fmt::format("{},{}", texplorer::rowOf(cell.mode()).name, texplorer::rowOf(cell.format()).name);
}

/// The name of the undo step and of the preview.
Sentence wordsOf(const CellPlace& cell) {
    return {N_("{0}: {1}, {2}"), N_("Environment"), texplorer::rowOf(cell.mode()).label,
            texplorer::rowOf(cell.format()).label};
}

void take(Scene& scene, const Selection& selection, const TableSubject& subject, const CellPlace& cell) {
    Unit& unit = selectedUnit(scene, selection);
    unit.envMode = cell.mode();
    const auto texture = static_cast<std::size_t>(unit.texture);
    // RGBA4 has the base format RGBA: it is not changed.
    if (subject.hasChoice && subject.format != cell.format() && texture < scene.textures.size())
        scene.textures[texture].internalFormat = internalFormat(cell.format());
}

Sentence sourceText(BaseFormat format) {
    const auto [source, alpha] = reference::sourceSymbols(format);
    return {N_("Cs = {0}, As = {1}"), ProperName{source}, ProperName{alpha}};
}

void cellTip(const Session& session, const CellPlace& cell, const TableColors& colors) {
    if (!ImGui::IsItemHovered())
        return;
    const Settings& settings = session.settings;
    const reference::EnvironmentEquations equations =
        reference::equationsOf(cell.mode(), cell.format(), reference::inputsOf(cell.format(), colors));
    const Sentence names(N_("{0}, {1}"), shownName(settings, texplorer::rowOf(cell.mode())),
                         shownName(settings, texplorer::rowOf(cell.format())));
    if (equations.undefined)
        return helpTip(
            Sentence("{0}\n{1}", names,
                     N_("The specification leaves this undefined. Here the incoming colour stays; a "
                        "driver may do anything else.")));
    const auto formula = [](const Sentence& text) {
        return Sentence(ProperName{reference::withHandSigns(tr(text))});
    };
    std::vector<Sentence> lines{names, sourceText(cell.format()), formula(equations.color.symbols)};
    constexpr std::array components{"red", "green", "blue"};
    for (std::size_t i = 0; i < components.size(); ++i)
        lines.push_back({N_("  {0}: {1}"), components.at(i), formula(equations.color.numbers.at(i))});
    lines.push_back(
        {N_("{0}: {1}"), formula(equations.alpha.symbols), formula(equations.alpha.numbers.at(0))});
    helpTip(Sentence::joined("{0}\n{1}", lines));
}

void drawCell(const Session& session, const TableSubject& subject, const TableColors& colors,
              const CellPlace& cell, const CellPlan& plan, const CellPictures& pictures) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high = low + plan.size;
    const bool pressed = ImGui::InvisibleButton(nameOf(cell).c_str(), plan.size);
    noteItem("cell:" + nameOf(cell));
    const bool hovered = ImGui::IsItemHovered();
    if (!ImGui::IsItemVisible())
        return;
    const bool own = selectedUnit(session).envMode == cell.mode() && subject.format == cell.format();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(low, high, ImGui::GetColorU32(hovered ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg));
    draw.AddRect(low, high, ImGui::GetColorU32(ImGuiCol_Border));
    ImGui::PushClipRect(low, high, true);
    drawEnvironmentCell(plan, low, cell.column, cell.row, colors, pictures);
    ImGui::PopClipRect();
    const float line = std::max(1.0F, std::floor(ImGui::GetFontSize() / 8));
    if (own || hovered)
        draw.AddRect(low, high, own ? color::accent : color::text, 0, 0, own ? 1.5F * line : line);
    if (own)
        noteItem("cell:own");
    cellTip(session, cell, colors);
    if (own)
        return;
    const auto apply = [&](Scene& scene) { take(scene, session.look.selection, subject, cell); };
    if (hovered)
        preview(session, "cell:" + nameOf(cell), wordsOf(cell), apply);
    if (!pressed)
        return;
    submit(session, wordsOf(cell), apply, selectedUnitPath(session) + "." + keyOf<&Unit::envMode>());
}

/// The name of the format, and the texel in that format.
void drawRowHead(const Session& session, const TableColors& colors, BaseFormat format, ImVec2 low,
                 ImVec2 size) {
    const float em = ImGui::GetFontSize();
    const EnumRow& row = texplorer::rowOf(format);
    const float large = std::floor(std::min(em, size.y * 0.53F));
    const float small = std::floor(std::min(em * 0.8F, size.y * 0.44F));
    const float gap = em * 0.4F;
    const float patch = std::round(small * 1.5F);
    const float top = std::round(low.y + std::max(0.0F, (size.y - large - small) / 2));
    shrunkText({low.x, top}, tr(shownName(session.settings, row)), large, size.x - gap, color::text);
    const ImVec2 at(low.x, top + large);
    colorPatch({at.x, at.y + 1}, {at.x + patch, at.y + small}, reference::inputsOf(format, colors).source);
    shrunkText({at.x + patch + gap, at.y}, tr(sourceText(format)), small, size.x - patch - 2 * gap,
               color::dim);
    ImGui::Dummy(size);
    choiceTip(row);
}

float columnHeadHeight() {
    return std::ceil(ImGui::GetFontSize() * 1.12F);
}

/// The width of the formats' names.
float headWidth(const Session& session) {
    const float em = ImGui::GetFontSize();
    float width = em * 1.6F + ImGui::CalcTextSize(N_("Cs = Lt, As = At")).x * 0.8F;
    for (const BaseFormat format : tableFormats)
        width = std::max(
            width, ImGui::CalcTextSize(tr(shownName(session.settings, texplorer::rowOf(format))).c_str()).x);
    return std::min(std::ceil(width + em * 0.4F), std::floor(ImGui::GetContentRegionAvail().x / 4));
}

/// The names of the modes; the scene's own has the accent's colour.
void drawColumnHeads(const Session& session, float head, ImVec2 cell, float gap) {
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const EnvMode own = selectedUnit(session).envMode;
    for (std::size_t column = 0; column < tableModes.size(); ++column) {
        const EnumRow& row = texplorer::rowOf(tableModes.at(column));
        const float left = origin.x + head + static_cast<float>(column) * (cell.x + gap);
        ImGui::SetCursorScreenPos({left, origin.y});
        ImGui::Dummy({cell.x, columnHeadHeight()});
        choiceTip(row);
        shrunkText({left, origin.y}, tr(shownName(session.settings, row)), ImGui::GetFontSize(), cell.x,
                   tableModes.at(column) == own ? color::accent : color::text);
    }
    ImGui::SetCursorScreenPos({origin.x, origin.y + columnHeadHeight()});
}

/// `height` is the room below the lines above the cells.
ImVec2 cellSize(float head, float height, float gap, CellText wanted) {
    const float width = ImGui::GetContentRegionAvail().x - head;
    const auto columns = static_cast<float>(tableModes.size());
    const auto rows = static_cast<float>(tableFormats.size());
    const float all = height - columnHeadHeight();
    const float wide = std::max(1.0F, std::floor((width + gap) / columns) - gap);
    return {wide, std::max(minCellHeight(wide, wanted), std::floor((all + gap) / rows) - gap)};
}

} // namespace

void drawEnvironmentTable(const Session& session, EnvironmentTableState& state, const Pictures& pictures) {
    const float em = ImGui::GetFontSize();
    const float gap = std::max(1.0F, std::floor(em / 8));
    const TableSubject subject = tableSubject(session);
    const TableColors colors = colorsOf(state, subject);
    const EnvironmentPictures::Question question{state.gradient ? nullptr : subject.texels, colors.fragment,
                                                 colors.constant};
    ask(session, [question](Session& changed) { return workers(changed).environments->ask(question); });
    const auto atlas = workers(session).environments->newest();
    CellPictures shown{pictures.show(atlas)};
    if (atlas) {
        shown.width = static_cast<float>(atlas->width) / static_cast<float>(tableModes.size());
        shown.height = static_cast<float>(atlas->height) / static_cast<float>(tableFormats.size());
    }
    const float head = headWidth(session);
    // The switch is shown if the cells are small; they are planned before it is drawn.
    const float above = ImGui::GetFrameHeightWithSpacing() + ImGui::GetTextLineHeightWithSpacing();
    const CellPlan first =
        planCells(cellSize(head, ImGui::GetContentRegionAvail().y - above, gap, state.shows), state.shows);
    // With little space, so that all rows are visible.
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, gap});
    colorEditors(state, colors);
    tools(state, subject, first);
    sentence(state, subject);
    ImGui::PopStyleVar();
    const ImVec2 cell = cellSize(head, ImGui::GetContentRegionAvail().y, gap, state.shows);
    const CellPlan plan = planCells(cell, state.shows);
    drawColumnHeads(session, head, cell, gap);
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    for (std::size_t row = 0; row < tableFormats.size(); ++row) {
        const float top = origin.y + static_cast<float>(row) * (cell.y + gap);
        ImGui::SetCursorScreenPos({origin.x, top});
        drawRowHead(session, colors, tableFormats.at(row), {origin.x, top}, {head, cell.y});
        for (std::size_t column = 0; column < tableModes.size(); ++column) {
            ImGui::SetCursorScreenPos({origin.x + head + static_cast<float>(column) * (cell.x + gap), top});
            drawCell(session, subject, colors, {column, row}, plan, shown);
        }
    }
}

} // namespace texplorer::ui
