#include "app/ui/explain/step_rows.h"

#include "app/ui/figures/plot.h"
#include "app/ui/language/translate.h"
#include "app/ui/widgets/wrapped_text.h"

#include <imgui_internal.h> // the size of a window's text

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace texplorer::ui {
namespace {

using reference::Ink;
using reference::StepRow;

float cellPadding() {
    return std::floor(ImGui::GetFontSize() * 0.18F);
}

/// The size of a table of rows with the same number of cells.
float tableWidth(std::span<const StepRow> rows) {
    std::vector<float> columns(rows.front().cells.size() + 1);
    const auto widen = [](float& column, const Sentence& words, float more) {
        column = std::max(column, ImGui::CalcTextSize(tr(words).c_str()).x + more);
    };
    for (const StepRow& row : rows) {
        const float swatch =
            row.swatch ? ImGui::GetTextLineHeight() * 0.8F + ImGui::GetStyle().ItemInnerSpacing.x : 0;
        widen(columns[0], row.label, swatch);
        for (std::size_t i = 0; i < row.cells.size(); ++i)
            widen(columns[i + 1], row.cells[i].text, 0);
    }
    float width = 0;
    for (const float column : columns)
        width += std::ceil(column) + 2 * cellPadding();
    return width;
}

/// Rows with the same number of cells share a table.
std::vector<std::span<const StepRow>> tablesOf(std::span<const StepRow> rows) {
    std::vector<std::span<const StepRow>> tables;
    while (!rows.empty()) {
        const auto end = std::ranges::find_if(
            rows, [&](const StepRow& row) { return row.cells.size() != rows.front().cells.size(); });
        tables.push_back(rows.first(static_cast<std::size_t>(end - rows.begin())));
        rows = rows.subspan(tables.back().size());
    }
    return tables;
}

void drawLabel(const StepRow& row) {
    swatch(row.swatch);
    text(row.label, row.ink == Ink::Plain ? color::dim : tintOf(row.ink));
}

void drawTable(std::span<const StepRow> rows, float width) {
    const int columns = static_cast<int>(rows.front().cells.size()) + 1;
    if (!ImGui::BeginTable("rows", columns, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoSavedSettings,
                           {width, 0}))
        return;
    for (const StepRow& row : rows) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        drawLabel(row);
        for (const reference::StepCell& cell : row.cells) {
            ImGui::TableNextColumn();
            text(cell.text, tintOf(cell.ink));
        }
    }
    ImGui::EndTable();
}

/// Puts each row's cells below its label, as many in a line as fit.
void drawStacked(std::span<const StepRow> rows) {
    const float gap = ImGui::GetFontSize() * 0.6F;
    ImGui::PushTextWrapPos(0);
    for (const StepRow& row : rows) {
        drawLabel(row);
        ImGui::Indent(gap);
        const float left = ImGui::GetCursorPosX();
        float right = 0; // of the current line; 0: it is empty
        for (const reference::StepCell& cell : row.cells) {
            if (cell.text.empty())
                continue;
            const float width = ImGui::CalcTextSize(tr(cell.text).c_str()).x;
            if (right > 0 && right + gap + width <= ImGui::GetWindowContentRegionMax().x)
                ImGui::SameLine(0, gap);
            else
                right = left - gap;
            right += gap + width;
            text(cell.text, tintOf(cell.ink));
        }
        ImGui::Unindent(gap);
    }
    ImGui::PopTextWrapPos();
}

constexpr float minRowScale = 0.78F; // relative to the usual size, before a table is split

} // namespace

ImU32 tintOf(Ink ink) {
    const std::array<ImU32, 8> tints{color::text, color::s,   color::t, color::r,
                                     color::q,    color::dim, color::t, color::problem};
    return tints.at(static_cast<std::size_t>(ink));
}

void hangingText(const Sentence& words, ImU32 tint) {
    const float em = ImGui::GetFontSize();
    const float right = ImGui::GetWindowContentRegionMax().x + ImGui::GetScrollX();
    const float room = right - ImGui::GetCursorPosX();
    const float width = ImGui::CalcTextSize(tr(words).c_str()).x;
    if (room < width && room < 14 * em) {
        ImGui::NewLine();
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetTreeNodeToLabelSpacing());
    }
    ImGui::PushTextWrapPos(right);
    text(words, tint);
    ImGui::PopTextWrapPos();
}

void swatch(const std::optional<glm::vec4>& color) {
    if (!color)
        return;
    const float side = ImGui::GetTextLineHeight() * 0.8F;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float top = at.y + ImGui::GetTextLineHeight() * 0.1F;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled({at.x, top}, {at.x + side, top + side}, plotColor(*color));
    draw.AddRect({at.x, top}, {at.x + side, top + side}, color::outline);
    ImGui::Dummy({side, ImGui::GetTextLineHeight()});
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
}

float rowsWidth(const std::vector<StepRow>& rows) {
    float width = 0;
    for (const std::span<const StepRow> table : tablesOf(rows)) {
        if (!table.front().cells.empty())
            width = std::max(width, tableWidth(table));
    }
    return width;
}

void drawRows(const std::vector<StepRow>& rows) {
    for (const std::span<const StepRow> table : tablesOf(rows)) {
        if (table.front().cells.empty()) {
            for (const StepRow& row : table)
                wrappedText(row.label, tintOf(row.ink));
            continue;
        }
        ImGui::PushID(static_cast<int>(table.data() - rows.data()));
        const float width = tableWidth(table);
        const float room = ImGui::GetContentRegionAvail().x;
        const float usual = ImGui::GetCurrentWindow()->FontWindowScale;
        const float scale = width > room ? room / width * 0.98F : 1; // letters have integer widths
        ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {cellPadding(), ImGui::GetStyle().CellPadding.y});
        if (scale < minRowScale) {
            drawStacked(table);
        } else {
            if (scale < 1)
                ImGui::SetWindowFontScale(usual * scale);
            drawTable(table, std::min(width, room));
            ImGui::SetWindowFontScale(usual);
        }
        ImGui::PopStyleVar();
        ImGui::PopID();
    }
}

} // namespace texplorer::ui
