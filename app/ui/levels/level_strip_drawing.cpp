#include "app/ui/levels/level_handles.h"
#include "app/ui/levels/levels_tab.h"
#include "app/ui/model/level_edits.h"
#include "app/ui/model/level_view.h"
#include "app/ui/widgets/param_widgets.h"
#include "texplorer/image/mip_colors.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace texplorer::ui {
namespace {

constexpr float maxZoom = 64;

/// A level of the strip. A level that is missing for completeness has no picture.
struct ShownLevel {
    LevelReport report;
    std::shared_ptr<const Image> picture;
    bool missing = false;
};

/// `face`: of a cube map.
std::vector<ShownLevel> shownLevels(const LevelsSummary& summary, int face) {
    const auto others = static_cast<std::size_t>(std::max(face, 1)) - 1;
    const bool isOther = face > 0 && !summary.otherFaces.at(others).empty();
    const auto& pictures = isOther ? summary.otherFaces.at(others) : summary.levels;
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
            std::ranges::find(pictures, report.number, [](const auto& each) { return each.first; });
        levels.push_back({report, picture == pictures.end() ? nullptr : picture->second});
    }
    return levels;
}

/// A shorter form: a square's side with a ².
std::string briefExtents(const LevelReport& level, Target target) {
    if (target == Target::CubeMap || (target == Target::Texture2D && level.width == level.height))
        return fmt::format("{}²", level.width);
    return target == Target::Texture1D ? fmt::format("{}", level.width)
                                       : fmt::format("{}×{}", level.width, level.height);
}

/// The position of a level's extents: below its number, or next to it, which takes width instead of height.
struct ExtentsForm {
    std::string (*text)(const LevelReport& level, Target target);
    bool beside;
};

constexpr std::array extentsForms{
    ExtentsForm{levelExtentsText, false}, ExtentsForm{levelExtentsText, true},
    ExtentsForm{briefExtents, false}, ExtentsForm{briefExtents, true},
    ExtentsForm{[](const LevelReport&, Target) { return std::string(); }, true}};

float flagWidth() {
    return std::round(ImGui::GetFontSize() * 0.62F);
}

float heightOf(const ExtentsForm& form) {
    return (form.beside ? 1.0F : 2.0F) * ImGui::GetTextLineHeight() + ImGui::GetFontSize() * 0.35F;
}

/// The layout of the levels and the texts below them.
struct LabelledStrip {
    LevelStrip strip;
    ExtentsForm form = extentsForms.back();
};

/// In a room for both: the longest text with which the pictures are nearly as large as without it.
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
    StripDrawing(const Session& session, LevelsTabState& state, const Pictures& pictures,
                 const LevelsSummary& summary)
        : session_(session)
        , state_(state)
        , pictures_(pictures)
        , texture_(*boundTexture(session))
        , target_(selectedUnit(session).target)
        , levels_(shownLevels(summary, state.face))
        , asked_(askedLevels(session)) {}

    void draw(float below);

private:
    [[nodiscard]] float em() const { return ImGui::GetFontSize(); }
    [[nodiscard]] float axisHeight() const { return em() * 2.2F; }
    [[nodiscard]] float axisY() const { return origin_.y + strip_.extent.y + labels_ + em() * 0.75F; }
    [[nodiscard]] int lastLevel() const { return levels_.back().report.number; }
    /// Base and max level clamped as the sampler does, to existing levels.
    [[nodiscard]] int base() const { return std::clamp(texture_.baseLevel, 0, lastLevel()); }
    [[nodiscard]] int max() const { return std::clamp(texture_.maxLevel, base(), lastLevel()); }

    void zoom(ImVec2 room);
    void drawCell(std::size_t index);
    void cellTip(const ShownLevel& level) const;

    const Session& session_;
    LevelsTabState& state_;
    const Pictures& pictures_;
    const Texture& texture_;
    Target target_;
    std::vector<ShownLevel> levels_;
    const reference::PixelLevels* asked_;

    LevelStrip strip_;
    ExtentsForm form_ = extentsForms.back();
    ImVec2 origin_{0, 0}; ///< upper left of the pictures
    float labels_ = 0;    ///< height of the text below them
};

/// The wheel zooms around the pointer.
void StripDrawing::zoom(ImVec2 room) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!ImGui::IsWindowHovered() || io.MouseWheel == 0)
        return;
    const float fixed = strip_.levelAt(io.MousePos.x - origin_.x);
    const float zoomed = std::clamp(state_.zoom * std::pow(1.25F, io.MouseWheel), 1.0F, maxZoom);
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
        return helpTip(
            Sentence("Level {0} is missing: it would have {1} texels.", number, ProperName{extents}));
    std::vector<Sentence> lines{
        target_ == Target::CubeMap ? Sentence("Level {0}: six faces of {1} texels, here {2}", number,
                                              ProperName{extents}, rowOf(cubeFaceAt(state_.face)).label)
        : target_ == Target::Texture3D
            ? Sentence("Level {0}: {1} texels, here the slice in the middle", number, ProperName{extents})
            : Sentence("Level {0}: {1} texels", number, ProperName{extents})};
    if (number < base())
        lines.push_back(Sentence("Never read: GL_TEXTURE_BASE_LEVEL is {0}.", texture_.baseLevel));
    else if (number > max())
        lines.push_back(Sentence("Never read: GL_TEXTURE_MAX_LEVEL is {0}.", texture_.maxLevel));
    lines.emplace_back(texture_.baseLevel == number && texture_.maxLevel == number
                           ? N_("Click: read the previous levels again")
                           : N_("Click: read only this level (base and max level)"));
    lines.emplace_back(N_("The flag has the colour of this level when Mipmaps is Coloured."));
    helpTip(Sentence::joined("{0}\n{1}", lines));
}

