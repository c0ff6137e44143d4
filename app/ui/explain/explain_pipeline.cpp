#include "app/ui/explain/explain_pipeline.h"

#include "app/ui/explain/step_rows.h"
#include "app/ui/language/translate.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/param_widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace texplorer::ui {
namespace {

// In heights of the text.
constexpr float minPicture = 2.5F; // lower pictures are left out
constexpr float usualPicture = 4;
constexpr float maxPicture = 8;
constexpr float minOpen = 7.5F;      // the height of open cards below
constexpr float maxSlack = 5;        // the most that a card is wider than necessary
constexpr float minCardWidth = 5.2F; // if cards share too little room
constexpr float minText = 0.78F;     // relative to the usual size, before a text is cut

/// The lengths of the cards, in pixels.
struct CardMeasure {
    float em = ImGui::GetFontSize();
    float pad = std::floor(em * 0.4F);
    float arrow = std::floor(em * 0.85F);
    float line = std::floor(em * 1.2F);
    float picture = 0; ///< 0: cards show none

    /// The space between texts is reduced, so that the texts get more.
    void tighten() {
        pad = std::floor(em * 0.3F);
        arrow = std::floor(em * 0.45F);
    }

    /// The lines are as close as possible, for low cards.
    void flatten() {
        pad = std::floor(em * 0.2F);
        line = std::floor(em * 1.05F);
    }

    [[nodiscard]] float height() const {
        return 2 * pad + 4 * line + (picture > 0 ? picture + pad : 0); // the name and three lines
    }
};

/// With a smaller text.
float naturalWidth(const Card& card, const CardMeasure& measure, float scale = 1) {
    float width = std::max(ImGui::CalcTextSize(tr(card.name).c_str()).x, usualPicture * measure.em);
    for (const CardLine& line : card.lines)
        width = std::max(width, ImGui::CalcTextSize(tr(line.text).c_str()).x);
    return std::ceil(width * scale) + 2 * measure.pad;
}

/// The number of cards in the first of this many lines.
std::size_t cardsInLine(std::span<const Card> cards, std::size_t lines, std::size_t most) {
    const std::size_t even = (cards.size() + lines - 1) / lines;
    const auto distance = [even](std::size_t count) { return count > even ? count - even : even - count; };
    std::size_t best = 0;
    for (std::size_t i = 1; i < cards.size() && i <= most; ++i) {
        const bool unitBegins = cards[i].unit >= 0 && cards[i].unit != cards[i - 1].unit;
        if (unitBegins && cards.size() - i <= (lines - 1) * most && distance(i) < distance(best))
            best = i;
    }
    return best > 0 ? best : even;
}

/// Distributes the cards of a lane over as few lines as possible. Lines begin with a unit if it fits, and are
/// otherwise as even as possible. All lines but the first begin with an arrow.
std::vector<std::span<const Card>> linesOf(const Lane& lane, const CardMeasure& measure, float available) {
    const float min = minCardWidth * measure.em + measure.arrow;
    const auto most = static_cast<std::size_t>(std::max(1.0F, available / min));
    std::span<const Card> left(lane.cards);
    std::vector<std::span<const Card>> lines;
    for (std::size_t count = (left.size() + most - 1) / most; count > 0; --count) {
        lines.push_back(left.first(cardsInLine(left, count, most)));
        left = left.subspan(lines.back().size());
    }
    return lines;
}

float arrowsOf(std::span<const Card> line, bool first, const CardMeasure& measure) {
    return measure.arrow * static_cast<float>(line.size() - (first ? 1 : 0));
}

/// The widths of a line's cards if all are as wide as their texts.
float naturalWidth(std::span<const Card> line, bool first, const CardMeasure& measure, float scale = 1) {
    float width = arrowsOf(line, first, measure);
    for (const Card& card : line)
        width += naturalWidth(card, measure, scale);
    return width;
}

/// Reduces the widest cards to one common width until all fit; none becomes too narrow to read.
void shareRoom(std::vector<float>& widths, float room, float min) {
    std::vector<float> sorted = widths;
    std::ranges::sort(sorted);
    float cap = min;
    float before = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const float each = (room - before) / static_cast<float>(sorted.size() - i);
        if (each < sorted[i]) {
            cap = std::max(min, std::floor(each));
            break;
        }
        before += sorted[i];
    }
    for (float& width : widths)
        width = std::min(width, cap);
}

/// As wide as the text and slightly more, if that fits.
std::vector<float> widthsOf(std::span<const Card> line, bool first, const CardMeasure& measure,
                            float available) {
    // All texts are made slightly smaller before one is cut.
    float scale = 1;
    while (scale > minText && naturalWidth(line, first, measure, scale) > available)
        scale = std::max(minText, scale - 0.01F);
    const bool isTight = scale < 1 && naturalWidth(line, first, measure, scale) <= available;
    std::vector<float> widths;
    for (const Card& card : line)
        widths.push_back(naturalWidth(card, measure, isTight ? scale : 1));
    if (isTight)
        return widths;
    const float left = available - naturalWidth(line, first, measure);
    if (left < 0) {
        shareRoom(widths, available - arrowsOf(line, first, measure), minCardWidth * measure.em);
        return widths;
    }
    const float slack = left / static_cast<float>(line.size());
    for (float& width : widths)
        width += std::floor(std::min(slack, maxSlack * measure.em));
    return widths;
}

