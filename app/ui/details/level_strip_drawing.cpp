#include "app/ui/details/level_strip_drawing.h"

#include "app/ui/details/level_edits.h"
#include "app/ui/details/level_strip.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/theme.h"
#include "core/image/mip_colors.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace texplorer::ui {
namespace {

/// A level of the strip. One that a complete texture would have and this one lacks has no picture.
struct ShownLevel {
    LevelReport report;
    std::shared_ptr<const Image> picture;
    bool missing = false;
};

std::vector<ShownLevel> shownLevels(const LevelsSummary& summary) {
    std::vector<ShownLevel> levels;
    for (const LevelReport& report : summary.report.levels) {
        while (!levels.empty() && levels.back().report.number + 1 < report.number) {
            LevelReport absent = levels.back().report;
            ++absent.number;
            absent.width = std::max(1, absent.width / 2);
            absent.height = std::max(1, absent.height / 2);
            absent.depth = std::max(1, absent.depth / 2);
            levels.push_back({absent, nullptr, true});
        }
        const auto picture =
            std::ranges::find(summary.levels, report.number, [](const auto& each) { return each.first; });
        levels.push_back({report, picture == summary.levels.end() ? nullptr : picture->second});
    }
    return levels;
}

/// "128 × 64"; of a line its length, of a volume three extents.
std::string levelExtentsText(const LevelReport& level, Target target) {
    if (target == Target::Texture1D)
        return fmt::format("{}", level.width);
    if (target == Target::Texture3D)
        return fmt::format("{} × {} × {}", level.width, level.height, level.depth);
    return fmt::format("{} × {}", level.width, level.height);
}

/// The same with fewer letters: a square's side with a ².
std::string briefExtents(const LevelReport& level, Target target) {
    if (target == Target::Texture2D && level.width == level.height)
        return fmt::format("{}²", level.width);
    if (target == Target::CubeMap)
        return fmt::format("{}²", level.width);
    return target == Target::Texture1D ? fmt::format("{}", level.width)
                                       : fmt::format("{}×{}", level.width, level.height);
}

/// How the extents of a level are written: below its number, or beside it, which takes width instead of
/// height.
struct ExtentsForm {
    std::string (*text)(const LevelReport& level, Target target);
    bool beside;
};

std::string withoutExtents(const LevelReport& /*level*/, Target /*target*/) {
    return {};
}

constexpr std::array extentsForms{ExtentsForm{levelExtentsText, false}, ExtentsForm{levelExtentsText, true},
                                  ExtentsForm{briefExtents, false}, ExtentsForm{briefExtents, true},
                                  ExtentsForm{withoutExtents, true}};

float flagWidth() {
    return std::round(ImGui::GetFontSize() * 0.62F);
}

float heightOf(const ExtentsForm& form) {
    return (form.beside ? 1.0F : 2.0F) * ImGui::GetTextLineHeight() + ImGui::GetFontSize() * 0.35F;
}

/// How the levels stand, and what is written below them.
struct LabelledStrip {
    LevelStrip strip;
    ExtentsForm form = extentsForms.back();
};

/// In a room for both: with the longest text that leaves the pictures nearly as large as they are without
/// any.
LabelledStrip layOutLabelled(const std::vector<ShownLevel>& levels, Target target, ImVec2 room,
                             const LevelsTabState& state) {
    const float em = ImGui::GetFontSize();
    const auto with = [&](const ExtentsForm& form, float zoom) {
        std::vector<StripLevel> cells;
        for (const ShownLevel& level : levels) {
            const LevelReport& report = level.report;
            const float number =
                flagWidth() + em * 0.25F + ImGui::CalcTextSize(std::to_string(report.number).c_str()).x;
            const float extents = ImGui::CalcTextSize(form.text(report, target).c_str()).x;
            cells.push_back({report.number, static_cast<float>(report.width),
                             static_cast<float>(target == Target::Texture1D ? 1 : report.height),
                             !form.beside  ? std::max(number, extents)
                             : extents > 0 ? number + em * 0.4F + extents
                                           : number});
        }
        return layOutLevels(cells, {room.x, std::max(em, room.y - heightOf(form))}, em * 0.5F, state.equal,
                            zoom);
    };
    const float whole = with(extentsForms.back(), 1).texel;
    const auto form = std::ranges::find_if(
        extentsForms, [&](const ExtentsForm& each) { return with(each, 1).texel >= 0.65F * whole; });
    return {with(*form, state.zoom), *form};
}

class StripDrawing {
public:
    StripDrawing(Session& session, LevelsTabState& state, const Pictures& pictures,
                 const LevelsSummary& summary)
        : session_(session)
        , state_(state)
        , pictures_(pictures)
        , texture_(*boundTexture(std::as_const(session)))
        , target_(selectedUnit(session).target)
        , levels_(shownLevels(summary))
        , map_(levelMapOf(session))
        , asked_(askedLevels(session)) {}

