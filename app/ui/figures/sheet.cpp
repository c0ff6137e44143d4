#include "app/ui/figures/sheet.h"

#include "app/ui/figures/plot.h"
#include "app/ui/language/translate.h"
#include "app/ui/model/notice.h"
#include "app/ui/model/preview.h"
#include "app/ui/model/sheet_choice.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/param_names.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/points.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace texplorer::ui {
namespace {

constexpr std::size_t maxPerSide = 8;
constexpr float minCell = 6.5F; ///< heights of the text: narrower cells are scrolled instead

/// An axis and its labels.
struct NamedAxis {
    SweepAxis axis;
    const ParamRow* row;
    std::vector<Sentence> labels; ///< one for each value
    std::size_t all;              ///< the number of all values; `axis` has the shown ones

    [[nodiscard]] std::size_t count() const { return axis.values.size(); }
};

NamedAxis namedAxis(const Session& session, SweepAxis axis) {
    const Scene& scene = presentScene(session);
    NamedAxis named{std::move(axis), nullptr, {}, 0};
    named.row = paramAt(scene, named.axis.path)->row;
    named.all = named.axis.values.size();
    named.axis.values.resize(std::min(named.all, maxPerSide));
    const sheet::LabelKind kind =
        session.settings.glNames ? sheet::LabelKind::Names : sheet::LabelKind::Words;
    for (const std::string& value : named.axis.values)
        named.labels.push_back(sheet::labelOf(*named.row, value, kind));
    return named;
}

/// The layout of the pictures.
struct SheetPlan {
    float head = 0; ///< width of the rows' labels
    float line = 0; ///< height of the columns' labels
    float gap = 1;
    ImVec2 cell{1, 1};
};

float headOf(const NamedAxis& rows) {
    float width = 0;
    for (const Sentence& each : rows.labels)
        width = std::max(width, ImGui::CalcTextSize(tr(each).c_str()).x);
    return std::min(std::ceil(width + ImGui::GetFontSize() * 0.6F),
                    std::floor(ImGui::GetContentRegionAvail().x * 0.22F));
}

/// `aspect`: width / height of the view.
SheetPlan planSheet(const NamedAxis& rows, const NamedAxis& columns, float aspect) {
    const float em = ImGui::GetFontSize();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    SheetPlan plan{
        .head = headOf(rows), .line = std::ceil(em * 1.25F), .gap = std::max(2.0F, std::floor(em / 5))};
    const auto share = [&](float all, std::size_t count) {
        return (all + plan.gap) / static_cast<float>(std::max<std::size_t>(1, count)) - plan.gap;
    };
    const float width = share(room.x - plan.head, columns.count());
    const float height = room.y - plan.line;
    float wide = std::min(width, share(height, rows.count()) * aspect);
    if (wide < em * minCell) { // then they scroll; one row and a part of the next are visible
        const float maxWidth = share(room.x - plan.head - ImGui::GetStyle().ScrollbarSize, columns.count());
        wide = std::min(maxWidth, std::max(em * minCell, height / 1.4F * aspect));
    }
    plan.cell.x = std::max(8.0F, std::floor(wide));
    plan.cell.y = std::max(6.0F, std::floor(plan.cell.x / aspect));
    return plan;
}

struct Axes {
    NamedAxis rows;
    NamedAxis columns;
};

Sentence wordsOf(const Session& session, const Axes& axes, std::size_t row, std::size_t column) {
    const Settings& settings = session.settings;
    return {N_("{0}: {1}, {2}: {3}"), shownName(settings, *axes.rows.row), axes.rows.labels.at(row),
            shownName(settings, *axes.columns.row), axes.columns.labels.at(column)};
}

/// The index of the scene's value on an axis; nothing if the axis does not have it.
std::optional<std::size_t> ownValue(const Session& session, const SweepAxis& axis) {
    const Result<std::string> now = getParam(presentScene(session), axis.path);
    const auto found = now ? std::ranges::find(axis.values, *now) : axis.values.end();
    return found == axis.values.end() ? std::nullopt
                                      : std::optional(static_cast<std::size_t>(found - axis.values.begin()));
}

void take(const Session& session, const Axes& axes, std::size_t row, std::size_t column) {
    Result<Scene> made = sheetScene(presentScene(session), axes.rows.axis, row, axes.columns.axis, column);
    if (!made)
        return act(session, [text = describe(made.error())](Session& told) { say(told, text); });
    submit(
        session, wordsOf(session, axes, row, column), [&](Scene& scene) { scene = *std::move(made); },
        axes.rows.axis.path);
}

/// Handles the mouse on a cell.
void cellButton(const Session& session, const Axes& axes, const SheetPictures::Cell& cell,
                const SheetPlan& plan, std::size_t row, std::size_t column, bool own) {
    const std::string& down = axes.rows.axis.values.at(row);
    const std::string& across = axes.columns.axis.values.at(column);
    const std::string name = fmt::format("{},{}", down, across);
    const bool pressed = ImGui::InvisibleButton(name.c_str(), plan.cell);
    noteItem("sheet cell:" + name);
    if (own)
        noteItem("sheet:own");
    const Sentence words = wordsOf(session, axes, row, column);
    helpTip(cell.problem.empty() ? words : Sentence("{0}\n{1}", words, cell.problem));
    if (ImGui::IsItemHovered() && !own && cell.problem.empty())
        preview(
            session, fmt::format("{}={},{}={}", axes.rows.axis.path, down, axes.columns.axis.path, across),
            words, [&](Scene& scene) {
                if (Result<Scene> made = sheetScene(scene, axes.rows.axis, row, axes.columns.axis, column))
                    scene = *std::move(made);
            });
    if (pressed && !own)
        take(session, axes, row, column);
}

struct CellBox {
    ImVec2 low, high;
    bool own = false;
    bool hovered = false;
};

void drawPictures(const std::vector<CellBox>& boxes, const SheetPictures::Cells& cells,
                  const Pictures& pictures) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    for (const CellBox& box : boxes)
        draw.AddRectFilled(box.low, box.high, color::ground);
    if (pictures.setBlending)
        draw.AddCallback(pictures.setBlending, nullptr);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const auto shown = cells[i].image ? pictures.show(cells[i].image) : view::PictureHandle::None;
        if (shown != view::PictureHandle::None)
            draw.AddImage(textureId(shown), boxes[i].low, boxes[i].high, {0, 1}, {1, 0});
    }
    if (pictures.setBlending)
        draw.AddCallback(pictures.setBlending, &draw);
    const float em = ImGui::GetFontSize();
    const float line = std::max(1.0F, std::floor(em / 8));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const CellBox& box = boxes[i];
        if (!cells[i].problem.empty())
            draw.AddText(box.low + ImVec2(em * 0.3F, em * 0.2F), color::problem, "!");
        if (box.own || box.hovered)
            draw.AddRect(box.low - ImVec2(1, 1), box.high + ImVec2(1, 1),
                         box.own ? color::accent : color::text, 0, 0, box.own ? 2 * line : line);
    }
}