/// A line of text in a card: slightly smaller if it has little room, and cut if that is not enough.
struct ShownLine {
    std::string text;
    float scale = 1;
    bool cut = false;

    [[nodiscard]] float width() const { return ImGui::CalcTextSize(text.c_str()).x * scale; }
};

ShownLine lineThatFits(const Sentence& english, float room) {
    const std::string text = tr(english);
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    if (width <= room)
        return {text};
    const float scale = std::max(minText, room / width);
    const std::string shown = fitted(english, room / scale + 0.5F);
    return {shown, scale, shown != text};
}

void drawLine(ImDrawList& draw, ImVec2 at, ImU32 tint, const ShownLine& line) {
    const float size = ImGui::GetFontSize();
    draw.AddText(ImGui::GetFont(), size * line.scale, {at.x, std::round(at.y + size * (1 - line.scale) / 2)},
                 tint, line.text.c_str());
}

/// The full text of a card, for when it is cut.
Sentence wordsOf(const Card& card) {
    std::vector<Sentence> lines{card.name};
    std::ranges::transform(card.lines, std::back_inserter(lines), &CardLine::text);
    lines.emplace_back(rowOf(card.stage).help);
    return Sentence::joined("{0}\n{1}", lines);
}

/// The last item as a card, which is compared with `other`. Returns whether its text is cut.
bool drawCard(const Lane& lane, const Card& card, const Card* other, bool open, const CardMeasure& measure) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const bool hovered = ImGui::IsItemHovered() || (ImGui::GetIO().NavVisible && ImGui::IsItemFocused());
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(low, high, ImGui::GetColorU32(hovered ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg),
                       ImGui::GetStyle().FrameRounding);
    if (open)
        draw.AddRect(low, high, color::text, ImGui::GetStyle().FrameRounding);
    float y = low.y + measure.pad;
    const float x = low.x + measure.pad;
    const float room = high.x - low.x - 2 * measure.pad;
    const ShownLine name = lineThatFits(card.name, room);
    bool cut = name.cut;
    drawLine(draw, {x, y}, color::text, name);
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
        const ShownLine shown = lineThatFits(line.text, room);
        cut |= shown.cut;
        drawLine(draw, {x, y}, tint, shown);
        if (differs) {
            const float under = y + measure.em + 1;
            draw.AddLine({x, under}, {x + shown.width(), under}, tint);
        }
        y += measure.line;
    }
    return cut;
}

/// An arrow in the middle of the room between two stages.
void drawStageArrow(float left, float y, float room) {
    const float half = ImGui::GetFontSize() * 0.28F;
    const float x = left + (room - half) / 2;
    ImGui::GetWindowDrawList()->AddTriangleFilled({x, y - half}, {x, y + half}, {x + half, y}, color::dim);
}

void drawCards(OpenCards& cards, const Lane& lane, std::span<const Card> line, const Lane* other,
               const CardMeasure& measure, float available) {
    const bool first = line.data() == lane.cards.data();
    const std::vector<float> widths = widthsOf(line, first, measure, available);
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Card& card = line[i];
        if (i > 0)
            ImGui::SameLine(0, 0);
        if (i > 0 || !first) {
            const ImVec2 low = ImGui::GetCursorScreenPos();
            drawStageArrow(low.x, low.y + measure.height() / 2, measure.arrow);
            ImGui::Dummy({measure.arrow, measure.height()});
            ImGui::SameLine(0, 0);
        }
        const std::pair key(card.stage, card.unit);
        ImGui::PushID(static_cast<int>(card.stage) * 16 + card.unit);
        const bool open = cards.contains(key);
        const bool pressed = ImGui::InvisibleButton("card", {widths[i], measure.height()});
        const bool cut = drawCard(lane, card, other ? sameCard(other->cards, card) : nullptr, open, measure);
        if (pressed && cards.erase(key) == 0)
            cards.insert(key);
        item((other || lane.title.empty() ? "card:" : N_("pinned card:")) + card.name.english(),
             cut ? wordsOf(card) : rowOf(card.stage).help);
        ImGui::PopID();
    }
}

/// In one line, or in two if there is not enough width.
struct StagesPlan : CardMeasure {
    float width = 0; ///< of a card
    float scale = 1; ///< of its text
    std::vector<std::vector<const StageRow*>> lines;

    [[nodiscard]] float height(const std::vector<const StageRow*>& rows) const {
        float height = 0;
        for (const StageRow* row : rows)
            height = std::max(height, wrappedSize(tr(row->help), (width - 2 * pad) / scale).y * scale);
        return height + line + 3 * pad;
    }
    [[nodiscard]] float height() const {
        float sum = -ImGui::GetStyle().ItemSpacing.y;
        for (const auto& rows : lines)
            sum += height(rows) + ImGui::GetStyle().ItemSpacing.y;
        return sum;
    }
};

