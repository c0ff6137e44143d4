#include "app/ui/language/translate.h"
#include "app/ui/view/pane_drawing.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/param_widgets.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <span>
#include <string>

namespace texplorer::ui {

namespace {

constexpr int worstFactor = 16; // large enough to see the pixel and its neighbours

struct ArrangementRow {
    Arrangement arrangement;
    const char* label;
    const char* help;
};
constexpr std::array arrangementRows{
    ArrangementRow{Arrangement::Split, N_("Split"), N_("Two renderers in one picture. Drag the seam.")},
    ArrangementRow{Arrangement::Grid, N_("Side by side"),
                   N_("All renderers, and the difference of the two selected ones.")},
};

/// The compared renderers, or the renderer that draws both sides.
std::span<const RendererKind> comparedOf(const ViewSettings& settings) {
    if (comparesRenderers(settings))
        return settings.compared;
    return {&settings.renderer, 1};
}

/// "0.05", "12.3", "100": at most three digits before the decimal point, and never 0 for a positive value.
std::string rounded(double value, int decimals) {
    const double min = std::pow(10.0, -decimals);
    if (value > 0 && value < min)
        return fmt::format("< {:.{}f}", min, decimals);
    for (double limit = 10; value >= limit && decimals > 0; limit *= 10)
        --decimals;
    return value > 0 ? fmt::format("{:.{}f}", value, decimals) : "0";
}

/// Puts widgets in a row and starts another row if the next widget does not fit.
class Flow {
public:
    explicit Flow(const Rect& rect)
        : right_(static_cast<float>(rect.right()) - ImGui::GetStyle().WindowPadding.x)
        , left_(static_cast<float>(rect.x) + ImGui::GetStyle().WindowPadding.x)
        , x_(left_)
        , y_(static_cast<float>(rect.y) + ImGui::GetStyle().FramePadding.y) {}

