#include "app/ui/details/explain_tab.h"

#include "app/ui/widgets/button_width.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/theme.h"
#include "core/reference/explain/explanation_steps.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace texplorer::ui {
namespace {

using reference::Ink;
using reference::PixelBytes;
using reference::Step;
using reference::StepRow;

ImU32 tintOf(Ink ink) {
    switch (ink) {
    case Ink::S:
        return color::s;
    case Ink::T:
        return color::t;
    case Ink::R:
        return color::r;
    case Ink::Q:
        return color::q;
    case Ink::Dim:
        return color::dim;
    case Ink::Good:
        return color::t;
    case Ink::Bad:
        return color::problem;
    case Ink::Plain:
        break;
    }
    return color::text;
}

void text(const std::string& words, ImU32 tint = color::text) {
    ImGui::PushStyleColor(ImGuiCol_Text, tint);
    ImGui::TextUnformatted(words.c_str());
    ImGui::PopStyleColor();
}

/// Text beside what stands in the line already: what has no room goes on below its beginning, or, where that
/// would be narrow, on lines of its own.
void hangingText(const std::string& words, ImU32 tint) {
    const float em = ImGui::GetFontSize();
    const float right = ImGui::GetWindowContentRegionMax().x + ImGui::GetScrollX();
    const float room = right - ImGui::GetCursorPosX();
    const float width = ImGui::CalcTextSize(words.c_str()).x;
    if (room < width && room < 14 * em) {
        ImGui::NewLine();
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetTreeNodeToLabelSpacing());
    }
    ImGui::PushTextWrapPos(right);
    text(words, tint);
    ImGui::PopTextWrapPos();
}

/// A square of the colour, as opaque as a pixel is.
void swatch(glm::vec4 color) {
    const float side = ImGui::GetTextLineHeight() * 0.8F;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float top = at.y + ImGui::GetTextLineHeight() * 0.1F;
    const glm::vec4 c = glm::clamp(color, 0.0F, 1.0F);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled({at.x, top}, {at.x + side, top + side},
                       ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, 1}));
    draw.AddRect({at.x, top}, {at.x + side, top + side}, color::outline);
    ImGui::Dummy({side, ImGui::GetTextLineHeight()});
}

/// What a table of rows with the same number of cells takes: more than the panel has is reached by scrolling.
float tableWidth(std::span<const StepRow> rows, float padding) {
    std::vector<float> columns(rows.front().cells.size() + 1);
    const auto widen = [](float& column, const std::string& words, float more) {
        column = std::max(column, ImGui::CalcTextSize(words.c_str()).x + more);
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
        width += std::ceil(column) + 2 * padding;
    return width;
}

/// Rows with the same number of cells share their columns.
void drawRows(const std::vector<StepRow>& rows) {
    for (std::size_t first = 0; first < rows.size();) {
        const std::size_t cells = rows[first].cells.size();
        std::size_t last = first;
        while (last < rows.size() && rows[last].cells.size() == cells)
            ++last;
        if (cells == 0) {
            for (; first < last; ++first) {
                ImGui::PushStyleColor(ImGuiCol_Text, tintOf(rows[first].ink));
                ImGui::TextWrapped("%s", rows[first].label.c_str());
                ImGui::PopStyleColor();
            }
            continue;
        }
        ImGui::PushID(static_cast<int>(first));
        const float padding = std::floor(ImGui::GetFontSize() * 0.18F);
        ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {padding, ImGui::GetStyle().CellPadding.y});
        const int columns = static_cast<int>(cells) + 1;
        const float width = tableWidth(std::span(rows).subspan(first, last - first), padding);
        const bool open = ImGui::BeginTable(
            "rows", columns, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoSavedSettings, {width, 0});
        if (open) {
            for (; first < last; ++first) {
                const StepRow& row = rows[first];
                ImGui::TableNextRow();
                ImGui::TableNextColumn();
                if (row.swatch) {
                    swatch(*row.swatch);
                    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
                }
                text(row.label, row.ink == Ink::Plain ? color::dim : tintOf(row.ink));
                for (const reference::StepCell& cell : row.cells) {
                    ImGui::TableNextColumn();
                    text(cell.text, tintOf(cell.ink));
                }
            }
            ImGui::EndTable();
        }
        ImGui::PopStyleVar();
        ImGui::PopID();
        first = last;
    }
}

