#include "app/ui/figures/environment_cell.h"

#include "app/ui/language/translate.h"
#include "app/ui/widgets/board.h"
#include "app/ui/widgets/points.h"
#include "app/ui/widgets/theme.h"

#include <fmt/core.h>
#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <vector>

namespace texplorer::ui {
namespace {

using reference::EnvironmentEquations;
using reference::tableFormats;
using reference::tableModes;

// The size of letters, relative to those of the window.
constexpr float smallText = 0.85F;
constexpr float smallerText = 0.75F;
constexpr float minText = 0.72F;
constexpr float lineHeight = 1.02F;

float cellPad() {
    return std::max(1.0F, std::floor(ImGui::GetFontSize() * 0.2F));
}

float widthOf(const std::string& words, float size) {
    return ImGui::GetFont()->CalcTextSizeA(size, FLT_MAX, 0, words.c_str()).x;
}

/// The two equations of a cell as printed, computed once.
struct PrintedCell {
    std::string color;
    std::string alpha;
    bool undefined = false;
};
const PrintedCell& printedCell(std::size_t column, std::size_t row) {
    using Row = std::array<PrintedCell, tableModes.size()>;
    static const std::array<Row, tableFormats.size()> printed = [] {
        std::array<Row, tableFormats.size()> all;
        for (std::size_t y = 0; y < tableFormats.size(); ++y) {
            for (std::size_t x = 0; x < tableModes.size(); ++x) {
                const EnvironmentEquations equations =
                    reference::equationsOf(tableModes.at(x), tableFormats.at(y), {});
                all.at(y).at(x) = {reference::printedEquation(equations.color.symbols),
                                   reference::printedEquation(equations.alpha.symbols), equations.undefined};
            }
        }
        return all;
    }();
    return printed.at(row).at(column);
}

std::string withoutBlanks(std::string equation) {
    std::erase(equation, ' ');
    return equation;
}

/// The equation in a plan's form; if that is tight, two lines for a sum of products.
std::vector<std::string> equationLines(const CellPlan& plan, const std::string& equation) {
    const std::size_t sign = equation.find(" + ");
    if (plan.tight && sign != std::string::npos && equation.find('(') != std::string::npos)
        return {withoutBlanks(equation.substr(0, sign)), withoutBlanks(equation.substr(sign))};
    return {plan.tight || plan.dense ? withoutBlanks(equation) : equation};
}

constexpr const char* longest = N_("Cp (1 − Cs) + Cc Cs");
constexpr const char* longestDense = N_("Cp(1−Cs)+CcCs");
constexpr const char* longestTight = N_("Cp(1−Cs)");
constexpr const char* longestBytes = "255 255 255 255";

/// The number of text lines in a plan.
float linesOf(const CellPlan& plan) {
    const float symbols = plan.symbols ? (plan.tight ? 4.0F : 2.0F) : 0;
    const float numbers = plan.numbers ? (plan.tight ? 3.0F : 1.0F) : 0;
    return symbols + numbers;
}

float textWidth(const CellPlan& plan) {
    const char* widest = plan.tight ? longestTight : plan.dense ? longestDense : longest;
    const float symbols = plan.symbols ? widthOf(widest, plan.text) : 0;
    const float patch = plan.tight ? 0 : plan.text * 1.2F + cellPad();
    const float numbers =
        plan.numbers ? widthOf(plan.tight ? "255 255" : longestBytes, plan.text) + patch : 0;
    return std::max(symbols, numbers);
}

class CellWriter {
public:
    CellWriter(ImVec2 at, float size)
        : at_(at)
        , size_(size) {}

    /// `indent`: space on its left.
    void line(const std::string& words, ImU32 ink, float indent = 0) {
        ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), size_, rounded(at_ + ImVec2(indent, 0)), ink,
                                            words.c_str());
        skipLine();
    }
    void patch(float width, glm::vec4 color) const {
        const ImVec2 low = rounded(at_ + ImVec2(0, size_ * 0.1F));
        colorPatch(low, low + ImVec2(width, std::round(size_ * 0.9F)), color);
    }
    void skipLine() { at_.y += size_ * lineHeight; }

private:
    ImVec2 at_;
    float size_;
};

