#include "app/ui/levels/level_handles.h"

#include "app/ui/language/translate.h"
#include "app/ui/model/level_edits.h"
#include "app/ui/model/level_view.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/theme.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace texplorer::ui {
namespace {

/// The mouse on a handle, which is an invisible button.
struct HeldHandle {
    bool hot;   ///< is highlighted
    bool moved; ///< with the mouse
};

HeldHandle unseenHandle(const char* name, ImVec2 low, ImVec2 size, const Sentence& help) {
    ImGui::SetCursorScreenPos(low);
    ImGui::InvisibleButton(name, size);
    noteItem(name);
    const bool held = ImGui::IsItemActive();
    const bool hot = held || ImGui::IsItemHovered();
    if (hot)
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    helpTip(help);
    return {hot, held && ImGui::GetIO().MouseDelta.x != 0};
}

/// One of the two bars.
struct LevelBar {
    const char* name;
    const char* help;
    void (*set)(const Session& session, int level);
    float x;
    int least, most;
    int unlimited; ///< the value for the last level; 0: its number
};

void drawLevelBar(const Session& session, const StripPlace& place, const LevelBar& bar) {
    const float em = ImGui::GetFontSize();
    const float reach = std::max(em * 0.35F, targetHeight() / 4); // two may be near each other
    const float top = place.origin.y - em * 0.4F;
    const auto [hot, moved] =
        unseenHandle(bar.name, {bar.x - reach, top}, {2 * reach, place.strip.extent.y + em * 0.4F}, bar.help);
    if (moved) {
        const int level =
            std::clamp(static_cast<int>(std::lround(place.levelUnderMouse())), bar.least, bar.most);
        bar.set(session, level == place.last && bar.unlimited > 0 ? bar.unlimited : level);
    }
    sealAfterItem(session);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImU32 tint = hot ? color::text : color::outline;
    const float width = std::max(1.0F, em * 0.12F);
    draw.AddRectFilled({bar.x - width / 2, top}, {bar.x + width / 2, place.origin.y + place.strip.extent.y},
                       tint);
    const float grip = em * 0.22F;
    const float middle = place.origin.y + place.strip.extent.y / 2;
    draw.AddRectFilled({bar.x - grip, middle - 3 * grip}, {bar.x + grip, middle + 3 * grip}, tint, grip);
}

/// An end of the range to which λ is clamped. Beyond the strip there is no limit.
struct LodEnd {
    const char* name;
    Sentence::Key<Sentence> help; ///< with its value
    bool least;
    float lod;
    float unlimited;
};

void drawLodEnd(const Session& session, const Texture& texture, const StripPlace& place, const LodEnd& end) {
    const float x = place.xOf(static_cast<float>(place.base) + end.lod);
    const float reach = ImGui::GetFontSize() * 0.4F;
    const Sentence value = end.lod == end.unlimited ? Sentence("no limit") : Sentence("{0:.2f}", end.lod);
    const float side = std::max(2 * reach, targetHeight() / 2);
    const auto [hot, moved] = unseenHandle(end.name, {x - side / 2, place.axis - reach / 2 - side / 2},
                                           {side, side}, Sentence(end.help, value));
    if (moved) {
        const float level = place.levelUnderMouse();
        const bool beyond = end.least ? level <= static_cast<float>(place.first) - 0.45F
                                      : level >= static_cast<float>(place.last) + 0.45F;
        const float wanted = std::round((level - static_cast<float>(place.base)) * 20) / 20;
        if (end.least)
            setMinLod(session, beyond ? end.unlimited : std::min(wanted, texture.maxLod));
        else
            setMaxLod(session, beyond ? end.unlimited : std::max(wanted, texture.minLod));
    }
    sealAfterItem(session);
    ImGui::GetWindowDrawList()->AddTriangleFilled(
        {x, place.axis}, {x - reach * 0.8F, place.axis - reach * 1.4F},
        {x + reach * 0.8F, place.axis - reach * 1.4F}, hot ? color::chosen : color::text);
}

/// The part between the limits is bright, and has the false colours if the view shows them.
void drawLodRange(const Session& session, const Texture& texture, const StripPlace& place) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const auto zero = static_cast<float>(place.base);
    const float low = place.xOf(zero + texture.minLod);
    const float high = std::max(low, place.xOf(zero + texture.maxLod));
    const float thick = ImGui::GetFontSize() * 0.2F;
    const float y = place.axis;
    draw.AddRectFilled({place.origin.x, y - 1}, {place.origin.x + place.strip.extent.x, y + 1}, color::faint);
    const reference::LevelMap* map = levelMapOf(session);
    if (!map || session.view.shown != reference::Shown::Lambda)
        return draw.AddRectFilled({low, y - thick / 2}, {high, y + thick / 2}, color::dim);
    const int steps = reference::stepsOf(*map);
    constexpr float step = 4; // pixels
    for (float x = low; x < high; x += step) {
        const float level = place.strip.levelAt(x + step / 2 - place.origin.x);
        const auto [r, g, b, a] = reference::lambdaColor(level - zero, steps);
        draw.AddRectFilled({x, y - thick}, {std::min(x + step, high), y + thick}, IM_COL32(r, g, b, a));
    }
}

