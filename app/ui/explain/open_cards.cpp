#include "app/ui/explain/explain_pipeline.h"
#include "app/ui/explain/step_rows.h"
#include "app/ui/language/translate.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/param_widgets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace texplorer::ui {
namespace {

constexpr float minOpenWidth = 17; // in heights of the text

/// The density of the numbers in open cards.
struct OpenLook {
    float scale;
    bool airy; ///< with the usual space between lines
};

// The first one with which everything fits is used.
constexpr std::array openLooks{OpenLook{1, true}, OpenLook{1, false}, OpenLook{0.9F, false},
                               OpenLook{0.8F, false}};

/// Rows of a step in one column; rows that do not fit continue in the next.
struct StepPiece {
    const reference::Step* step;
    bool first;
    std::vector<reference::StepRow> rows{};
};

using StepColumn = std::vector<StepPiece>;

float cellHeight(const OpenLook& look) {
    return look.airy ? ImGui::GetStyle().CellPadding.y : 0;
}

float titleHeight(const reference::Step& step, float width) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float square = step.swatch ? ImGui::GetTextLineHeight() + style.ItemInnerSpacing.x : 0;
    const float left = width - ImGui::CalcTextSize(tr(step.title).c_str()).x - style.ItemSpacing.x - square;
    const std::string words = tr(step.summary);
    if (ImGui::CalcTextSize(words.c_str()).x <= left)
        return ImGui::GetTextLineHeight() + style.ItemSpacing.y;
    const bool below = left < 14 * ImGui::GetFontSize(); // as hangingText does
    const float room = std::max(1.0F, below ? width - ImGui::GetTreeNodeToLabelSpacing() : left);
    return wrappedSize(words, room).y + style.ItemSpacing.y +
           (below ? ImGui::GetTextLineHeightWithSpacing() : 0);
}

float heightOf(const StepPiece& piece, float width, const OpenLook& look) {
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    float height = piece.first ? titleHeight(*piece.step, width) : 0;
    for (std::size_t i = 0; i < piece.rows.size(); ++i) {
        const reference::StepRow& row = piece.rows[i];
        if (row.cells.empty()) {
            height += wrappedSize(tr(row.label), width).y + gap;
            continue;
        }
        const bool sameTable = i > 0 && piece.rows[i - 1].cells.size() == row.cells.size();
        height += ImGui::GetTextLineHeight() + 2 * cellHeight(look) + (sameTable ? 0 : gap);
    }
    return height;
}

float heightOf(const StepColumn& column, float width, const OpenLook& look) {
    float height = 0;
    for (const StepPiece& piece : column)
        height += heightOf(piece, width, look);
    return height;
}

/// The end of rows that must stay together: a heading and the row below it, a row and the indented rows below
/// it.
std::size_t unitEnd(const std::vector<reference::StepRow>& rows, std::size_t first) {
    std::size_t last = first;
    while (last + 1 < rows.size() && rows[last].heading)
        ++last;
    do
        ++last;
    while (last < rows.size() && rows[last].label.english().starts_with(' '));
    return last;
}

/// Places the steps of a card one below the other, and in further columns if they are higher than
/// `maxHeight`.
std::vector<StepColumn> columnsOf(const Lane& lane, const Card& card, float width, float maxHeight,
                                  const OpenLook& look) {
    std::vector<StepColumn> columns(1);
    for (const std::size_t index : card.steps) {
        const reference::Step& step = lane.steps.steps[index];
        StepPiece piece{&step, true};
        const reference::StepRow* heading = nullptr;
        std::size_t first = 0;
        do { // a step without rows still has its title
            const std::size_t last = first < step.rows.size() ? unitEnd(step.rows, first) : first;
            const auto unit = std::span(step.rows).subspan(first, last - first);
            StepPiece longer = piece;
            longer.rows.insert(longer.rows.end(), unit.begin(), unit.end());
            const bool begins = columns.back().empty() && piece.rows.empty();
            if (!begins &&
                heightOf(columns.back(), width, look) + heightOf(longer, width, look) > maxHeight) {
                if (!piece.rows.empty())
                    columns.back().push_back(std::exchange(piece, {&step, false}));
                columns.emplace_back();
                if (heading && !unit.front().heading && heading->cells.size() == unit.front().cells.size())
                    piece.rows.push_back(*heading);
                piece.rows.insert(piece.rows.end(), unit.begin(), unit.end());
            } else
                piece = std::move(longer);
            for (const reference::StepRow& row : unit)
                heading = row.heading ? &row : heading;
            first = last;
        } while (first < step.rows.size());
        columns.back().push_back(std::move(piece));
    }
    return columns;
}