    void draw(float below);

private:
    [[nodiscard]] float em() const { return ImGui::GetFontSize(); }
    [[nodiscard]] float lineHeight() const { return ImGui::GetTextLineHeight(); }
    [[nodiscard]] float axisHeight() const { return em() * 2.2F; }
    [[nodiscard]] float axisY() const { return origin_.y + strip_.extent.y + labels_ + em() * 0.75F; }
    [[nodiscard]] int lastLevel() const { return levels_.back().report.number; }
    /// What the sampler makes of base and max level: those that there are.
    [[nodiscard]] int base() const { return std::clamp(texture_.baseLevel, 0, lastLevel()); }
    [[nodiscard]] int max() const { return std::clamp(texture_.maxLevel, base(), lastLevel()); }
    [[nodiscard]] float xOf(float level) const { return origin_.x + strip_.placeOf(level); }
    [[nodiscard]] float levelUnderMouse() const {
        return strip_.levelAt(ImGui::GetIO().MousePos.x - origin_.x);
    }
    [[nodiscard]] float shareOf(int level) const;

    void zoom(ImVec2 room);
    void drawCell(std::size_t index);
    void cellTip(const ShownLevel& level) const;
    void levelHandle(const char* name, float x, const char* help, void (*set)(Session&, int), int least,
                     int most, int unlimited);
    void lodHandle(const char* name, float lod, float unlimited, bool least);
    void drawAxis();

    Session& session_;
    LevelsTabState& state_;
    const Pictures& pictures_;
    const Texture& texture_;
    Target target_;
    std::vector<ShownLevel> levels_;
    const reference::LevelMap* map_;
    const reference::PixelLevels* asked_;

    LevelStrip strip_;
    ExtentsForm form_ = extentsForms.back();
    ImVec2 origin_{0, 0}; ///< upper left of the pictures
    float labels_ = 0;    ///< height of what is written below them
};

/// Of the pixel that one asks about, how much of its colour comes from a level.
float StripDrawing::shareOf(int level) const {
    if (!asked_)
        return 0;
    return (asked_->first == level ? 1 - asked_->share : 0) + (asked_->second == level ? asked_->share : 0);
}

/// The wheel enlarges; what is under the pointer stays there.
void StripDrawing::zoom(ImVec2 room) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!ImGui::IsWindowHovered() || io.MouseWheel == 0)
        return;
    const float fixed = levelUnderMouse();
    const float zoomed =
        std::clamp(state_.zoom * std::pow(1.25F, io.MouseWheel), 1.0F, LevelsTabState::largestZoom);
    if (zoomed == state_.zoom)
        return;
    state_.zoom = zoomed < 1.01F ? 1 : zoomed;
    const float left = origin_.x + ImGui::GetScrollX();
    strip_ = layOutLabelled(levels_, target_, room, state_).strip;
    ImGui::SetScrollX(strip_.placeOf(fixed) - (io.MousePos.x - left));
    ImGui::SetScrollY(1e6F);
}

void StripDrawing::cellTip(const ShownLevel& level) const {
    const int number = level.report.number;
    const std::string extents = levelExtentsText(level.report, target_);
    if (level.missing)
        return helpTip(fmt::format("Level {} is missing: it would have {} texels.", number, extents));
    std::string text = target_ == Target::CubeMap
                           ? fmt::format("Level {}: six faces of {} texels, here +x", number, extents)
                           : fmt::format("Level {}: {} texels", number, extents);
    if (target_ == Target::Texture3D)
        text = fmt::format("Level {}: {} texels, here the slice in the middle", number, extents);
    if (number < base())
        text += fmt::format("\nNever read: GL_TEXTURE_BASE_LEVEL is {}.", texture_.baseLevel);
    else if (number > max())
        text += fmt::format("\nNever read: GL_TEXTURE_MAX_LEVEL is {}.", texture_.maxLevel);
    text += texture_.baseLevel == number && texture_.maxLevel == number
                ? "\nClick: read the levels from before again"
                : "\nClick: read this level alone, as base and max level";
    helpTip(text + "\nThe flag has the colour of this level where Mipmaps is Coloured.");
}

