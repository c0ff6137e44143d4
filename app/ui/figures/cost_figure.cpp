#include "app/ui/figures/cost_figure.h"

#include "app/ui/figures/plot.h"
#include "app/ui/language/translate.h"
#include "app/ui/model/level_view.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/palette.h"
#include "app/ui/widgets/points.h"
#include "app/ui/widgets/same_line.h"
#include "app/ui/widgets/tip.h"
#include "app/ui/widgets/wrapped_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace texplorer::ui {
namespace {

constexpr double plotReach = 32; ///< ratios that the plot shows: from 1/32 to 32

void start(const Session& session, const HeldLevels& held) {
    view::CostSubject subject{selectedUnit(session).target, held.levels, held.problem};
    if (const Texture* texture = boundTexture(session); texture && isDrawn(texture->source))
        subject.lack = N_("the driver draws the texture: nothing is uploaded");
    if (!subject.lack.empty())
        subject.levels = nullptr; // they are of the texture before
    act(session, [subject = std::move(subject), request = held.request](Session& changed) {
        changed.cost = {subject, {}, changed.cost.driver, request};
    });
}

bool isMeasured(const CostFigure& figure) {
    return std::ranges::any_of(
        figure.costs, [](const view::CostTimes& row) { return !row.lack.empty() || !row.times.b.empty(); });
}

void drawTools(const Session& session, const CostFigureState& state, std::span<const Sentence> limits) {
    const CostFigure& figure = session.cost;
    const Sentence& lack = session.view.offered.whyNot(RendererKind::Fixed);
    if (figure.subject) {
        if (button(N_("Cancel"), "cost:cancel", N_("Ends the measurement; what is measured stays.")))
            act(session, [](Session& changed) { changed.cost.subject.reset(); });
    } else if (button(isMeasured(figure) ? N_("Measure again") : N_("Measure"), "cost:measure",
                      lack.empty()
                          ? Sentence(N_("Measures each row for a part of a second. The window stays usable; "
                                        "leave it alone for steady numbers."))
                          : lack,
                      lack.empty())) {
        start(session, state.held);
    }
    const float em = ImGui::GetFontSize();
    sameLineFor(em * 20, em * 0.8F);
    ImGui::AlignTextToFramePadding();
    const Sentence words =
        figure.subject
            ? Sentence("Measuring: {0} %",
                       static_cast<int>(100 * view::progressOf(figure.costs, view::costPairs)))
            : Sentence("A and B in turns, {0} times: medians. Bars and brackets: the middle half of the "
                       "ratios B/A.",
                       view::costPairs);
    fittedText(words, color::dim);
    noteItem(figure.subject ? "cost:progress" : "cost:words");
    helpTip(Sentence::joined("{0}\n{1}", limits));
}

/// The ratio on a scale of powers: B is faster on the left, slower on the right.
void drawRatio(const Quartiles& ratio, bool differs, ImVec2 low, ImVec2 size) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const auto x = [&](double value) {
        const double place = std::log(std::clamp(value, 1 / plotReach, plotReach)) / std::log(plotReach);
        return low.x + size.x * static_cast<float>(place + 1) / 2;
    };
    const float line = plotLine();
    const float middle = std::round(low.y + size.y / 2);
    const ImU32 ink = differs ? color::accent : color::dim;
    draw.AddLine({x(1), low.y}, {x(1), low.y + size.y}, color::faint, line);
    if (ratio.median <= 0)
        return;
    draw.AddLine({x(1), middle}, {x(ratio.median), middle}, ink, line);
    draw.AddRectFilled({x(ratio.low) - line, middle - 3 * line}, {x(ratio.high) + line, middle + 3 * line},
                       ink);
    draw.AddLine({x(ratio.median), middle - 5 * line}, {x(ratio.median), middle + 5 * line}, color::text,
                 2 * line);
}

/// A text of a cell, as wide as there is room next to `beside`.
void cellText(const Sentence& words, ImU32 ink, float beside = 0) {
    const float em = ImGui::GetFontSize();
    const float room = ImGui::GetContentRegionAvail().x;
    shrunkText(ImGui::GetCursorScreenPos(), tr(words), em, room - beside, ink);
    ImGui::Dummy({room, em});
}

