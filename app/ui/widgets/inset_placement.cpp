#include "app/ui/widgets/inset_placement.h"

#include <algorithm>
#include <array>

namespace texplorer::ui {
namespace {

/// A placement of insets along an edge.
struct Placing {
    bool across; ///< next to each other; else one above the other
    bool atEnd;  ///< at the lower or the right edge; else at the upper or the left one
    enum class Along {
        Begin,
        End,
        Both
    } along; ///< the position on the edge; the first inset is on the left or at the top
};

using Along = Placing::Along;
constexpr std::array placings{
    Placing{true, true, Along::Begin},   Placing{true, false, Along::Begin},
    Placing{true, true, Along::End},     Placing{true, false, Along::End},
    Placing{false, true, Along::Begin},  Placing{false, true, Along::End},
    Placing{false, false, Along::Begin}, Placing{false, false, Along::End},
    Placing{true, true, Along::Both},    Placing{true, false, Along::Both},
    Placing{false, true, Along::Both},   Placing{false, false, Along::Both},
};

std::vector<ImVec2> placed(std::span<const ImVec2> sizes, const Box& room, float gap,
                           const Placing& placing) {
    float ImVec2::*along = placing.across ? &ImVec2::x : &ImVec2::y;
    float ImVec2::*beside = placing.across ? &ImVec2::y : &ImVec2::x;
    float left = room.high.*along - room.low.*along; // of the edge, without the insets
    for (const ImVec2& size : sizes)
        left -= size.*along;
    const auto gaps = static_cast<float>(std::max<std::size_t>(sizes.size(), 1) - 1);
    const bool spread = placing.along == Along::Both && gaps > 0;
    const float between = spread ? std::max(gap, left / gaps) : gap;
    float at = room.low.*along;
    if (placing.along == Along::End)
        at += left - gap * gaps;
    std::vector<ImVec2> places;
    for (const ImVec2& size : sizes) {
        ImVec2 place;
        place.*along = at;
        place.*beside = placing.atEnd ? room.high.*beside - size.*beside : room.low.*beside;
        places.push_back(place);
        at += size.*along + between;
    }
    return places;
}

float costOf(std::span<const ImVec2> places, std::span<const ImVec2> sizes, const Box& room,
             std::span<const Uncovered> kept) {
    constexpr float unseen = 1000; // cost of a pixel of an inset outside of the room
    float cost = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const Box inset{places[i], {places[i].x + sizes[i].x, places[i].y + sizes[i].y}};
        cost += unseen * (sizes[i].x * sizes[i].y - sharedArea(inset, room));
        for (const Uncovered& each : kept)
            cost += each.worth * sharedArea(inset, each.box);
    }
    return cost;
}

} // namespace

float sharedArea(const Box& a, const Box& b) {
    const float width = std::min(a.high.x, b.high.x) - std::max(a.low.x, b.low.x);
    const float height = std::min(a.high.y, b.high.y) - std::max(a.low.y, b.low.y);
    return width > 0 && height > 0 ? width * height : 0;
}

std::vector<ImVec2> placeInsets(std::span<const ImVec2> sizes, const Box& room, float gap,
                                std::span<const Uncovered> kept) {
    std::vector<ImVec2> best;
    float least = 0;
    for (const Placing& placing : placings) {
        std::vector<ImVec2> places = placed(sizes, room, gap, placing);
        const float cost = costOf(places, sizes, room, kept);
        if (best.empty() || cost < least) {
            best = std::move(places);
            least = cost;
        }
    }
    return best;
}

} // namespace texplorer::ui
