#include "app/ui/texture_space/texel_insets.h"

#include "app/ui/language/translate.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/points.h"

#include <algorithm>
#include <cmath>

namespace texplorer::ui {
namespace {

using reference::LevelPatch;
using reference::PlacedTap;

constexpr float maxShare = 0.3F; // of texture space that small pictures may cover

float shareOf(const reference::UnitExplanation& unit, int level) {
    for (const reference::LevelShare& share : unit.sample.levels) {
        if (share.level == level)
            return share.weight;
    }
    return 1;
}

void include(Box& box, ImVec2 place) {
    box.low = {std::min(box.low.x, place.x), std::min(box.low.y, place.y)};
    box.high = {std::max(box.high.x, place.x), std::max(box.high.y, place.y)};
}

} // namespace

float insetTitleHeight() {
    return ImGui::GetFontSize() * 1.25F;
}

Box Inset::frame() const {
    const float pad = ImGui::GetFontSize() * 0.2F;
    return {{low.x - pad, low.y - insetTitleHeight()}, {low.x + width + pad, low.y + size().y + pad}};
}

const LevelPatch& heaviestPatch(const reference::UnitExplanation& unit) {
    return *std::ranges::max_element(unit.patches, {},
                                     [&](const LevelPatch& patch) { return shareOf(unit, patch.level); });
}

ImVec2 sampleIn(const Canvas& canvas, const reference::UnitExplanation& unit) {
    const LevelPatch& patch = heaviestPatch(unit);
    return canvas.toPixel(patch.place / glm::vec2(glm::max(patch.extent, 1)));
}

Box texelBox(const Canvas& canvas, glm::ivec2 at, glm::ivec2 extent) {
    const glm::vec2 size(glm::max(extent, 1));
    const glm::vec2 low = glm::vec2(at) / size;
    const glm::vec2 high = glm::vec2(at + 1) / size;
    return {canvas.toPixel(low.x, high.y), canvas.toPixel(high.x, low.y)};
}

Corners footprintOf(ImVec2 middle, ImVec2 dx, ImVec2 dy) {
    const auto corner = [&](float a, float b) { return middle + dx * a + dy * b; };
    return {corner(-0.5F, -0.5F), corner(0.5F, -0.5F), corner(0.5F, 0.5F), corner(-0.5F, 0.5F)};
}

Corners footprintIn(const Canvas& canvas, const reference::UnitExplanation& unit) {
    const auto way = [&](glm::vec3 d) {
        return ImVec2(d.x * canvas.pixelsPerUnit, -d.y * canvas.pixelsPerUnit);
    };
    return footprintOf(sampleIn(canvas, unit), way(unit.derivatives.dx), way(unit.derivatives.dy));
}

bool isFinite(const Corners& corners) {
    return std::ranges::all_of(corners,
                               [](ImVec2 each) { return std::isfinite(each.x) && std::isfinite(each.y); });
}

Box marksOf(const reference::UnitExplanation& unit, const Canvas& canvas) {
    const ImVec2 middle = sampleIn(canvas, unit);
    Box marks{middle, middle};
    for (const LevelPatch& patch : unit.patches) {
        for (const PlacedTap& tap : patch.taps) {
            const Box texel = texelBox(canvas, tap.at, patch.extent);
            include(marks, texel.low);
            include(marks, texel.high);
        }
    }
    if (const Corners footprint = footprintIn(canvas, unit); isFinite(footprint)) {
        for (const ImVec2& corner : footprint)
            include(marks, corner);
    }
    return marks;
}

namespace {

Box padded(const Box& box, float margin) {
    return {box.low - ImVec2(margin, margin), box.high + ImVec2(margin, margin)};
}

Box aroundVertex(ImVec2 at) {
    return padded({at, at}, ImGui::GetFontSize() * 0.6F);
}

/// Areas that small pictures should not cover: first the explained ones, then the selected vertices, the
/// names of the axes and the image.
std::vector<Uncovered> keptInSight(const reference::UnitExplanation& unit, const Canvas& canvas) {
    constexpr float mark = 100;
    constexpr float words = 60; ///< worth of the legend, which would be drawn over an inset's title
    constexpr float vertex = 30;
    constexpr float name = 3;
    constexpr float image = 1;
    const float em = ImGui::GetFontSize();
    const ImVec2 low = canvas.toPixel(0, 0);
    const ImVec2 high = canvas.toPixel(1, 1);
    std::vector<Uncovered> kept{{{{low.x, high.y}, {high.x, low.y}}, image}};
    kept.push_back({canvas.legend, words});
    if (unit.target == Target::CubeMap)
        return kept; // its texels are marked only in the small pictures
    for (const ImVec2& place : canvas.chosen)
        kept.push_back({aroundVertex(place), vertex});
    kept.push_back({{{low.x - 1.5F * em, low.y}, {high.x + 3 * em, low.y + 1.5F * em}}, name});
    kept.push_back({{{low.x - 1.5F * em, high.y - 2 * em}, {low.x, high.y + em}}, name});
    kept.push_back({padded(marksOf(unit, canvas), em * 0.4F), mark});
    return kept;
}

/// The texts of a title, the most important first.
Sentence titleOf(const reference::UnitExplanation& unit, const LevelPatch& patch, bool whole) {
    const float share = shareOf(unit, patch.level);
    Sentence title(N_("level {0}"), patch.level);
    if (unit.sample.cube)
        title = Sentence("{0} · {1}", rowOf(cubeFaceAt(patch.layer)).label, title);
    if (!whole)
        return title;
    return share < 1 ? Sentence("{0} · {1} %", title, std::lround(share * 100))
                     : Sentence("{0} · {1} × {2}", title, patch.extent.x, patch.extent.y);
}

/// The longest title that fits.
Sentence titleThatFits(const reference::UnitExplanation& unit, const LevelPatch& patch, float room) {
    Sentence title = titleOf(unit, patch, true);
    return ImGui::CalcTextSize(tr(title).c_str()).x <= room ? title : titleOf(unit, patch, false);
}

/// The texels are as large as `side` allows.
std::vector<Inset> insetsOf(const reference::UnitExplanation& unit, std::span<const LevelPatch> patches,
                            const Canvas& canvas, float side) {
    std::vector<Inset> insets;
    const float em = ImGui::GetFontSize();
    const float maxWidth = (canvas.high.x - canvas.low.x - em * 2) / 2;
    const ImVec2 frame(em * 0.2F, em * 0.2F);
    std::vector<ImVec2> sizes; // with a title above and a frame around
    for (const LevelPatch& each : patches) {
        if (each.size.x < 1 || each.size.y < 1)
            continue;
        const Sentence title = titleThatFits(unit, each, maxWidth);
        const std::string shown = fitted(title, maxWidth);
        const float frameWidth = std::max(side, ImGui::CalcTextSize(shown.c_str()).x);
        insets.push_back({&each, {}, side / static_cast<float>(each.size.x), title, shown, frameWidth});
        sizes.push_back(
            {insets.back().width + 2 * frame.x, insets.back().size().y + insetTitleHeight() + frame.y});
    }
    if (insets.empty())
        return insets;
    Box room = padded({canvas.low, canvas.high}, -em * 0.3F);
    // The legend is drawn over everything: next to it there is hardly any room for two titles.
    if (const float below = canvas.legend.high.y + em * 0.3F;
        (room.high.y - below) * 4 > (room.high.y - room.low.y) * 3)
        room.low.y = std::max(room.low.y, below);
    const std::vector<ImVec2> places = placeInsets(sizes, room, em * 0.2F, keptInSight(unit, canvas));
    for (std::size_t i = 0; i < insets.size(); ++i)
        insets[i].low = {places[i].x + frame.x, places[i].y + insetTitleHeight()};
    return insets;
}

} // namespace

std::vector<Inset> insetsOf(const reference::UnitExplanation* unit, const Canvas& canvas) {
    const float em = ImGui::GetFontSize();
    const float width = canvas.high.x - canvas.low.x;
    const float height = canvas.high.y - canvas.low.y;
    const float maxSize = std::min({em * 8, (width - em * 1.5F) / 2, height * 0.5F});
    const float minSize = em * 2;
    if (!unit || unit->patches.empty() || maxSize < minSize)
        return {};
    const bool isCube = unit->target == Target::CubeMap; // its texels are marked only in the small pictures
    const Box marks = marksOf(*unit, canvas);
    struct MayHide {
        bool legend, vertices;
    };
    const auto hides = [&](const std::vector<Inset>& insets, MayHide may) {
        float area = 0;
        for (const Inset& inset : insets) {
            const Box frame = inset.frame();
            const auto hidesVertex = [&](ImVec2 at) { return overlaps(frame, aroundVertex(at)); };
            if ((!isCube && overlaps(frame, marks)) || (!may.legend && overlaps(frame, canvas.legend)) ||
                (!may.vertices && std::ranges::any_of(canvas.chosen, hidesVertex)))
                return true;
            area += (frame.high.x - frame.low.x) * (frame.high.y - frame.low.y);
        }
        return area > maxShare * width * height;
    };
    // Small pictures hide less. If two do not fit, only the one with the greater share is shown; if that does
    // not fit either, only the marks in the image are. A picture hides a selected vertex only if there is no
    // other place, and only then the legend.
    const std::span<const LevelPatch> all(unit->patches);
    const std::span<const LevelPatch> heaviest(&heaviestPatch(*unit), 1);
    for (const MayHide may : {MayHide{false, false}, MayHide{false, true}, MayHide{true, true}}) {
        for (const std::span<const LevelPatch> patches : {all, heaviest}) {
            for (const float share : {1.0F, 0.75F, 0.5F, 0.35F}) {
                std::vector<Inset> insets =
                    insetsOf(*unit, patches, canvas, std::max(maxSize * share, minSize));
                if (!hides(insets, may))
                    return insets;
            }
        }
    }
    return isCube ? insetsOf(*unit, heaviest, canvas, minSize) : std::vector<Inset>{};
}

} // namespace texplorer::ui