void StripDrawing::drawCell(std::size_t index) {
    const ShownLevel& level = levels_[index];
    const LevelStrip::Cell& cell = strip_.cells[index];
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float floor = origin_.y + strip_.extent.y; // the lower edge of the pictures
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
        act(session_, [number = level.report.number](Session& s) { toggleForced(s, number); });

    const bool isRead = level.report.number >= base() && level.report.number <= max();
    draw.AddRectFilled(low, high, color::ground);
    if (const view::PictureHandle picture = pictures_.showTexels(level.picture);
        picture != view::PictureHandle::None) // its first row is its bottom one
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
    if (isForced) { // not distinguished only by its colour
        const float side = em() * 0.6F;
        draw.AddTriangleFilled({low.x - 2, low.y - 2}, {low.x + side, low.y - 2}, {low.x - 2, low.y + side},
                               color::chosen);
        noteDrawn("levels:alone", low, {low.x + side, low.y + side});
    }
    const auto sharedBy = [&](int read, float part) { return level.report.number == read ? part : 0; };
    const float share = // of the queried pixel's colour
        asked_ ? sharedBy(asked_->first, 1 - asked_->share) + sharedBy(asked_->second, asked_->share) : 0;
    if (share > 0) {
        draw.AddRect({low.x - 3, low.y - 3}, {high.x + 3, high.y + 3}, color::shade, 0, 0, 4);
        draw.AddRect({low.x - 3, low.y - 3}, {high.x + 3, high.y + 3}, color::probed, 0, 0, 2);
        noteDrawn(fmt::format("levels:read {}", level.report.number), low, high);
    }

    // The flag, the number and the size.
    const std::string number = std::to_string(level.report.number);
    const float flag = flagWidth();
    const std::string extents = level.missing ? std::string() : form_.text(level.report, target_);
    const float numberWidth = ImGui::CalcTextSize(number.c_str()).x;
    const float extentsWidth = ImGui::CalcTextSize(extents.c_str()).x;
    const float beside = form_.beside && extentsWidth > 0 ? em() * 0.4F + extentsWidth : 0;
    const float line = flag + em() * 0.25F + numberWidth + beside;
    float x = std::round(origin_.x + cell.middle() - line / 2);
    float y = floor + em() * 0.35F;
    const auto [r, g, b, a] = mipColor(level.report.number);
    const float top = std::round(y + (ImGui::GetTextLineHeight() - flag) / 2);
    draw.AddRectFilled({x, top}, {x + flag, top + flag}, IM_COL32(r, g, b, a));
    draw.AddRect({x, top}, {x + flag, top + flag}, color::outline);
    x += flag + em() * 0.25F;
    const ImU32 ink = share > 0 ? color::probed : isRead ? color::text : color::dim;
    draw.AddText({x, y}, ink, number.c_str());
    if (form_.beside)
        x += numberWidth + em() * 0.4F;
    else {
        y += ImGui::GetTextLineHeight();
        x = std::round(origin_.x + cell.middle() - extentsWidth / 2);
    }
    draw.AddText({x, y}, color::dim, extents.c_str());
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
    // Centred if it fits.
    const float free = scrolls ? 0 : std::floor(std::max(0.0F, (room.x - strip_.extent.x) / 2));
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    origin_ = {corner.x + pad + free, corner.y + pad};
    zoom(room);
    if (!strip_.cells.empty()) {
        const StripPlace place{strip_,      origin_, axisY(), levels_.front().report.number,
                               lastLevel(), base(),  max()};
        drawLevelHandles(session_, place);
        for (std::size_t i = 0; i < strip_.cells.size(); ++i)
            drawCell(i);
        drawLodAxis(session_, place);
    }
    ImGui::SetCursorScreenPos(corner);
    ImGui::Dummy({strip_.extent.x + 2 * pad, strip_.extent.y + labels_ + axisHeight() + 2 * pad});
    ImGui::EndChild();
}

} // namespace

std::optional<LevelsRequest> requestLevels(const Session& session) {
    if (std::optional<LevelsRequest> request = boundLevels(session))
        return request;
    wrappedText(boundTexture(session) ? "The image is not loaded." : N_("No texture is bound to this unit."));
    noteItem("levels:none");
    return std::nullopt;
}

std::string levelExtentsText(const LevelReport& level, Target target) {
    if (target == Target::Texture1D)
        return fmt::format("{}", level.width);
    if (target == Target::Texture3D)
        return fmt::format("{} × {} × {}", level.width, level.height, level.depth);
    return fmt::format("{} × {}", level.width, level.height);
}

void drawLevelStrip(const Session& session, LevelsTabState& state, const Pictures& pictures,
                    const LevelsSummary& summary, float below) {
    StripDrawing(session, state, pictures, summary).draw(below);
}

} // namespace texplorer::ui