void axisName(ImVec2 at, const Sentence& name, float room, bool own) {
    shrunkText(at, tr(name), ImGui::GetFontSize(), room, own ? color::accent : color::text);
}

void drawNames(const NamedAxis& columns, const SheetPlan& plan, std::optional<std::size_t> own) {
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    for (std::size_t i = 0; i < columns.count(); ++i) {
        const float left = origin.x + plan.head + static_cast<float>(i) * (plan.cell.x + plan.gap);
        const Sentence& name = columns.labels.at(i);
        axisName({left, origin.y}, name, plan.cell.x - ImGui::GetFontSize() * 0.4F, own == i);
        ImGui::SetCursorScreenPos({left, origin.y});
        ImGui::Dummy({plan.cell.x, plan.line});
        helpTip(name);
    }
    ImGui::SetCursorScreenPos({origin.x, origin.y + plan.line});
}

void drawCells(const Session& session, const Axes& axes, const SheetPlan& plan,
               const SheetPictures::Cells& cells, const Pictures& pictures, std::optional<std::size_t> ownRow,
               std::optional<std::size_t> ownColumn) {
    ImGui::BeginChild("cells");
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    std::vector<CellBox> boxes;
    for (std::size_t row = 0; row < axes.rows.count(); ++row) {
        const float top = origin.y + static_cast<float>(row) * (plan.cell.y + plan.gap) + 1;
        const float em = ImGui::GetFontSize();
        axisName({origin.x, top + (plan.cell.y - em) / 2}, axes.rows.labels.at(row), plan.head - em * 0.3F,
                 ownRow == row);
        for (std::size_t column = 0; column < axes.columns.count(); ++column) {
            const ImVec2 low(origin.x + plan.head + static_cast<float>(column) * (plan.cell.x + plan.gap),
                             top);
            ImGui::SetCursorScreenPos(low);
            const bool own = ownRow == row && ownColumn == column;
            cellButton(session, axes, cells[row * axes.columns.count() + column], plan, row, column, own);
            boxes.push_back({low, low + plan.cell, own, ImGui::IsItemHovered()});
        }
    }
    drawPictures(boxes, cells, pictures);
    ImGui::EndChild();
}

