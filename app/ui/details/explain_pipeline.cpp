#include "app/ui/details/explain_pipeline.h"

#include "app/ui/details/explain_pictures.h"
#include "app/ui/details/step_rows.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/theme.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace texplorer::ui {
namespace {

// In heights of the text.
constexpr float leastPicture = 2.5F; // what is lower is left out
constexpr float usualPicture = 4;
constexpr float largestPicture = 8;
constexpr float leastOpen = 9; // what open cards need below
constexpr float narrowestOpen = 17;
constexpr float mostSlack = 5; // that a card is wider than it must be

/// The lengths of the cards, in pixels.
struct CardMeasure {
    float em = ImGui::GetFontSize();
    float pad = std::floor(em * 0.4F);
    float arrow = std::floor(em * 0.85F);
    float line = std::floor(em * 1.2F);
    float picture = 0; ///< 0: cards show none

    [[nodiscard]] float height() const {
        return 2 * pad + 4 * line + (picture > 0 ? picture + pad : 0); // the name and three lines
    }
};

float naturalWidth(const Card& card, const CardMeasure& measure) {
    float width = std::max(ImGui::CalcTextSize(card.name.c_str()).x, usualPicture * measure.em);
    for (const CardLine& line : card.lines)
        width = std::max(width, ImGui::CalcTextSize(line.text.c_str()).x);
    return std::ceil(width) + 2 * measure.pad;
}

const Card* sameCard(const Lane& lane, const Card& card) {
    const auto found = std::ranges::find_if(
        lane.cards, [&](const Card& other) { return other.stage == card.stage && other.unit == card.unit; });
    return found == lane.cards.end() ? nullptr : &*found;
}

/// What one adds to each card so that they fill the width.
float slackOf(const Lane& lane, const CardMeasure& measure, float available) {
    float width = measure.arrow * static_cast<float>(lane.cards.size() - 1);
    for (const Card& card : lane.cards)
        width += naturalWidth(card, measure);
    const float slack = (available - width) / static_cast<float>(lane.cards.size());
    return std::floor(std::clamp(slack, 0.0F, mostSlack * measure.em));
}

/// A card at the cursor; true where it was clicked. `other` is what it is compared with.
bool drawCard(const Lane& lane, const Card& card, const Card* other, bool open, float width,
              const CardMeasure& measure) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high(low.x + width, low.y + measure.height());
    const bool clicked = ImGui::InvisibleButton("card", {width, measure.height()});
    const bool hovered = ImGui::IsItemHovered() || (ImGui::GetIO().NavVisible && ImGui::IsItemFocused());
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(low, high, ImGui::GetColorU32(hovered ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg),
                       ImGui::GetStyle().FrameRounding);
    if (open)
        draw.AddRect(low, high, color::text, ImGui::GetStyle().FrameRounding);
    float y = low.y + measure.pad;
    const float x = low.x + measure.pad;
    draw.AddText({x, y}, color::text, card.name.c_str());
    y += measure.line;
    if (measure.picture > 0) {
        draw.PushClipRect(low, high, true);
        drawStagePicture(draw, {x, y}, {high.x - measure.pad, y + measure.picture}, card, lane.fragment);
        draw.PopClipRect();
        y += measure.picture + measure.pad;
    }
    for (std::size_t i = 0; i < card.lines.size(); ++i) {
        const CardLine& line = card.lines[i];
        const bool differs = other && (i >= other->lines.size() || other->lines[i].text != line.text);
        const ImU32 tint = differs ? color::changed : tintOf(line.ink);
        draw.AddText({x, y}, tint, line.text.c_str());
        if (differs) {
            const float under = y + measure.em + 1;
            draw.AddLine({x, under}, {x + ImGui::CalcTextSize(line.text.c_str()).x, under}, tint);
        }
        y += measure.line;
    }
    return clicked;
}