void StripDrawing::drawCell(std::size_t index) {
    const ShownLevel& level = levels_[index];
    const LevelStrip::Cell& cell = strip_.cells[index];
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float floor = origin_.y + strip_.extent.y; // the pictures stand on it
    const float half = cell.picture.x / 2;
    const float least = target_ == Target::Texture1D ? em() * 0.8F : 1; // a line is drawn as a band
    const ImVec2 low(std::round(origin_.x + cell.middle() - half),
                     std::round(floor - std::max(least, cell.picture.y)));
    const ImVec2 high(std::max(low.x + 1, std::round(origin_.x + cell.middle() + half)), floor);
    ImGui::SetCursorScreenPos({origin_.x + cell.left, origin_.y});
    const std::string name = fmt::format("levels:level {}", level.report.number);
    const bool clicked = ImGui::InvisibleButton(name.c_str(), {cell.width, strip_.extent.y + labels_});
    noteItem(name);
    noteDrawn(fmt::format("levels:picture {}", level.report.number), low, high);
    const bool hovered = ImGui::IsItemHovered();
    cellTip(level);
    if (clicked && !level.missing)
        toggleForced(session_, state_, level.report.number);

    const bool isRead = level.report.number >= base() && level.report.number <= max();
    const view::PictureHandle picture = pictures_.showTexels(level.picture);
    draw.AddRectFilled(low, high, color::ground);
    if (picture != view::PictureHandle::None) // its first row is its bottom one
        draw.AddImage(textureId(picture), low, high, {0, 1}, {1, 0},
                      ImGui::GetColorU32(ImVec4(1, 1, 1, isRead ? 1.0F : 0.3F)));
    if (level.missing) {
        draw.AddRect(low, high, color::problem);
        draw.AddLine(low, high, color::problem);
    }
    const bool isForced =
        texture_.baseLevel == level.report.number && texture_.maxLevel == level.report.number;
    if (hovered || isForced)
        draw.AddRect({low.x - 2, low.y - 2}, {high.x + 2, high.y + 2}, isForced ? color::chosen : color::text,
                     0, 0, isForced ? 2.0F : 1.0F);
    const float share = shareOf(level.report.number);
    if (share > 0) {
        draw.AddRect({low.x - 3, low.y - 3}, {high.x + 3, high.y + 3}, color::shade, 0, 0, 4);
        draw.AddRect({low.x - 3, low.y - 3}, {high.x + 3, high.y + 3}, color::probed, 0, 0, 2);
        noteDrawn(fmt::format("levels:read {}", level.report.number), low, high);
    }

    // The flag, the number and the size.
    const std::string number = std::to_string(level.report.number);
    const float flag = flagWidth();
    const float numberWidth = ImGui::CalcTextSize(number.c_str()).x;
    const float sideText =
        form_.beside && !level.missing ? ImGui::CalcTextSize(form_.text(level.report, target_).c_str()).x : 0;
    const float line = flag + em() * 0.25F + numberWidth + (sideText > 0 ? em() * 0.4F + sideText : 0);
    float x = std::round(origin_.x + cell.middle() - line / 2);
    float y = floor + em() * 0.35F;
    const auto [r, g, b, a] = mipColor(level.report.number);
    const float top = std::round(y + (lineHeight() - flag) / 2);
    draw.AddRectFilled({x, top}, {x + flag, top + flag}, IM_COL32(r, g, b, a));
    draw.AddRect({x, top}, {x + flag, top + flag}, color::outline);
    x += flag + em() * 0.25F;
    const ImU32 ink = share > 0 ? color::probed : isRead ? color::text : color::dim;
    draw.AddText({x, y}, ink, number.c_str());
    const std::string extents = level.missing ? std::string() : form_.text(level.report, target_);
    if (form_.beside)
        x += numberWidth + em() * 0.4F;
    else {
        y += lineHeight();
        x = std::round(origin_.x + cell.middle() - ImGui::CalcTextSize(extents.c_str()).x / 2);
    }
    draw.AddText({x, y}, color::dim, extents.c_str());
}