void drawLodNumbers(const StripPlace& place) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float em = ImGui::GetFontSize();
    const float thick = em * 0.2F;
    float free = place.origin.x; // numbers don't overlap
    for (const LevelStrip::Cell& cell : place.strip.cells) {
        const int number = cell.number - place.base;
        const std::string lambda = number == 0 ? "λ 0" : std::to_string(number);
        const float width = ImGui::CalcTextSize(lambda.c_str()).x;
        const float middle = place.origin.x + cell.middle();
        const float x = std::max(middle - width / 2, place.origin.x);
        draw.AddLine({middle, place.axis - thick}, {middle, place.axis + thick}, color::text);
        if (x < free)
            continue;
        draw.AddText({x, place.axis + em * 0.35F}, color::dim, lambda.c_str());
        free = x + width + em * 0.2F;
    }
}

/// λ as a diamond, and its value before the bias as a dot.
void drawAskedLod(const Session& session, const StripPlace& place, float lambda) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float em = ImGui::GetFontSize();
    const float thick = em * 0.2F;
    const float level = static_cast<float>(place.base) + lambda;
    const float x = place.xOf(level);
    const float y = place.axis;
    if (const float bias = biasOf(session); bias != 0) {
        const float from = place.xOf(level - bias);
        draw.AddLine({from, y}, {x, y}, color::changed, std::max(1.0F, thick * 0.8F));
        draw.AddCircleFilled({from, y}, thick, color::changed);
        noteDrawn("levels:unbiased", {from, y}, {from, y});
    }
    const float size = em * 0.36F;
    const ImVec2 corners[] = {{x, y - size}, {x + size, y}, {x, y + size}, {x - size, y}};
    draw.AddConvexPolyFilled(corners, 4, color::probed);
    draw.AddPolyline(corners, 4, color::shade, ImDrawFlags_Closed, 1);
    noteDrawn("levels:lambda", {x, y}, {x, y});
}

} // namespace

void drawLevelHandles(const Session& session, const StripPlace& place) {
    const auto cellOf = [&](int level) -> const LevelStrip::Cell& {
        const auto found = std::ranges::find(place.strip.cells, level, &LevelStrip::Cell::number);
        return found == place.strip.cells.end() ? place.strip.cells.front() : *found;
    };
    const LevelStrip::Cell& first = cellOf(place.base);
    const LevelStrip::Cell& last = cellOf(place.max);
    const float beside = ImGui::GetFontSize() * 0.3F;
    drawLevelBar(session, place,
                 {"levels:base",
                  N_("GL_TEXTURE_BASE_LEVEL: the first level that is read. Drag it to another level."),
                  setBaseLevel, place.origin.x + first.left - beside, place.first, place.max, 0});
    drawLevelBar(
        session, place,
        {"levels:max",
         N_("GL_TEXTURE_MAX_LEVEL: the last level that is read. Drag it to another level; at the last level "
            "there is no limit."),
         setMaxLevel, place.origin.x + last.left + last.width + beside, place.base, place.last, noMaxLevel});
}

void drawLodAxis(const Session& session, const StripPlace& place) {
    const Texture& texture = *boundTexture(session);
    drawLodEnd(session, texture, place,
               {"levels:min lod",
                N_("GL_TEXTURE_MIN_LOD: {0}\n"
                   "The lower limit of λ. Drag it; at the end of the strip there is no limit."),
                true, texture.minLod, noMinLod});
    drawLodEnd(session, texture, place,
               {"levels:max lod",
                N_("GL_TEXTURE_MAX_LOD: {0}\n"
                   "The upper limit of λ. Drag it; at the end of the strip there is no limit."),
                false, texture.maxLod, noMaxLod});
    drawLodRange(session, texture, place);
    drawLodNumbers(place);
    if (const reference::PixelLevels* asked = askedLevels(session))
        drawAskedLod(session, place, asked->lambda);
}

} // namespace texplorer::ui