void drawVariant(const view::CostVariant& variant, const Quartiles& time) {
    const bool isKnown = time.median > 0;
    const std::string taken = isKnown ? tr(view::timeText(time.median)) : "–";
    const float wide = ImGui::CalcTextSize(taken.c_str()).x;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddText({low.x + ImGui::GetContentRegionAvail().x - wide, low.y},
                                        isKnown ? color::text : color::dim, taken.c_str());
    cellText(variant.label, color::dim, wide + ImGui::GetFontSize() * 0.5F);
}

void drawRow(const Session& session, const CostFigureState& state, std::size_t index) {
    const view::CostRow& row = view::costRows.at(index);
    const view::CostTimes& times = session.cost.costs.at(index);
    const TimeComparison compared = compareTimes(times.times);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    cellText(row.label, color::text);
    helpTip(row.label);
    ImGui::TableNextColumn();
    drawVariant(row.a, compared.a);
    ImGui::TableNextColumn();
    drawVariant(row.b, compared.b);
    ImGui::TableNextColumn();
    const ImVec2 size(ImGui::GetContentRegionAvail().x, ImGui::GetFontSize());
    drawRatio(compared.ratio, compared.differs, ImGui::GetCursorScreenPos(), size);
    ImGui::Dummy(size);
    ImGui::TableNextColumn();
    const bool isOutdated = row.ofScene && compared.pairs > 0 && session.cost.measured != state.held.request;
    const Sentence verdict =
        isOutdated ? Sentence(N_("another texture was measured")) : view::verdictOn(times);
    cellText(verdict.empty() ? row.claim : verdict,
             compared.differs && !isOutdated ? color::text : color::dim);
    noteItem(fmt::format("cost:{}", row.name));
    helpTip(verdict.empty() ? row.claim : Sentence("{0}\n{1}", verdict, row.claim));
}

void drawRows(const Session& session, const CostFigureState& state) {
    const float em = ImGui::GetFontSize();
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {em * 0.6F, ImGui::GetStyle().CellPadding.y});
    const bool begun = ImGui::BeginTable("costs", 5, ImGuiTableFlags_SizingFixedFit);
    ImGui::PopStyleVar();
    if (!begun)
        return;
    constexpr auto stretched = ImGuiTableColumnFlags_WidthStretch;
    ImGui::TableSetupColumn("row", stretched, 1.7F);
    ImGui::TableSetupColumn("a", stretched, 1.7F);
    ImGui::TableSetupColumn("b", stretched, 1.7F);
    ImGui::TableSetupColumn("ratio", ImGuiTableColumnFlags_WidthFixed, em * 6);
    ImGui::TableSetupColumn("verdict", stretched, 3);
    ImGui::TableNextRow();
    constexpr std::array headings{"", "A", "B", N_("B : A")};
    for (const char* heading : headings) {
        ImGui::TableNextColumn();
        const float room = ImGui::GetContentRegionAvail().x;
        const float share = heading == headings.back() ? 0.5F : 0; // that of the ratio is above its line
        plotText(ImGui::GetCursorScreenPos() + ImVec2(room * share, 0), {share, 0}, tr(heading), color::dim);
        ImGui::Dummy({room, em});
    }
    helpTip(N_(
        "The time of B divided by that of A, from 1/32 to 32. On the left of the line B is faster, on the right "
        "slower."));
    for (std::size_t i = 0; i < view::costRows.size(); ++i)
        drawRow(session, state, i);
    ImGui::EndTable();
}

} // namespace

void drawCostFigure(const Session& session, CostFigureState& state) {
    ask(session, [&state](Session& changed) {
        const auto before = state.held.levels;
        (void)followLevels(workers(changed).levels, state.held, boundLevels(changed));
        return state.held.levels != before;
    });
    const std::vector<Sentence> limits = view::costLimits(session.cost.driver);
    drawTools(session, state, limits);
    drawRows(session, state);
    text(N_("What these numbers can't tell"));
    for (const Sentence& limit : limits)
        dimWrappedText(limit);
    noteItem("cost:limits");
}

} // namespace texplorer::ui