/// A bar beside the first or the last level that is read, which one drags from level to level.
void StripDrawing::levelHandle(const char* name, float x, const char* help, void (*set)(Session&, int),
                               int least, int most, int unlimited) {
    const float reach = em() * 0.35F;
    ImGui::SetCursorScreenPos({x - reach, origin_.y - em() * 0.4F});
    ImGui::InvisibleButton(name, {2 * reach, strip_.extent.y + em() * 0.4F});
    noteItem(name);
    const bool held = ImGui::IsItemActive();
    const bool hot = held || ImGui::IsItemHovered();
    if (hot)
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    helpTip(help);
    if (held && ImGui::GetIO().MouseDelta.x != 0) {
        const int level = std::clamp(static_cast<int>(std::lround(levelUnderMouse())), least, most);
        set(session_, level == lastLevel() && unlimited > 0 ? unlimited : level);
    }
    sealAfterItem(session_);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImU32 tint = hot ? color::text : color::outline;
    const float width = std::max(1.0F, em() * 0.12F);
    draw.AddRectFilled({x - width / 2, origin_.y - em() * 0.4F}, {x + width / 2, origin_.y + strip_.extent.y},
                       tint);
    const float grip = em() * 0.22F;
    const float middle = origin_.y + strip_.extent.y / 2;
    draw.AddRectFilled({x - grip, middle - 3 * grip}, {x + grip, middle + 3 * grip}, tint, grip);
}

/// An end of the range to which λ is clamped. Beyond the strip there is no limit.
void StripDrawing::lodHandle(const char* name, float lod, float unlimited, bool least) {
    const float x = xOf(static_cast<float>(base()) + lod);
    const float y = axisY();
    const float reach = em() * 0.4F;
    ImGui::SetCursorScreenPos({x - reach, y - reach * 1.5F});
    ImGui::InvisibleButton(name, {2 * reach, 2 * reach});
    noteItem(name);
    const bool held = ImGui::IsItemActive();
    const bool hot = held || ImGui::IsItemHovered();
    if (hot)
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    const std::string value = lod == unlimited ? std::string("no limit") : fmt::format("{:.2f}", lod);
    helpTip(least
                ? fmt::format("GL_TEXTURE_MIN_LOD: {}\nλ is never below it. Drag it; at the end of the strip "
                              "there is no limit.",
                              value)
                : fmt::format("GL_TEXTURE_MAX_LOD: {}\nλ is never above it. Drag it; at the end of the strip "
                              "there is no limit.",
                              value));
    if (held && ImGui::GetIO().MouseDelta.x != 0) {
        const float level = levelUnderMouse();
        const bool beyond = least ? level <= static_cast<float>(levels_.front().report.number) - 0.45F
                                  : level >= static_cast<float>(lastLevel()) + 0.45F;
        const float wanted = std::round((level - static_cast<float>(base())) * 20) / 20;
        if (least)
            setMinLod(session_, beyond ? unlimited : std::min(wanted, texture_.maxLod));
        else
            setMaxLod(session_, beyond ? unlimited : std::max(wanted, texture_.minLod));
    }
    sealAfterItem(session_);
    const ImU32 tint = hot ? color::chosen : color::text;
    ImGui::GetWindowDrawList()->AddTriangleFilled({x, y}, {x - reach * 0.8F, y - reach * 1.4F},
                                                  {x + reach * 0.8F, y - reach * 1.4F}, tint);
}