void drawPiece(const StepPiece& piece) {
    const reference::Step& step = *piece.step;
    if (piece.first) {
        text(step.title, color::text);
        noteItem("explain:" + step.title.english());
        ImGui::SameLine();
        swatch(step.swatch);
        hangingText(step.summary, step.kind == reference::StepKind::IdleUnit ? color::problem : color::dim);
    }
    drawRows(piece.rows);
    noteItem((piece.first ? "explain:rows of " : "explain:more rows of ") + step.title.english());
}

/// The steps of a card. Each column is a window, so that sentences wrap at its edge.
void drawColumns(const std::vector<StepColumn>& columns, float width, const OpenLook& look) {
    float height = 0;
    ImGui::SetWindowFontScale(look.scale);
    for (const StepColumn& column : columns)
        height = std::max(height, heightOf(column, width, look));
    ImGui::SetWindowFontScale(1);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (i > 0)
            ImGui::SameLine();
        ImGui::PushID(static_cast<int>(i));
        ImGui::BeginChild("column", {width, height}, false,
                          ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
        ImGui::SetWindowFontScale(look.scale);
        ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {ImGui::GetStyle().CellPadding.x, cellHeight(look)});
        for (std::size_t k = 0; k < columns[i].size(); ++k) {
            ImGui::PushID(static_cast<int>(k));
            drawPiece(columns[i][k]);
            ImGui::PopID();
        }
        ImGui::PopStyleVar();
        ImGui::EndChild();
        ImGui::PopID();
    }
}

float stepsWidth(const Lane& lane, const Card& card) {
    float width = minOpenWidth * ImGui::GetFontSize();
    for (const std::size_t index : card.steps)
        width = std::max(width, rowsWidth(lane.steps.steps[index].rows));
    return std::ceil(width);
}

/// An open card, with the same card of the pinned pixel if that has it.
struct OpenCard {
    const Card* card;
    const Card* pinned;
    float columnWidth = 0; ///< in pixels
    float width = 0;
    OpenLook look = openLooks.front();
    std::vector<StepColumn> columns{};
    std::vector<StepColumn> pinnedColumns{};

    [[nodiscard]] std::size_t columnCount() const { return std::max(columns.size(), pinnedColumns.size()); }
};

ImVec2 openPadding() {
    const ImVec2 usual = ImGui::GetStyle().WindowPadding;
    return {usual.x, std::floor(usual.y / 2)};
}

/// Returns whether no column is higher than `maxHeight`. No column is wider than `room`, the width of the
/// panel.
bool arrange(OpenCard& open, std::span<const Lane> lanes, const OpenLook& look, float maxHeight, float room) {
    ImGui::SetWindowFontScale(look.scale);
    open.look = look;
    open.columnWidth = std::max(stepsWidth(lanes.back(), *open.card),
                                open.pinned ? stepsWidth(lanes.front(), *open.pinned) : 0);
    const ImGuiStyle& style = ImGui::GetStyle();
    open.columnWidth =
        std::min(open.columnWidth, std::max(1.0F, room - 2 * openPadding().x - style.ScrollbarSize));
    open.columns = columnsOf(lanes.back(), *open.card, open.columnWidth, maxHeight, look);
    if (open.pinned)
        open.pinnedColumns = columnsOf(lanes.front(), *open.pinned, open.columnWidth, maxHeight, look);
    const auto isHigher = [&](const StepColumn& column) {
        return heightOf(column, open.columnWidth, look) > maxHeight;
    };
    const bool fits =
        std::ranges::none_of(open.columns, isHigher) && std::ranges::none_of(open.pinnedColumns, isHigher);
    ImGui::SetWindowFontScale(1);
    const auto count = static_cast<float>(open.columnCount());
    open.width =
        count * open.columnWidth + (count - 1) * ImGui::GetStyle().ItemSpacing.x + 2 * openPadding().x;
    return fits;
}

