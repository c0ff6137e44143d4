#include "app/ui/language/translate.h"
#include "app/ui/model/lesson_key_edits.h"
#include "app/ui/model/lesson_run.h"
#include "app/ui/texture_space/plane_keys.h"
#include "app/ui/widgets/line_breaks.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/window/dialog_parts.h"
#include "app/ui/window/shortcuts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace texplorer::ui {
namespace {

struct Line {
    const char* keys;
    const char* effect;
};

constexpr std::array mouseLines{
    Line{N_("Drag"), N_("orbit the camera")},
    Line{N_("Shift + drag, right drag"), N_("move the camera sideways")},
    Line{N_("Wheel"), N_("move nearer or farther")},
    Line{N_("Click with Explain open"), N_("explain the pixel under the mouse")},
    Line{N_("Ctrl + wheel, Ctrl + drag"), N_("enlarge and move the picture")},
    Line{N_("Ctrl + wheel over other panels"), N_("larger or smaller text")},
    Line{N_("Click, Shift + click"), N_("select the nearest vertex, select several")},
    Line{N_("Double click"), N_("frame all models")},
    Line{N_("Right click on a setting"),
         N_("reset to GL's initial value, add a key frame, draw a sheet of its values, pin it")},
    Line{N_("Double click on a number"), N_("type it")},
};

/// Keys that are not shortcuts: they need the pointer, or have an effect while held.
constexpr std::array otherKeys{
    Line{N_("Arrow keys, with Shift"), N_("move the explained pixel by one, by ten")},
    Line{N_("F6, Shift+F6"),
         N_("next panel: arrows move between controls, Space activates them, Escape ends")},
    Line{N_("Menu key, Shift+F10"), N_("opens the menu of the focused control, as a right click does")},
};

struct Legend {
    const char* text;
    ThemeColor ink;
};

constexpr std::array legends{
    Legend{"s, x", color::s},
    Legend{"t, y", color::t},
    Legend{"r, z", color::r},
    Legend{"q, w", color::q},
    Legend{N_("selected vertex"), color::chosen},
    Legend{N_("explained pixel and its texels"), color::probed},
    Legend{N_("changed from the initial value"), color::changed},
    Legend{N_("a problem"), color::problem},
};

/// An action and its effect. Without an effect: a heading.
struct HelpRow {
    Sentence keys;
    Sentence effect{};
    ThemeColor keysInk = color::text;
    ThemeColor effectInk = color::dim;
    bool ofPlane = false;
    float keysWidth = 0; ///< in pixels, of all rows below a heading