/// λ 0 is below the base level. The part between the limits is bright, and has the false colours where the
/// view shows them.
void StripDrawing::drawAxis() {
    lodHandle("levels:min lod", texture_.minLod, noMinLod, true);
    lodHandle("levels:max lod", texture_.maxLod, noMaxLod, false);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float y = axisY();
    const float left = origin_.x;
    const float right = origin_.x + strip_.extent.x;
    const auto zero = static_cast<float>(base());
    const float low = xOf(zero + texture_.minLod);
    const float high = std::max(low, xOf(zero + texture_.maxLod));
    const float thick = em() * 0.2F;
    draw.AddRectFilled({left, y - 1}, {right, y + 1}, color::faint);
    if (map_ && session_.window.view.shown == reference::Shown::Lambda) {
        const int steps = reference::stepsOf(*map_);
        constexpr float step = 4; // pixels
        for (float x = low; x < high; x += step) {
            const float level = strip_.levelAt(x + step / 2 - origin_.x);
            const auto [r, g, b, a] = reference::lambdaColor(level - zero, steps);
            draw.AddRectFilled({x, y - thick}, {std::min(x + step, high), y + thick}, IM_COL32(r, g, b, a));
        }
    } else {
        draw.AddRectFilled({low, y - thick / 2}, {high, y + thick / 2}, color::dim);
    }
    float free = left; // numbers don't overlap
    for (const LevelStrip::Cell& cell : strip_.cells) {
        const std::string lambda = cell.number == base() ? fmt::format("λ {}", cell.number - base())
                                                         : fmt::format("{}", cell.number - base());
        const float width = ImGui::CalcTextSize(lambda.c_str()).x;
        const float x = std::max(origin_.x + cell.middle() - width / 2, left);
        draw.AddLine({origin_.x + cell.middle(), y - thick}, {origin_.x + cell.middle(), y + thick},
                     color::text);
        if (x < free)
            continue;
        draw.AddText({x, y + em() * 0.35F}, color::dim, lambda.c_str());
        free = x + width + em() * 0.2F;
    }
    if (!asked_)
        return;
    const float x = xOf(zero + asked_->lambda);
    if (const float bias = biasOf(session_); bias != 0) {
        const float from = xOf(zero + asked_->lambda - bias);
        draw.AddLine({from, y}, {x, y}, color::changed, std::max(1.0F, thick * 0.8F));
        draw.AddCircleFilled({from, y}, thick, color::changed);
        noteDrawn("levels:unbiased", {from, y}, {from, y});
    }
    const float size = em() * 0.36F;
    const ImVec2 corners[] = {{x, y - size}, {x + size, y}, {x, y + size}, {x - size, y}};
    draw.AddConvexPolyFilled(corners, 4, color::probed);
    draw.AddPolyline(corners, 4, color::shade, ImDrawFlags_Closed, 1);
    noteDrawn("levels:lambda", {x, y}, {x, y});
}

void StripDrawing::draw(float below) {
    const float height = std::max(em() * 6, ImGui::GetContentRegionAvail().y - below);
    const bool scrolls = state_.zoom > 1;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::BeginChild("strip", {0, height}, false,
                      ImGuiWindowFlags_NoScrollWithMouse |
                          (scrolls ? ImGuiWindowFlags_HorizontalScrollbar : ImGuiWindowFlags_NoScrollbar));
    ImGui::PopStyleVar();
    const float pad = em() * 0.45F; // for the handles
    const ImVec2 room(ImGui::GetWindowWidth() - 2 * pad, std::max(em(), height - axisHeight() - 2 * pad));
    const auto [strip, form] = layOutLabelled(levels_, target_, room, state_);
    strip_ = strip;
    form_ = form;
    labels_ = heightOf(form_);
    // What fits stands in the middle.
    const float free = scrolls ? 0 : std::floor(std::max(0.0F, (room.x - strip_.extent.x) / 2));
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    origin_ = {corner.x + pad + free, corner.y + pad};
    zoom(room);
    if (!strip_.cells.empty()) {
        const auto cellOf = [&](int level) -> const LevelStrip::Cell& {
            const auto found = std::ranges::find(strip_.cells, level, &LevelStrip::Cell::number);
            return found == strip_.cells.end() ? strip_.cells.front() : *found;
        };
        const LevelStrip::Cell& first = cellOf(base());
        const LevelStrip::Cell& last = cellOf(max());
        const float beside = em() * 0.3F;
        levelHandle("levels:base", origin_.x + first.left - beside,
                    "GL_TEXTURE_BASE_LEVEL: the first level that is read. Drag it to another one.",
                    setBaseLevel, levels_.front().report.number, max(), 0);
        levelHandle("levels:max", origin_.x + last.left + last.width + beside,
                    "GL_TEXTURE_MAX_LEVEL: the last level that is read. Drag it to another one; at the last "
                    "one there is no limit.",
                    setMaxLevel, base(), lastLevel(), noMaxLevel);
        for (std::size_t i = 0; i < strip_.cells.size(); ++i)
            drawCell(i);
        drawAxis();
    }
    ImGui::SetCursorScreenPos(corner);
    ImGui::Dummy({strip_.extent.x + 2 * pad, strip_.extent.y + labels_ + axisHeight() + 2 * pad});
    ImGui::EndChild();
}

} // namespace

void drawLevelStrip(Session& session, LevelsTabState& state, const Pictures& pictures,
                    const LevelsSummary& summary, float below) {
    StripDrawing(session, state, pictures, summary).draw(below);
}

} // namespace texplorer::ui