    void place(float width, float gap) {
        if (x_ > left_ && x_ + gap + width > right_) {
            x_ = left_;
            ++lines_;
            y_ += ImGui::GetFrameHeight() + ImGui::GetStyle().FramePadding.y;
        } else if (x_ > left_) {
            x_ += gap;
        }
        x_ += width;
    }
    [[nodiscard]] int lines() const { return lines_; }
    /// The same, then moves the cursor to the next widget's place.
    void put(float width, float gap) {
        place(width, gap);
        ImGui::SetCursorScreenPos({x_ - width, y_});
    }
    /// A label with the height of a widget.
    void text(const Sentence& words, ImU32 tint, float gap) {
        const std::string shown = tr(words);
        put(ImGui::CalcTextSize(shown.c_str()).x, gap);
        ImGui::AlignTextToFramePadding();
        plainText(shown, tint);
    }

private:
    float right_;
    float left_;
    float x_;
    float y_;
    int lines_ = 1;
};

/// Shows the part of the pictures around a pixel.
void showPixel(const Session& session, glm::ivec2 pixel, view::Size picture) {
    const glm::vec2 centre = (glm::vec2(pixel) + 0.5F) /
                             glm::vec2(static_cast<float>(picture.width), static_cast<float>(picture.height));
    act(session, [centre](Session& changed) { changed.view.zoom = {worstFactor, centre}; });
}

constexpr const char* perByte = "/255";

/// "0.17 % over [2]/255": the share of pixels that differ by more than the tolerance, which can be dragged.
void toleranceField(const Session& session, Flow& flow, const Difference* difference, float gap) {
    const float narrow = ImGui::GetStyle().ItemInnerSpacing.x / 2;
    const float field = ImGui::CalcTextSize("255").x + 2 * ImGui::GetStyle().FramePadding.x;
    const bool hasShare = difference && difference->max > 0;
    const std::string words =
        tr(hasShare ? Sentence("{0} % over", ProperName{rounded(100 * difference->shareOver(), 2)})
                    : "Tolerance");
    flow.put(ImGui::CalcTextSize(words.c_str()).x + field + ImGui::CalcTextSize(perByte).x + 2 * narrow, gap);
    ImGui::AlignTextToFramePadding();
    plainText(words, hasShare ? color::text : color::dim);
    if (hasShare) {
        item("share over",
             "The share of pixels that differ by more than this tolerance in red, green or blue");
    }
    ImGui::SameLine(0, narrow);
    ImGui::SetNextItemWidth(field);
    int tolerance = session.view.tolerance;
    if (dragInt("##tolerance", tolerance, 0.1F, 0, ViewSettings::maxTolerance))
        act(session, [tolerance](Session& changed) { changed.view.tolerance = tolerance; });
    item("tolerance", "Differences up to this value are ignored. Drag it, or double-click to type a number.");
    ImGui::SameLine(0, narrow);
    ImGui::TextUnformatted(perByte);
}

/// A button that goes to the worst pixel, with the ring that marks it in the pictures.
void worstButton(const Session& session, Flow& flow, const Difference& difference, view::Size picture,
                 float gap) {
    const float em = ImGui::GetFontSize();
    const bool ringed = isRinged(difference);
    const Sentence words("max {0}/255", difference.max);
    const float sign = ringed ? em * 1.2F : 0;
    const float width = buttonWidth(words) + sign;
    flow.put(width, gap);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    if (ImGui::Button("##worst", {width, 0}))
        showPixel(session, difference.worst, picture);
    noteItem("worst");
    const int fromTop = picture.height - 1 - difference.worst.y;
    helpTip(ringed ? Sentence("The largest difference, at pixel {0},{1} from the upper left (ringed). "
                              "Click to enlarge it; Ctrl + wheel zooms out.",
                              difference.worst.x, fromTop)
                   : Sentence("The largest difference, at pixel {0},{1} from the upper left, is within "
                              "the tolerance. Click to enlarge it; Ctrl + wheel zooms out.",
                              difference.worst.x, fromTop));
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    draw.AddText({low.x + padding.x + sign, low.y + padding.y}, color::text, tr(words).c_str());
    if (!ringed)
        return;
    draw.AddCircle({low.x + padding.x + em * 0.4F, low.y + ImGui::GetFrameHeight() / 2}, em * 0.36F,
                   color::problem, 0, 1.5F);
    noteItem("ring");
}

void numbers(const Session& session, Flow& flow, const Difference& difference, view::Size picture,
             float gap) {
    if (difference.max == 0) {
        flow.text(N_("equal in every pixel"), color::text, gap);
        noteItem("equal");
        return helpTip("Red, green and blue are the same everywhere.");
    }
    flow.text(Sentence("mean {0}/255", ProperName{rounded(difference.mean, 3)}), color::text, gap);
    item("mean difference", "The mean over all components of all pixels");
    worstButton(session, flow, difference, picture, gap);
}

/// The number of lines for the longest possible numbers, so that the strip and the pictures keep their
/// heights.
int linesNeeded(const ViewSettings& settings, const Rect& strip, float gap, float narrow) {
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    Flow flow(strip);
    if (!comparesRenderers(settings))
        flow.place(textWidth(N_("A and now")), narrow);
    for (const ArrangementRow& row : arrangementRows) {
        if (comparesRenderers(settings))
            flow.place(buttonWidth(row.label), narrow);
    }
    const float field = ImGui::CalcTextSize("255").x + 2 * padding.x;
    flow.place(std::max(textWidth(Sentence("{0} % over", ProperName{"99.99"})), textWidth("Tolerance")) +
                   field + ImGui::CalcTextSize(perByte).x + 2 * narrow,
               gap);
    flow.place(textWidth(Sentence("mean {0}/255", ProperName{"0.999"})), gap);
    flow.place(textWidth(Sentence("max {0}/255", 255)) + 2 * padding.x + ImGui::GetFontSize() * 1.2F, gap);
    return flow.lines();
}

} // namespace

void drawComparisonStrip(const Session& session, const Pictures& pictures, const Layout& layout) {
    const ViewSettings& settings = session.view;
    if (!isComparing(settings))
        return;
    const float gap = ImGui::GetFontSize() * 0.9F;
    const float narrow = ImGui::GetStyle().ItemInnerSpacing.x / 2;
    if (const int lines = linesNeeded(settings, layout.strip, gap, narrow); lines != settings.stripLines)
        act(session, [lines](Session& changed) { changed.view.stripLines = lines; });
    Flow flow(layout.strip);
    if (!comparesRenderers(settings)) {
        flow.text(N_("A and now"), color::dim, narrow);
        item("A and now",
             "Drag the seam. A is on the left, the present scene on the right, with the same renderer "
             "and camera.");
    }
    for (const ArrangementRow& row : arrangementRows) {
        if (!comparesRenderers(settings))
            break;
        flow.put(buttonWidth(row.label), narrow);
        if (flatButton(label(row.label), settings.arrangement == row.arrangement))
            act(session, [&row](Session& changed) {
                changed.view.arrangement = changed.view.comparing = row.arrangement;
            });
        item(std::string("arrangement:") + row.label, row.help);
    }
    toleranceField(session, flow, pictures.difference ? &pictures.difference->numbers : nullptr, gap);
    if (pictures.difference)
        numbers(session, flow, pictures.difference->numbers, pictures.frames.front().frame.size, gap);
    else
        flow.text(isDrawing(pictures, comparedOf(settings)) ? N_("Drawing…")
                                                            : N_("no numbers: a picture is missing"),
                  color::dim, gap);
}

} // namespace texplorer::ui