void writeSymbols(CellWriter& writer, const CellPlan& plan, const PrintedCell& printed) {
    for (const std::string& line : equationLines(plan, printed.color))
        writer.line(line, color::text);
    for (const std::string& line : equationLines(plan, printed.alpha))
        writer.line(line, color::dim);
}

void writeNumbers(CellWriter& writer, const CellPlan& plan, glm::vec4 color) {
    const std::string bytes = bytesText(color);
    if (!plan.tight) {
        writer.patch(plan.text * 1.2F, color);
        return writer.line(bytes, color::text, plan.text * 1.2F + cellPad());
    }
    const std::size_t middle = bytes.find(' ', bytes.find(' ') + 1);
    writer.patch(textWidth(plan), color);
    writer.skipLine();
    writer.line(bytes.substr(0, middle), color::text);
    writer.line(bytes.substr(middle + 1), color::text);
}

void drawPicture(const CellPlan& plan, ImVec2 low, std::size_t column, std::size_t row,
                 const CellPictures& pictures) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float larger = std::max({pictures.width, pictures.height, 1.0F});
    const ImVec2 size(std::max(1.0F, std::round(plan.side * pictures.width / larger)),
                      std::max(1.0F, std::round(plan.side * pictures.height / larger)));
    const ImVec2 at = rounded(low + (ImVec2(plan.side, plan.side) - size) * 0.5F);
    const ImVec2 end = at + size;
    drawBoard(draw, at, end, std::max(2.0F, std::floor(plan.side / 6)));
    if (pictures.all == view::PictureHandle::None)
        return;
    // Half a texel less, so that neighbours do not show at the edges.
    const auto columns = static_cast<float>(tableModes.size());
    const auto rows = static_cast<float>(tableFormats.size());
    const float halfU = 0.5F / (pictures.width * columns);
    const float halfV = 0.5F / (pictures.height * rows);
    const float left = static_cast<float>(column) / columns;
    const float top = 1 - static_cast<float>(row) / rows;
    draw.AddImage(textureId(pictures.all), at, end, {left + halfU, top - halfV},
                  {left + 1 / columns - halfU, top - 1 / rows + halfV});
    draw.AddRect(at, end, ImGui::GetColorU32(ImGuiCol_Border));
}

/// A plan with one of the two texts, or both.
CellPlan planTexts(ImVec2 size, CellText wanted) {
    const float em = ImGui::GetFontSize();
    const float pad = cellPad();
    const ImVec2 room(size.x - 2 * pad, size.y - 2);
    enum class Shape { Loose, Dense, Tight };
    const auto planned = [&](float text, bool both, Shape shape) {
        CellPlan plan{.size = size,
                      .text = em * text,
                      .dense = shape == Shape::Dense,
                      .tight = shape == Shape::Tight,
                      .symbols = both || wanted == CellText::Symbols,
                      .numbers = both || wanted == CellText::Numbers};
        // The space next to the text or above it is for the picture.
        const float beside = std::min(room.y, room.x - textWidth(plan) - 2 * pad);
        const float above = std::min(room.x, room.y - linesOf(plan) * plan.text * lineHeight - pad);
        plan.above = above > beside;
        plan.side = std::floor(std::max(above, beside));
        if (plan.side < em)
            plan.side = 0;
        return plan;
    };
    // From the best plan to one that fits even in a narrow panel.
    const std::array plans{
        planned(smallText, true, Shape::Loose),    planned(smallText, false, Shape::Loose),
        planned(smallerText, false, Shape::Loose), planned(smallerText, false, Shape::Dense),
        planned(minText, true, Shape::Tight),      planned(minText, false, Shape::Tight)};
    const auto fits = [&](const CellPlan& plan) {
        return linesOf(plan) * plan.text * lineHeight <= room.y && textWidth(plan) <= room.x;
    };
    const auto pictured =
        std::ranges::find_if(plans, [&](const CellPlan& plan) { return fits(plan) && plan.side > 0; });
    if (pictured != plans.end())
        return *pictured;
    const auto written = std::ranges::find_if(plans, fits);
    return written == plans.end() ? plans.back() : *written;
}

} // namespace