void drawArrow(const CardMeasure& measure) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float y = low.y + measure.height() / 2;
    const float half = measure.em * 0.28F;
    const float x = low.x + (measure.arrow - half) / 2;
    ImGui::GetWindowDrawList()->AddTriangleFilled({x, y - half}, {x, y + half}, {x + half, y}, color::dim);
    ImGui::Dummy({measure.arrow, measure.height()});
}

void drawLane(PipelineState& state, const Lane& lane, const Lane* other, const CardMeasure& measure,
              float available) {
    const float slack = slackOf(lane, measure, available);
    for (std::size_t i = 0; i < lane.cards.size(); ++i) {
        const Card& card = lane.cards[i];
        if (i > 0) {
            ImGui::SameLine(0, 0);
            drawArrow(measure);
            ImGui::SameLine(0, 0);
        }
        const std::pair key(card.stage, card.unit);
        ImGui::PushID(static_cast<int>(i));
        const bool open = state.open.contains(key);
        const Card* against = other ? sameCard(*other, card) : nullptr;
        if (drawCard(lane, card, against, open, naturalWidth(card, measure) + slack, measure)) {
            if (open)
                state.open.erase(key);
            else
                state.open.insert(key);
        }
        noteItem((other || lane.title.empty() ? "card:" : "pinned card:") + card.name);
        helpTip(rowOf(card.stage).help);
        ImGui::PopID();
    }
}

/// All that a card's steps say.
void drawCardSteps(const Lane& lane, const Card& card) {
    for (const std::size_t index : card.steps) {
        const reference::Step& step = lane.steps.steps[index];
        inkText(step.title, color::text);
        noteItem("explain:" + step.title);
        ImGui::SameLine();
        if (step.swatch) {
            swatch(*step.swatch);
            ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
        }
        hangingText(step.summary, step.kind == reference::StepKind::IdleUnit ? color::problem : color::dim);
        drawRows(step.rows);
        noteItem("explain:rows of " + step.title);
    }
}

float stepsWidth(const Lane& lane, const Card& card) {
    float width = narrowestOpen * ImGui::GetFontSize();
    for (const std::size_t index : card.steps)
        width = std::max(width, rowsWidth(lane.steps.steps[index].rows));
    return width;
}

/// The open cards side by side, each with all of its numbers.
void drawOpenCards(PipelineState& state, std::span<const Lane> lanes, float height) {
    const Lane& lane = lanes.back();
    const float em = ImGui::GetFontSize();
    bool first = true;
    std::optional<std::pair<Stage, int>> closed;
    for (const Card& card : lane.cards) {
        const std::pair key(card.stage, card.unit);
        if (!state.open.contains(key))
            continue;
        if (!std::exchange(first, false))
            ImGui::SameLine(0, em * 0.5F);
        const Card* pinned = lanes.size() > 1 ? sameCard(lanes.front(), card) : nullptr;
        const float width =
            std::max(stepsWidth(lane, card), pinned ? stepsWidth(lanes.front(), *pinned) : 0) +
            2 * ImGui::GetStyle().WindowPadding.x + ImGui::GetStyle().ScrollbarSize;
        ImGui::PushID(static_cast<int>(card.stage) * 16 + card.unit);
        ImGui::BeginChild("steps", {width, height}, true);
        inkText(card.name, color::chosen);
        const float button = ImGui::GetFrameHeight();
        ImGui::SameLine(std::max(0.0F, ImGui::GetWindowContentRegionMax().x - button));
        if (ImGui::SmallButton("✕"))
            closed = key;
        noteItem("close card:" + card.name);
        drawCardSteps(lane, card);
        if (pinned) {
            ImGui::Separator();
            inkText(lanes.front().title, color::dim);
            ImGui::PushID("pinned");
            drawCardSteps(lanes.front(), *pinned);
            ImGui::PopID();
        }
        ImGui::EndChild();
        ImGui::PopID();
    }
    if (closed)
        state.open.erase(*closed);
}