    [[nodiscard]] bool isHeading() const { return effect.empty(); }
};

using HelpRows = std::vector<HelpRow>;

/// One row per action with all its keys, except those that the lesson uses.
void addKeys(const Session& session, HelpRows& help) {
    const std::span<const Shortcut> rows = shortcuts();
    for (auto row = rows.begin(); row != rows.end();) {
        const bool taken = isTaken(session, *row);
        std::string keys = labelOf(*row);
        const char* effect = row->effect;
        for (++row; row != rows.end() && row->name.empty(); ++row) {
            if (const std::string other = labelOf(*row); keys.find(other) == std::string::npos)
                keys += ", " + other;
        }
        if (!taken)
            help.push_back({ProperName{keys}, effect});
    }
    for (const Line& line : otherKeys)
        help.push_back({line.keys, line.effect});
    if (!isTakenByLesson(session, "E"))
        help.push_back({N_("hold E"), N_("explain the pixel under the mouse")});
}

/// The lesson's own keys, which have priority.
void addLessonKeys(const Session& session, HelpRows& help) {
    const std::optional<LessonRun>& run = session.lesson;
    if (!run || run->lesson.keys.empty())
        return;
    help.push_back({N_("Keys of this lesson (override the others)"), "", color::dim});
    for (const lesson::LessonKey& key : run->lesson.keys)
        help.push_back({std::string(lesson::signOfKey(key.key)), ProperName{run->text(key.label)}});
}

HelpRows helpRows(const Session& session) {
    HelpRows help;
    addLessonKeys(session, help);
    help.push_back({N_("Keys"), "", color::dim});
    addKeys(session, help);
    help.push_back({N_("Mouse"), "", color::dim});
    for (const Line& line : mouseLines)
        help.push_back({line.keys, line.effect});
    help.push_back({N_("Over the texture space"), "", color::dim});
    for (const PlaneKeyRow& row : planeKeys)
        help.push_back({row.keys, row.effect, color::text, color::dim, true});
    help.push_back({N_("Colours"), "", color::dim});
    for (const Legend& legend : legends)
        help.push_back({"●", legend.text, legend.ink, legend.ink});
    return help;
}

float helpGap() {
    return ImGui::GetFontSize() * 0.6F;
}

float wrappedHeight(const Sentence& words, float width) {
    return wrappedSize(tr(words), std::max(width, 1.0F)).y;
}

float heightOf(const HelpRow& row, float width) {
    const float gap = 2 * ImGui::GetStyle().CellPadding.y;
    if (row.isHeading())
        return wrappedHeight(row.keys, width) + gap + ImGui::GetFontSize() * 0.3F;
    return std::max(wrappedHeight(row.keys, row.keysWidth),
                    wrappedHeight(row.effect, width - row.keysWidth - helpGap())) +
           gap;
}

float heightOf(std::span<const HelpRow> rows, float width) {
    float height = 0;
    for (const HelpRow& row : rows)
        height += heightOf(row, width);
    return height;
}

/// The fraction of the column's width for the keys below a heading, chosen for the lowest height; no key is
/// wrapped.
void shareWidth(std::span<HelpRow> rows, float width) {
    const auto textWidth = [](std::string_view text) {
        return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
    };
    float least = 0;
    float natural = 0;
    for (const HelpRow& row : rows) {
        const std::string keys = tr(row.keys);
        least = std::max(least, std::ceil(widestPiece(keys, textWidth)) + 1);
        natural = std::max(natural, std::ceil(ImGui::CalcTextSize(keys.c_str()).x) + 1);
    }
    const auto use = [&](float keysWidth) {
        for (HelpRow& row : rows)
            row.keysWidth = keysWidth;
        return heightOf(rows, width);
    };
    constexpr int tried = 12;
    float best = least;
    float lowest = std::numeric_limits<float>::max();
    for (int i = 0; i <= tried; ++i) {
        const float keysWidth =
            std::floor(least + (natural - least) * static_cast<float>(i) / static_cast<float>(tried));
        if (const float height = use(keysWidth); height <= lowest) {
            lowest = height;
            best = keysWidth;
        }
    }
    use(best);
}

void shareWidths(HelpRows& help, float width) {
    for (auto first = help.begin(); first != help.end();) {
        const auto last =
            std::find_if(first + 1, help.end(), [](const HelpRow& row) { return row.isHeading(); });
        shareWidth({first + 1, last}, width);
        first = last;
    }
}

/// The rows of each column, none higher than `maxWidth` if possible.
std::vector<std::span<const HelpRow>> helpColumns(std::span<const HelpRow> help, float width,
                                                  float maxWidth) {
    std::vector<std::span<const HelpRow>> columns;
    std::size_t begin = 0;
    float height = 0;
    for (std::size_t i = 0; i < help.size(); ++i) {
        float needed = heightOf(help[i], width);
        if (help[i].isHeading() && i + 1 < help.size()) // a heading stays above a row
            needed += heightOf(help[i + 1], width);
        if (i > begin && height + needed > maxWidth) {
            columns.push_back(help.subspan(begin, i - begin));
            begin = i;
            height = 0;
        }
        height += heightOf(help[i], width);
    }
    columns.push_back(help.subspan(begin));
    return columns;
}

/// The layout of the list, in pixels.
struct HelpPlan {
    HelpRows rows;
    float width;  ///< of a column
    float height; ///< of the highest one
    std::vector<std::span<const HelpRow>> columns{};
};

float maxColumnWidth() {
    return ImGui::GetFontSize() * 31;
}

HelpPlan planHelp(const Session& session, std::size_t count, float available) {
    const float gaps = static_cast<float>(count - 1) * ImGui::GetStyle().ItemSpacing.x * 2;
    const float bar = ImGui::GetStyle().ScrollbarSize;
    const float each = std::floor((available - gaps) / static_cast<float>(count)) - bar;
    HelpPlan plan{helpRows(session), std::clamp(each, 1.0F, maxColumnWidth()), 0};
    shareWidths(plan.rows, plan.width);
    plan.height = std::ceil(heightOf(plan.rows, plan.width) / static_cast<float>(count));
    plan.columns = helpColumns(plan.rows, plan.width, plan.height);
    while (plan.columns.size() > count) { // as even as the rows allow
        plan.height += std::ceil(ImGui::GetFontSize() / 4);
        plan.columns = helpColumns(plan.rows, plan.width, plan.height);
    }
    return plan;
}

/// Two columns if they fit; three if that is lower.
HelpPlan planHelp(const Session& session, ImVec2 available) {
    HelpPlan two = planHelp(session, 2, available.x);
    if (two.height <= available.y)
        return two;
    HelpPlan three = planHelp(session, 3, available.x);
    return three.height < two.height ? std::move(three) : std::move(two);
}

void helpText(const Sentence& words, ThemeColor ink, float width) {
    ImGui::PushStyleColor(ImGuiCol_Text, ink);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + std::max(width, 1.0F));
    text(words);
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

void drawHelpRow(const HelpRow& row, float width) {
    const ImVec2 at = ImGui::GetCursorPos();
    if (row.isHeading()) {
        ImGui::SetCursorPosY(at.y + ImGui::GetFontSize() * 0.3F);
        helpText(row.keys, row.keysInk, width);
    } else {
        helpText(row.keys, row.keysInk, row.keysWidth);
        ImGui::SetCursorPos({at.x + row.keysWidth + helpGap(), at.y});
        helpText(row.effect, row.effectInk, width - row.keysWidth - helpGap());
        if (row.ofPlane)
            noteItem("plane key:" + row.keys.english());
        else
            noteItem("help:" + row.effect.english());
    }
    ImGui::SetCursorPos({at.x, at.y + heightOf(row, width)});
}

void drawHelpColumns(const HelpPlan& plan, float room) {
    const bool scrolls = plan.height > room;
    const ImVec2 size(plan.width + (scrolls ? ImGui::GetStyle().ScrollbarSize : 0),
                      std::min(plan.height, room));
    for (std::size_t i = 0; i < plan.columns.size(); ++i) {
        if (i > 0)
            ImGui::SameLine(0, ImGui::GetStyle().ItemSpacing.x * 2);
        ImGui::PushID(static_cast<int>(i));
        ImGui::BeginChild("column", size, false, scrolls ? 0 : ImGuiWindowFlags_NoScrollbar);
        for (const HelpRow& row : plan.columns[i])
            drawHelpRow(row, plan.width);
        ImGui::EndChild();
        ImGui::PopID();
    }
}

} // namespace

void drawHelp(const Session& session) {
    if (!beginModal("Texplorer"))
        return;
    const char* intro =
        N_("See what each texture parameter of OpenGL does: change it on the left, look at the result in the "
           "middle and find the texture coordinates on the right. Point at anything: the lower edge of the "
           "window explains it and shows its OpenGL call.");
    const ImGuiStyle& style = ImGui::GetStyle();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float width = display.x * 0.95F - 2 * style.WindowPadding.x;
    const float others =
        2 * ImGui::GetFrameHeight() + 2 * style.WindowPadding.y + 2 * style.ItemSpacing.y +
        wrappedHeight(intro, std::min(width - 3 * style.ScrollbarSize, 2 * maxColumnWidth()));
    const float room = std::max(ImGui::GetFontSize() * 6, std::floor(display.y * 0.94F - others));
    const HelpPlan plan = planHelp(session, {width, room});
    const auto count = static_cast<float>(plan.columns.size());
    helpText(intro, color::text, count * plan.width + (count - 1) * 2 * style.ItemSpacing.x);
    drawHelpColumns(plan, room);
    if (closeButton("help:close"))
        closeDialog(session);
    ImGui::EndPopup();
}

} // namespace texplorer::ui
