#include "app/ui/pane_drawing.h"
#include "app/ui/panels.h"
#include "app/ui/param_widgets.h"
#include "app/ui/theme.h"

#include <array>
#include <cstdio>
#include <string>

namespace texplorer::ui {

namespace {

constexpr int worstFactor = 16; // so large that one sees the pixel and its neighbours

struct ArrangementRow {
    Arrangement arrangement;
    const char* label;
    const char* help;
};
constexpr std::array arrangementRows{
    ArrangementRow{Arrangement::Split, "Split", "Two renderers across one picture. Drag the seam."},
    ArrangementRow{Arrangement::Grid, "Side by side",
                   "Every renderer, and the difference of the two that are chosen."},
};

std::string withDecimals(double value, int decimals) {
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
    return text.data();
}

/// "0.05 %": never nothing where there is something.
std::string asPercentage(double share) {
    constexpr double least = 0.0001;
    if (share > 0 && share < least)
        return "< 0.01 %";
    return share > 0 ? withDecimals(100 * share, 2) + " %" : "0 %";
}

/// Puts widgets in a row, and begins another one where the next has no room.
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
            y_ += ImGui::GetFrameHeight() + ImGui::GetStyle().FramePadding.y;
        } else if (x_ > left_) {
            x_ += gap;
        }
        ImGui::SetCursorScreenPos({x_, y_});
        x_ += width;
    }
    /// A label, as high as a widget.
    void text(const std::string& words, ImU32 tint, float gap) {
        place(ImGui::CalcTextSize(words.c_str()).x, gap);
        ImGui::AlignTextToFramePadding();
        ImGui::PushStyleColor(ImGuiCol_Text, tint);
        ImGui::TextUnformatted(words.c_str());
        ImGui::PopStyleColor();
    }

private:
    float right_;
    float left_;
    float x_;
    float y_;
};

float buttonWidth(const char* label) {
    return ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
}

/// The part of the pictures around a pixel.
void showPixel(Views& views, glm::ivec2 pixel, render::Size picture) {
    views.zoom.factor = worstFactor;
    views.zoom.centre = (glm::vec2(pixel) + 0.5F) /
                        glm::vec2(static_cast<float>(picture.width), static_cast<float>(picture.height));
}

void numbers(Session& session, Flow& flow, const Difference& difference, render::Size picture, float gap) {
    const auto number = [&](const std::string& text, const char* name, const char* help) {
        flow.text(text, color::text, gap);
        noteItem(session, name);
        helpTip(help);
    };
    if (difference.max == 0)
        return number("equal in every pixel", "equal", "Red, green and blue are the same everywhere.");
    number(asPercentage(difference.shareOver()) + " over", "share over",
           "The pixels that differ by more than the tolerance in red, green or blue");
    number("mean " + withDecimals(difference.mean, 3), "mean difference",
           "Of all components of all pixels, in 255ths");
    const std::string worst = "max " + std::to_string(difference.max);
    flow.place(buttonWidth(worst.c_str()), gap);
    if (ImGui::Button(worst.c_str()))
        showPixel(session.views, difference.worst, picture);
    noteItem(session, "worst");
    helpTip("The largest difference, in 255ths, at the pixel " + std::to_string(difference.worst.x) + "," +
            std::to_string(picture.height - 1 - difference.worst.y) +
            " (from the upper left), which is ringed. Click: enlarge it; Ctrl + wheel leads back.");
}

} // namespace

void drawComparisonStrip(Session& session, const Pictures& pictures, const Layout& layout) {
    Views& views = session.views;
    if (!isComparing(views))
        return;
    const float gap = ImGui::GetFontSize() * 0.9F;
    const float narrow = ImGui::GetStyle().ItemInnerSpacing.x / 2;
    Flow flow(layout.strip);
    for (const ArrangementRow& row : arrangementRows) {
        const bool chosen = views.arrangement == row.arrangement;
        flow.place(buttonWidth(row.label), narrow);
        ImGui::PushStyleColor(ImGuiCol_Button,
                              chosen ? ImGui::GetColorU32(ImGuiCol_HeaderActive) : IM_COL32(0, 0, 0, 0));
        if (ImGui::Button(row.label))
            views.arrangement = views.comparing = row.arrangement;
        ImGui::PopStyleColor();
        noteItem(session, std::string("arrangement:") + row.label);
        helpTip(row.help);
    }
    const float field = ImGui::CalcTextSize("255").x + 2 * ImGui::GetStyle().FramePadding.x;
    const char* label = "Tolerance";
    flow.place(ImGui::CalcTextSize(label).x + narrow + field, gap);
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", label);
    ImGui::SameLine(0, narrow);
    ImGui::SetNextItemWidth(field);
    ImGui::DragInt("##tolerance", &views.tolerance, 0.1F, 0, Views::largestTolerance, "%d",
                   ImGuiSliderFlags_AlwaysClamp);
    noteItem(session, "tolerance");
    helpTip("Differences up to here don't count, in 255ths. Drag, or double click to type.");
    if (pictures.difference)
        numbers(session, flow, pictures.difference->numbers, pictures.views.front().frame.size, gap);
    else
        flow.text(pictures.problems.empty() ? "drawing…" : "no numbers: a picture is missing", color::dim,
                  gap);
}

} // namespace texplorer::ui