bool isAnyOpen(const PipelineState& state, const Lane& lane) {
    return std::ranges::any_of(
        lane.cards, [&](const Card& card) { return state.open.contains(std::pair(card.stage, card.unit)); });
}

} // namespace

void drawPipeline(PipelineState& state, std::span<const Lane> lanes) {
    CardMeasure measure;
    const auto count = static_cast<float>(lanes.size());
    const bool titled = lanes.size() > 1;
    const float title = titled ? measure.line : 0;
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    const bool open = isAnyOpen(state, lanes.back());
    const ImVec2 available = ImGui::GetContentRegionAvail();
    float widest = 0;
    for (const Lane& lane : lanes) {
        float width = measure.arrow * static_cast<float>(lane.cards.size() - 1);
        for (const Card& card : lane.cards)
            width += naturalWidth(card, measure);
        widest = std::max(widest, width);
    }
    const float bar = widest > available.x ? ImGui::GetStyle().ScrollbarSize : 0;
    const float room = available.y - (open ? leastOpen * measure.em + gap : 0);
    const float left = (room - bar) / count - title - gap - measure.height() - measure.pad;
    if (left >= leastPicture * measure.em)
        measure.picture = std::floor(std::min(left, (open ? usualPicture : largestPicture) * measure.em));
    const float height =
        count * (title + measure.height()) + (count - 1) * gap + (titled ? count * gap : 0) + bar;
    ImGui::BeginChild("cards", {0, height}, false,
                      ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    for (const Lane& lane : lanes) {
        const bool compared = titled && &lane == &lanes.back();
        ImGui::PushID(&lane == &lanes.back() ? "explained" : "pinned");
        if (titled)
            inkText(lane.title, compared ? color::probed : color::dim);
        drawLane(state, lane, compared ? &lanes.front() : nullptr, measure, available.x);
        ImGui::PopID();
    }
    ImGui::EndChild();
    if (open) {
        const float rest = std::max(ImGui::GetContentRegionAvail().y, leastOpen * measure.em);
        ImGui::BeginChild("open", {0, rest}, false, ImGuiWindowFlags_HorizontalScrollbar);
        drawOpenCards(state, lanes, ImGui::GetContentRegionAvail().y);
        ImGui::EndChild();
    }
}

void drawStages() {
    const CardMeasure measure;
    const auto shown = static_cast<float>(std::ranges::count(stageRows, true, &StageRow::always));
    const ImVec2 available = ImGui::GetContentRegionAvail();
    const float width = std::floor((available.x - (shown - 1) * measure.arrow) / shown);
    const float wrap = width - 2 * measure.pad;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ImVec2 low = ImGui::GetCursorScreenPos();
    float height = 0;
    for (const StageRow& row : stageRows)
        height = std::max(height, row.always ? ImGui::CalcTextSize(row.help, nullptr, false, wrap).y : 0);
    height += measure.line + 3 * measure.pad;
    for (const StageRow& row : stageRows) {
        if (!row.always)
            continue;
        const ImVec2 high(low.x + width, low.y + height);
        draw.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg, 0.5F),
                           ImGui::GetStyle().FrameRounding);
        draw.AddText({low.x + measure.pad, low.y + measure.pad}, color::text, row.name);
        draw.AddText(ImGui::GetFont(), ImGui::GetFontSize(),
                     {low.x + measure.pad, low.y + measure.pad + measure.line}, color::dim, row.help, nullptr,
                     wrap);
        noteDrawn(fmt::format("stage:{}", row.name), low, high);
        if (&row != &stageRows.back()) {
            const float half = measure.em * 0.28F;
            const float x = high.x + (measure.arrow - half) / 2;
            const float y = low.y + height / 2;
            draw.AddTriangleFilled({x, y - half}, {x, y + half}, {x + half, y}, color::dim);
        }
        low.x = high.x + measure.arrow;
    }
    ImGui::Dummy({available.x, height});
}

} // namespace texplorer::ui