void drawStep(const Step& step, bool first, bool severalUnits) {
    const std::string title =
        step.unit < 0 || !severalUnits ? step.title : fmt::format("{}, unit {}", step.title, step.unit);
    ImGui::PushID(static_cast<int>(step.kind) * 8 + step.unit);
    // The texels are what one wants to see first.
    ImGui::SetNextItemOpen(first && step.kind == reference::StepKind::Texels, ImGuiCond_FirstUseEver);
    const bool hasRows = !step.rows.empty();
    const bool open =
        ImGui::TreeNodeEx("step", ImGuiTreeNodeFlags_SpanAvailWidth | (hasRows ? 0 : ImGuiTreeNodeFlags_Leaf),
                          "%s", title.c_str());
    noteItem("explain:" + title);
    ImGui::SameLine();
    if (step.swatch) {
        swatch(*step.swatch);
        ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    }
    const bool idle = step.kind == reference::StepKind::IdleUnit;
    hangingText(step.summary, idle ? color::problem : color::dim);
    noteItem("explain:summary of " + title);
    if (open) {
        ImGui::TreePop(); // before the rows: they need the width
        drawRows(step.rows);
        noteItem("explain:rows of " + title);
    }
    ImGui::PopID();
}

void drawFragment(const reference::FragmentSteps& fragment, const reference::FragmentExplanation& explained,
                  std::size_t index, bool seen) {
    ImGui::PushID(seen ? -1 : static_cast<int>(index));
    ImGui::SetNextItemOpen(seen, ImGuiCond_FirstUseEver);
    const std::string title = fragment.title + (fragment.drawn ? "" : ": " + fragment.outcome);
    ImGui::PushStyleColor(ImGuiCol_Text, fragment.drawn ? color::text : color::dim);
    const float room = ImGui::GetWindowContentRegionMax().x + ImGui::GetScrollX() - ImGui::GetCursorPosX() -
                       ImGui::GetTreeNodeToLabelSpacing() - ImGui::GetFontSize() * 0.5F;
    const bool open = ImGui::CollapsingHeader((fitted(title, room) + "###fragment").c_str());
    if (fitted(title, room) != title)
        helpTip(title);
    ImGui::PopStyleColor();
    noteItem(fmt::format("explain:fragment {}", index));
    for (const Step& step : fragment.steps) {
        if (open)
            drawStep(step, seen, explained.units.size() + explained.idle.size() > 1);
    }
    ImGui::PopID();
}

glm::vec4 colorOf(const PixelBytes& bytes) {
    return glm::vec4(bytes[0], bytes[1], bytes[2], bytes[3]) / 255.0F;
}

reference::StepCell differenceFrom(const PixelBytes& expected, const PixelBytes& found) {
    int most = 0;
    for (std::size_t i = 0; i < expected.size(); ++i)
        most = std::max(most, std::abs(int{expected[i]} - int{found[i]}));
    if (most == 0)
        return {"the same", Ink::Dim};
    return {fmt::format("off by {}", most), Ink::Bad};
}