/// Uses as many columns as fit, so that scrolling is not needed; if that is not possible, as few lines as
/// possible. `panel`: the width of the panel.
void arrange(OpenCard& open, std::span<const Lane> lanes, ImVec2 room, float panel) {
    const float line = ImGui::GetTextLineHeightWithSpacing();
    float maxHeight = room.y - 2 * openPadding().y - line;
    if (open.pinned)
        maxHeight = (maxHeight - 2 * line) / 2;
    for (const OpenLook& look : openLooks) {
        if (arrange(open, lanes, look, maxHeight, panel) && open.width <= room.x)
            return;
    }
    const float bar = ImGui::GetStyle().ScrollbarSize;
    maxHeight = std::max(maxHeight, line);
    do {
        arrange(open, lanes, openLooks.front(), maxHeight, panel);
        maxHeight *= 1.1F;
    } while (open.width + bar > room.x && open.columnCount() > 1);
    open.width += bar;
}

constexpr float minLineHeight = 7.5F; // the height of a line of open cards, in heights of the text

/// Open cards in one row.
struct OpenLine {
    std::vector<OpenCard> cards{};
    float left = 0; ///< remaining width
};

/// Uses as many lines as needed for the panel's width, and fits them into its height if possible.
std::vector<OpenLine> arrangedCards(const OpenCards& opened, std::span<const Lane> lanes, float& height) {
    const float panel = ImGui::GetContentRegionAvail().x;
    const float gap = ImGui::GetFontSize() * 0.5F;
    std::vector<OpenLine> lines;
    for (const Card& card : lanes.back().cards) {
        if (!opened.contains({card.stage, card.unit}))
            continue;
        OpenCard open{&card, lanes.size() > 1 ? sameCard(lanes.front().cards, card) : nullptr};
        arrange(open, lanes, openLooks.front(), std::numeric_limits<float>::max(), panel);
        const float needed = open.width + ImGui::GetStyle().ScrollbarSize + gap;
        if (lines.empty() || lines.back().left < needed)
            lines.push_back({{}, panel + gap});
        lines.back().left -= needed;
        lines.back().cards.push_back(std::move(open));
    }
    const auto count = static_cast<float>(lines.size());
    const float share = (height - (count - 1) * ImGui::GetStyle().ItemSpacing.y) / std::max(1.0F, count);
    height = lines.size() < 2 ? height : std::max(std::floor(share), minLineHeight * ImGui::GetFontSize());
    for (OpenLine& line : lines) {
        float left = line.left;
        for (OpenCard& open : line.cards) { // the remaining width goes to the first card that needs it
            const float before = open.width + ImGui::GetStyle().ScrollbarSize;
            arrange(open, lanes, {before + std::max(left, 0.0F), height}, panel);
            left -= open.width - before;
        }
    }
    return lines;
}

/// Returns whether it is to be closed.
bool drawOpenCard(const OpenCard& open, std::span<const Lane> lanes, float height) {
    const Card& card = *open.card;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, openPadding());
    ImGui::BeginChild("steps", {open.width, height}, true);
    ImGui::PopStyleVar();
    text(card.name, color::chosen);
    const float button = ImGui::GetFrameHeight();
    ImGui::SameLine(std::max(0.0F, ImGui::GetWindowContentRegionMax().x - button));
    const bool closes = smallButton("✕");
    noteItem("close card:" + card.name.english());
    drawColumns(open.columns, open.columnWidth, open.look);
    if (open.pinned) {
        ImGui::Separator();
        text(lanes.front().title, color::dim);
        ImGui::PushID("pinned");
        drawColumns(open.pinnedColumns, open.columnWidth, open.look);
        ImGui::PopID();
    }
    ImGui::EndChild();
    return closes;
}

} // namespace

void drawOpenCards(OpenCards& cards, std::span<const Lane> lanes, float height) {
    for (const OpenLine& line : arrangedCards(cards, lanes, height)) {
        for (const OpenCard& open : line.cards) {
            if (&open != &line.cards.front())
                ImGui::SameLine(0, ImGui::GetFontSize() * 0.5F);
            ImGui::PushID(static_cast<int>(open.card->stage) * 16 + open.card->unit);
            if (drawOpenCard(open, lanes, height))
                cards.erase({open.card->stage, open.card->unit});
            ImGui::PopID();
        }
    }
}

} // namespace texplorer::ui
