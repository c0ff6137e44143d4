#include "app/ui/levels/level_strip.h"

#include <algorithm>
#include <cmath>

namespace texplorer::ui {
namespace {

constexpr float maxTexel = 64; // pixels

ImVec2 trueSize(const StripLevel& level, float texel) {
    return {std::max(1.0F, level.width * texel), std::max(1.0F, level.height * texel)};
}

/// Fits a size into a square, with its shape kept.
ImVec2 sizeInSquare(const StripLevel& level, float side) {
    const float longer = std::max(level.width, level.height);
    return {std::max(1.0F, side * level.width / longer), std::max(1.0F, side * level.height / longer)};
}

template<class SizeOf>
float widthOf(std::span<const StripLevel> levels, float gap, const SizeOf& sizeOf) {
    float width = gap * static_cast<float>(levels.size() - 1);
    for (const StripLevel& level : levels)
        width += std::max(level.label, sizeOf(level).x);
    return width;
}

/// The largest number up to `max` for which fits(number) is true; it is true for all below that.
template<class Fits>
float largest(float max, const Fits& fits) {
    float low = 0;
    float high = max;
    for (int i = 0; i < 24; ++i) {
        const float middle = (low + high) / 2;
        (fits(middle) ? low : high) = middle;
    }
    return low;
}

} // namespace

LevelStrip layOutLevels(std::span<const StripLevel> levels, ImVec2 room, float gap, bool equal, float zoom) {
    LevelStrip strip;
    if (levels.empty() || room.x < 1 || room.y < 1)
        return strip;
    const auto sizeWith = [equal](float scale) {
        return [equal, scale](const StripLevel& level) {
            return equal ? sizeInSquare(level, scale) : trueSize(level, scale);
        };
    };
    const float max = equal ? room.y : maxTexel;
    const float fitting = largest(max, [&](float scale) {
        const bool high = std::ranges::any_of(
            levels, [&](const StripLevel& level) { return sizeWith(scale)(level).y > room.y; });
        return !high && widthOf(levels, gap, sizeWith(scale)) <= room.x;
    });
    const float scale = fitting * std::max(1.0F, zoom);
    strip.texel = scale;
    for (const StripLevel& level : levels) {
        LevelStrip::Cell& cell = strip.cells.emplace_back();
        cell.number = level.number;
        cell.left = strip.extent.x;
        cell.picture = sizeWith(scale)(level);
        cell.width = std::max(level.label, cell.picture.x);
        strip.extent.x += cell.width + gap;
        strip.extent.y = std::max(strip.extent.y, cell.picture.y);
    }
    strip.extent.x -= gap;
    return strip;
}

float LevelStrip::placeOf(float level) const {
    if (cells.empty())
        return 0;
    const Cell& first = cells.front();
    const Cell& last = cells.back();
    if (!(level > static_cast<float>(first.number))) {
        const float beyond = std::min(0.5F, static_cast<float>(first.number) - level);
        return first.middle() - beyond * first.width;
    }
    if (level >= static_cast<float>(last.number))
        return last.middle() + std::min(0.5F, level - static_cast<float>(last.number)) * last.width;
    const auto next = std::ranges::find_if(
        cells, [level](const Cell& cell) { return static_cast<float>(cell.number) > level; });
    const Cell& from = *(next - 1);
    const float share =
        (level - static_cast<float>(from.number)) / static_cast<float>(next->number - from.number);
    return std::lerp(from.middle(), next->middle(), share);
}

float LevelStrip::levelAt(float place) const {
    if (cells.empty())
        return 0;
    const Cell& first = cells.front();
    const Cell& last = cells.back();
    if (place <= first.middle())
        return static_cast<float>(first.number) - std::min(0.5F, (first.middle() - place) / first.width);
    if (place >= last.middle())
        return static_cast<float>(last.number) + std::min(0.5F, (place - last.middle()) / last.width);
    const auto next =
        std::ranges::find_if(cells, [place](const Cell& cell) { return cell.middle() > place; });
    const Cell& from = *(next - 1);
    const float share = (place - from.middle()) / (next->middle() - from.middle());
    return std::lerp(static_cast<float>(from.number), static_cast<float>(next->number), share);
}

} // namespace texplorer::ui