StagesPlan planStages(ImVec2 available) {
    constexpr float minStageWidth = 6.5F; // for its longest word, in heights of the text
    StagesPlan plan;
    std::vector<const StageRow*> all;
    for (const StageRow& row : stageRows) {
        if (row.always)
            all.push_back(&row);
    }
    const auto widthOf = [&](std::size_t count) {
        const auto n = static_cast<float>(count);
        return std::floor((available.x - (n - 1) * plan.arrow) / n);
    };
    std::size_t perLine = all.size();
    if (widthOf(perLine) < minStageWidth * plan.em)
        perLine = (all.size() + 1) / 2;
    plan.width = widthOf(perLine);
    for (std::size_t i = 0; i < all.size(); i += perLine)
        plan.lines.emplace_back(all.begin() + static_cast<std::ptrdiff_t>(i),
                                all.begin() + static_cast<std::ptrdiff_t>(std::min(i + perLine, all.size())));
    if (plan.height() > available.y) {
        plan.scale = 0.85F;
        plan.flatten();
    }
    return plan;
}

void drawStage(const StagesPlan& plan, const StageRow& row, ImVec2 low, ImVec2 high) {
    const float wrap = plan.width - 2 * plan.pad;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg, 0.5F),
                       ImGui::GetStyle().FrameRounding);
    draw.AddText({low.x + plan.pad, low.y + plan.pad}, color::text, fitted(row.name, wrap).c_str());
    draw.AddText(ImGui::GetFont(), ImGui::GetFontSize() * plan.scale,
                 {low.x + plan.pad, low.y + plan.pad + plan.line}, color::dim,
                 wrappedLines(tr(row.help), wrap / plan.scale).c_str());
    noteDrawn(fmt::format("stage:{}", row.name), low, high);
    if (&row != &stageRows.back())
        drawStageArrow(high.x, (low.y + high.y) / 2, plan.arrow);
}

} // namespace

void drawPipeline(OpenCards& cards, std::span<const Lane> lanes) {
    CardMeasure measure;
    const bool titled = lanes.size() > 1;
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    const bool open = std::ranges::any_of(lanes.back().cards, [&](const Card& card) {
        return cards.contains({card.stage, card.unit});
    });
    const ImVec2 available = ImGui::GetContentRegionAvail();
    const auto isTooWide = [&](const Lane& lane) {
        return naturalWidth(lane.cards, true, measure) > available.x;
    };
    if (std::ranges::any_of(lanes, isTooWide))
        measure.tighten();
    std::vector<std::vector<std::span<const Card>>> split;
    float count = 0; // lines of cards
    for (const Lane& lane : lanes)
        count += static_cast<float>(split.emplace_back(linesOf(lane, measure, available.x)).size());
    const auto lanesHeight = [&] {
        const float titles = titled ? static_cast<float>(lanes.size()) * (measure.line + gap) : 0;
        return titles + count * (measure.height() + gap) - gap;
    };
    const float room = available.y - (open ? minOpen * measure.em + gap : 0);
    if (lanesHeight() > room)
        measure.flatten();
    const float left = (room - lanesHeight()) / count - measure.pad;
    if (left >= minPicture * measure.em)
        measure.picture = std::floor(std::min(left, (open ? usualPicture : maxPicture) * measure.em));
    for (std::size_t i = 0; i < lanes.size(); ++i) {
        const bool compared = titled && i + 1 == lanes.size();
        ImGui::PushID(i + 1 == lanes.size() ? "explained" : "pinned");
        if (titled)
            text(lanes[i].title, compared ? color::probed : color::dim);
        for (const std::span<const Card> line : split[i])
            drawCards(cards, lanes[i], line, compared ? &lanes.front() : nullptr, measure, available.x);
        ImGui::PopID();
    }
    if (open) {
        const float rest = std::max(ImGui::GetContentRegionAvail().y, minOpen * measure.em);
        ImGui::BeginChild("open", {0, rest});
        drawOpenCards(cards, lanes, ImGui::GetContentRegionAvail().y);
        ImGui::EndChild();
    }
}

void drawStages() {
    const ImVec2 available = ImGui::GetContentRegionAvail();
    const StagesPlan plan = planStages(available);
    const ImVec2 begin = ImGui::GetCursorScreenPos();
    float y = begin.y;
    for (const auto& line : plan.lines) {
        const float height = plan.height(line);
        float x = begin.x;
        for (const StageRow* row : line) {
            drawStage(plan, *row, {x, y}, {x + plan.width, y + height});
            x += plan.width + plan.arrow;
        }
        y += height + ImGui::GetStyle().ItemSpacing.y;
    }
    ImGui::Dummy({available.x, plan.height()});
}

} // namespace texplorer::ui
