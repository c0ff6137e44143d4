#include "app/ui/view/panes.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace texplorer::ui {

namespace {

/// Every pane has the size of Layout::picture, which is the first one.
Rect cellOf(const Layout& layout, int column, int row) {
    Rect cell = layout.picture;
    if (column > 0)
        cell.x = layout.canvas.right() - cell.width;
    if (row > 0)
        cell.y = layout.canvas.bottom() - cell.height;
    return cell;
}

std::vector<Pane> arrange(const Layout& layout, const ViewSettings& settings) {
    const Rect whole = layout.picture;
    const int left = static_cast<int>(
        std::lround(std::clamp(settings.split, 0.0F, 1.0F) * static_cast<float>(whole.width)));
    const Rect leftPart{whole.x, whole.y, left, whole.height};
    const Rect rightPart{whole.x + left, whole.y, whole.width - left, whole.height};
    switch (settings.arrangement) {
    case Arrangement::One:
        return {{settings.renderer, whole, whole}};
    case Arrangement::Split:
        return {{settings.compared[0], whole, leftPart}, {settings.compared[1], whole, rightPart}};
    case Arrangement::Kept:
        return {{settings.renderer, whole, leftPart, view::Side::Kept},
                {settings.renderer, whole, rightPart, view::Side::Now}};
    case Arrangement::Grid:
        break;
    }
    std::vector<Pane> panes;
    for (const RendererKind renderer : shownRenderers(settings)) {
        const auto at = static_cast<int>(panes.size());
        panes.push_back({renderer, cellOf(layout, at % 2, at / 2), {}});
    }
    panes.push_back({std::nullopt, cellOf(layout, 1, 1), {}});
    for (Pane& pane : panes)
        pane.visible = pane.frame;
    return panes;
}

glm::vec2 originOf(const Rect& rect) {
    return {static_cast<float>(rect.x), static_cast<float>(rect.y)};
}

glm::vec2 sizeOf(const Rect& rect) {
    return {static_cast<float>(rect.width), static_cast<float>(rect.height)};
}

/// The centre nearest to the wanted one at which only the picture is visible.
glm::vec2 withinPicture(glm::vec2 centre, int factor) {
    const float half = 0.5F / static_cast<float>(factor);
    return glm::clamp(centre, glm::vec2(half), glm::vec2(1 - half));
}

} // namespace

PaneGrid gridOf(const ViewSettings& settings) {
    static_assert(rendererKindRows.size() == 3, "with the difference they form a square of four");
    const int extent = settings.arrangement == Arrangement::Grid ? 2 : 1;
    return {extent, extent, isComparing(settings), settings.stripLines};
}

Panes::Panes(const Layout& layout, const ViewSettings& settings, view::Size picture)
    : panes_(arrange(layout, settings))
    , size_(static_cast<float>(picture.width), static_cast<float>(picture.height)) {
    const int factor = std::clamp(settings.zoom.factor, 1, PictureZoom::maxFactor);
    const glm::vec2 centre = withinPicture(settings.zoom.centre, factor);
    const glm::vec2 half(0.5F / static_cast<float>(factor));
    low_ = centre - half;
    high_ = centre + half;
}

const Pane* Panes::under(ImVec2 place) const {
    const auto found = std::ranges::find_if(
        panes_, [&](const Pane& pane) { return pane.visible.contains(place.x, place.y); });
    return found == panes_.end() ? nullptr : &*found;
}

glm::vec2 Panes::toPicture(const Pane& pane, ImVec2 place) const {
    const glm::vec2 share = (glm::vec2(place.x, place.y) - originOf(pane.frame)) / sizeOf(pane.frame);
    return glm::mix(low_, high_, glm::vec2(share.x, 1 - share.y)) * size_;
}

ImVec2 Panes::toWindow(const Pane& pane, glm::vec2 at) const {
    const glm::vec2 share = (at / size_ - low_) / (high_ - low_);
    const glm::vec2 place = originOf(pane.frame) + glm::vec2(share.x, 1 - share.y) * sizeOf(pane.frame);
    return {place.x, place.y};
}

void Panes::draw(ImDrawList& to, const Pane& pane, view::PictureHandle picture, ImU32 tint) const {
    // The picture's first row is its bottom one.
    to.AddImage(textureId(picture), lowOf(pane.frame), highOf(pane.frame), {low_.x, high_.y},
                {high_.x, low_.y}, tint);
}

glm::vec2 Panes::shareAt(const Pane& pane, ImVec2 place) const {
    const glm::vec2 at = toPicture(pane, place) / glm::max(size_, glm::vec2(1));
    return {at.x, 1 - at.y};
}

ImVec2 Panes::shareToWindow(const Pane& pane, glm::vec2 share) const {
    return toWindow(pane, glm::vec2(share.x, 1 - share.y) * size_);
}

std::optional<glm::ivec2> Panes::pixelAt(ImVec2 place) const {
    const Pane* pane = under(place);
    if (!pane || size_.x < 1 || size_.y < 1)
        return std::nullopt;
    // A mouse at an integer position is on the pixel to the right of it and below, regardless of rounding.
    constexpr float inside = 0.01F;
    const glm::ivec2 pixel(glm::floor(toPicture(*pane, {place.x + inside, place.y + inside})));
    return glm::clamp(pixel, glm::ivec2(0), glm::ivec2(size_) - 1);
}

glm::vec2 Panes::pixelExtent() const {
    return sizeOf(panes_.front().frame) / ((high_ - low_) * glm::max(size_, glm::vec2(1)));
}

void zoomPictures(ViewSettings& settings, const Layout& layout, ImVec2 place, int notches) {
    const Panes before(layout, settings, {1, 1});
    const Pane* pane = before.under(place);
    if (!pane)
        return;
    const glm::vec2 fixed = before.toPicture(*pane, place); // a fraction: the picture has one pixel here
    int& factor = settings.zoom.factor;
    const int old = factor;
    for (; notches > 0 && factor < PictureZoom::maxFactor; --notches)
        factor *= 2;
    for (; notches < 0 && factor > 1; ++notches)
        factor /= 2;
    const glm::vec2 centre = (before.partLow() + before.partHigh()) / 2.0F;
    settings.zoom.centre = withinPicture(
        fixed + (centre - fixed) * (static_cast<float>(old) / static_cast<float>(factor)), factor);
}

void movePictures(ViewSettings& settings, const Layout& layout, ImVec2 way) {
    const auto factor = static_cast<float>(settings.zoom.factor);
    const glm::vec2 share = glm::vec2(way.x, -way.y) / (sizeOf(layout.picture) * factor);
    settings.zoom.centre = withinPicture(settings.zoom.centre - share, settings.zoom.factor);
}

} // namespace texplorer::ui