/// What the user can do, or what is not shown.
void sentence(const Axes& axes) {
    for (const NamedAxis* axis : {&axes.rows, &axes.columns}) {
        if (axis->all <= axis->count())
            continue;
        const Sentence words(
            N_("{0} has {1} values, and the first {2} are shown. Type the values to show; a file has all."),
            axis->row->label, axis->all, axis->count());
        if (fittedText(words, color::problem))
            helpTip(words);
        return noteItem("sheet:too many");
    }
    constexpr const char* words = N_("Point at a picture to enlarge it, click to apply its values.");
    const Sentence more =
        N_("Every pair of values, drawn by the reference at this small size, so it minifies more "
           "than the view.");
    helpTip(fittedText(words, color::dim) ? Sentence("{0}\n{1}", words, more) : more);
}

SheetPictures::Question questionOf(const Session& session, const Axes& axes, const SheetPlan& plan) {
    const ImVec2 density = ImGui::GetIO().DisplayFramebufferScale;
    const auto pixels = [](float length, float scale) {
        return std::max(1, static_cast<int>(std::lround(length * scale)));
    };
    // The pictures do not depend on the scene's values on both axes.
    Result<Scene> base = sheetScene(presentScene(session), axes.rows.axis, 0, axes.columns.axis, 0);
    return {{base ? *std::move(base) : presentScene(session), session.document.images,
             session.look.playback.time, pixels(plan.cell.x, density.x), pixels(plan.cell.y, density.y),
             session.view.anisotropy, session.view.rho},
            axes.rows.axis,
            axes.columns.axis};
}

} // namespace

void drawSheet(const Session& session, SheetState& state, const Pictures& pictures) {
    Result<std::array<SweepAxis, 2>> swept = sweptAxes(session);
    std::optional<Axes> axes;
    if (swept)
        axes =
            Axes{namedAxis(session, std::move(swept->front())), namedAxis(session, std::move(swept->back()))};
    drawSheetControls(session, state, axesOf(session), [&] {
        if (axes)
            sentence(*axes);
        else
            sheetProblem(describe(swept.error()));
    });
    if (!axes)
        return;
    const view::Size view = pictures.frames.front().frame.size;
    const float aspect =
        static_cast<float>(std::max(1, view.width)) / static_cast<float>(std::max(1, view.height));
    const SheetPlan plan = planSheet(axes->rows, axes->columns, aspect);
    ask(session, [question = questionOf(session, *axes, plan)](Session& changed) {
        return workers(changed).sheet->ask(question);
    });
    const SheetPictures::Cells cells = workers(session).sheet->cells(axes->rows.axis, axes->columns.axis);
    const std::optional<std::size_t> ownRow = ownValue(session, axes->rows.axis);
    const std::optional<std::size_t> ownColumn = ownValue(session, axes->columns.axis);
    drawNames(axes->columns, plan, ownColumn);
    drawCells(session, *axes, plan, cells, pictures, ownRow, ownColumn);
}

} // namespace texplorer::ui