void drawHead(Session& session, const Pictures& pictures, const reference::Explanation& explanation) {
    const auto& [x, y] = explanation.pixel;
    text(fmt::format("Pixel {},{} from the upper left", x,
                     explanation.height - 1 - y), // as texshot probe --at counts
         color::probed);
    noteItem("explain:pixel");
    helpTip(fmt::format(
        "In OpenGL's window coordinates, which begin at the lower left, {},{}. Hold E over the picture, or "
        "click there, for another pixel.",
        x, y));
    const float width = buttonWidth("Clear");
    ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
    if (ImGui::SmallButton("Clear")) {
        session.window.explaining.pixel.reset();
        clearTexel(session);
    }
    noteItem("explain:clear");
    std::vector<StepRow> rows;
    const auto add = [&](RendererKind renderer, const PixelBytes& bytes, reference::StepCell remark) {
        StepRow& row = rows.emplace_back();
        row.label = rowOf(renderer).label;
        row.swatch = colorOf(bytes);
        row.cells = {{reference::bytesText(bytes), Ink::Plain}, std::move(remark)};
    };
    add(RendererKind::Reference, explanation.bytes, {});
    const bool comparable = explainsThePicture(session);
    for (const ViewFrame& view : pictures.frames) {
        if (!view.image || !view.whole || view.image->width != explanation.width ||
            view.image->height != explanation.height || view.image->format != PixelFormat::Rgba8)
            continue;
        PixelBytes bytes{};
        for (std::size_t i = 0; i < bytes.size(); ++i)
            bytes[i] = std::to_integer<std::uint8_t>(view.image->at(x, y)[i]);
        // While the scene moves the pictures are ahead of the answer: they have nothing in common.
        add(view.renderer, bytes,
            comparable ? differenceFrom(explanation.bytes, bytes) : reference::StepCell{});
        if (comparable)
            noteItem("explain:compared " + rows.back().label);
    }
    drawRows(rows);
}

void drawTexelLine(Session& session) {
    const Explaining& asked = session.window.explaining;
    if (!asked.texel)
        return;
    const auto& [level, index] = asked.texel->texel;
    std::string words = fmt::format("Texel {}, {} of level {}: ", index.x, index.y, level);
    const bool answered =
        asked.answer && asked.answer->contributions && asked.answer->request.texel == asked.texel;
    if (!answered) {
        words += "looking for its pixels…";
    } else if (const auto& found = *asked.answer->contributions; !found) {
        words += describe(found.error());
    } else {
        const auto count = std::ranges::count_if(found->weights, [](float weight) { return weight > 0; });
        words += count == 0   ? "no visible pixel reads it"
                 : count == 1 ? "one pixel reads it"
                              : fmt::format("{} pixels read it", count);
    }
    const bool cleared = ImGui::SmallButton("✕##texel");
    noteItem("explain:clear texel");
    helpTip("Lets go of this texel (Escape)");
    ImGui::SameLine();
    hangingText(words, color::chosen);
    noteItem("explain:texel");
    if (cleared)
        clearTexel(session);
}

} // namespace

void drawExplainTab(Session& session, const Pictures& pictures) {
    session.window.explaining.isOpen = true;
    ImGui::BeginChild("explain", {0, 0}, false, ImGuiWindowFlags_HorizontalScrollbar);
    const auto& answer = session.window.explaining.answer;
    const reference::Explanation* explanation = explanationOf(session);
    if (!session.window.explaining.pixel) {
        ImGui::TextWrapped(
            "Why has this pixel that colour? Click one in the view, or hold E over it: here is "
            "everything that OpenGL computes on the way, in its order.");
        noteItem("explain:none");
        drawTexelLine(session);
    } else if (!explanation) {
        if (answer && answer->explanation && !*answer->explanation)
            ImGui::TextWrapped("%s", describe(answer->explanation->error()).c_str());
        else
            ImGui::TextDisabled("The texture's levels are being made…");
        noteItem("explain:waiting");
    } else {
        drawHead(session, pictures, *explanation);
        drawTexelLine(session);
        const auto fragments = reference::stepsOf(*explanation);
        if (fragments.empty())
            ImGui::TextWrapped("Nothing covers it: it shows the background.");
        const reference::FragmentExplanation* seen = explanation->seen();
        // First what one sees, then the rest in the order of drawing.
        for (std::size_t i = 0; i < fragments.size(); ++i) {
            if (seen == &explanation->fragments[i])
                drawFragment(fragments[i], explanation->fragments[i], i, true);
        }
        for (std::size_t i = 0; i < fragments.size(); ++i) {
            if (seen != &explanation->fragments[i])
                drawFragment(fragments[i], explanation->fragments[i], i, false);
        }
    }
    ImGui::EndChild();
}

} // namespace texplorer::ui
