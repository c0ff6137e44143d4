#include "app/ui/figures/hatching.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace texplorer::ui {

void hatch(ImDrawList& draw, std::span<const ImVec2> polygon, float gap, ImU32 tint, float width) {
    if (polygon.size() < 3 || gap <= 0)
        return;
    // A line is where x + y = c; y points downwards.
    const auto sum = [](ImVec2 at) { return at.x + at.y; };
    const auto [least, most] = std::ranges::minmax(polygon, {}, sum);
    for (float c = std::ceil(sum(least) / gap) * gap; c < sum(most); c += gap) {
        std::array<ImVec2, 2> ends{};
        std::size_t found = 0;
        for (std::size_t i = 0; i < polygon.size() && found < ends.size(); ++i) {
            const ImVec2 a = polygon[i];
            const ImVec2 b = polygon[(i + 1) % polygon.size()];
            const float before = sum(a) - c;
            const float after = sum(b) - c;
            if ((before <= 0) == (after <= 0))
                continue;
            const float share = before / (before - after);
            ends.at(found++) = {a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share};
        }
        if (found == ends.size())
            draw.AddLine(ends[0], ends[1], tint, width);
    }
}

} // namespace texplorer::ui