std::string bytesText(glm::vec4 color) {
    const auto byte = [&](int i) { return std::lround(std::clamp(color[i], 0.0F, 1.0F) * 255); };
    return fmt::format("{} {} {} {}", byte(0), byte(1), byte(2), byte(3));
}

void colorPatch(ImVec2 low, ImVec2 high, glm::vec4 value) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const glm::vec4 c = glm::clamp(value, 0.0F, 1.0F);
    const float middle = std::round((low.x + high.x) / 2);
    const auto ink = [&](float alpha) { return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, alpha}); };
    drawBoard(draw, {middle, low.y}, high, std::max(2.0F, std::floor((high.y - low.y) / 3)));
    draw.AddRectFilled(low, {middle, high.y}, ink(1));
    draw.AddRectFilled({middle, low.y}, high, ink(c.a));
    draw.AddRect(low, high, color::outline);
}

float minCellHeight(float width, CellText wanted) {
    const float em = ImGui::GetFontSize();
    CellPlan plan{.text = em * smallerText,
                  .dense = true,
                  .symbols = wanted != CellText::Numbers,
                  .numbers = wanted == CellText::Numbers};
    float lines = 2; // as in the row's name
    if (wanted != CellText::Pictures && textWidth(plan) > width - 2 * cellPad()) {
        plan.text = em * minText;
        plan.tight = true;
        lines = linesOf(plan);
    }
    return std::ceil(plan.text * lineHeight * lines + 2);
}

CellPlan planCells(ImVec2 size, CellText wanted) {
    const CellPlan symbols = planTexts(size, CellText::Symbols);
    const bool apart = symbols.side == 0;
    CellPlan plan = wanted == CellText::Numbers ? planTexts(size, wanted) : symbols;
    plan.apart = apart;
    if (wanted != CellText::Pictures || !apart)
        return plan;
    plan.symbols = plan.numbers = false;
    plan.above = true;
    plan.side = std::floor(std::max(1.0F, std::min(size.x - 2 * cellPad(), size.y - 2)));
    return plan;
}

void drawEnvironmentCell(const CellPlan& plan, ImVec2 low, std::size_t column, std::size_t row,
                         const reference::TableColors& colors, const CellPictures& pictures) {
    const float pad = cellPad();
    const PrintedCell& printed = printedCell(column, row);
    ImVec2 at(low.x + pad, low.y + 1);
    if (printed.undefined) {
        const std::string word = tr("undefined");
        const float width = std::min(plan.size.x, widthOf(word, plan.text));
        CellWriter centred(low + (plan.size - ImVec2(width, plan.text)) * 0.5F, plan.text);
        return centred.line(word, color::dim);
    }
    if (plan.side > 0) {
        const ImVec2 free(plan.size.x - 2 * pad - plan.side, plan.size.y - 2 - plan.side);
        drawPicture(plan, plan.above ? ImVec2(at.x + free.x / 2, at.y) : ImVec2(at.x, at.y + free.y / 2),
                    column, row, pictures);
        (plan.above ? at.y : at.x) += plan.side + (plan.above ? pad : 2 * pad);
    }
    const float height = linesOf(plan) * plan.text * lineHeight;
    at.y += std::max(0.0F, std::floor((low.y + plan.size.y - 1 - at.y - height) / 2));
    CellWriter writer(at, plan.text);
    if (plan.symbols)
        writeSymbols(writer, plan, printed);
    if (plan.numbers) {
        const BaseFormat format = tableFormats.at(row);
        const auto inputs = reference::inputsOf(format, colors);
        writeNumbers(writer, plan, reference::evaluate(tableModes.at(column), format, inputs).color);
    }
}

} // namespace texplorer::ui
