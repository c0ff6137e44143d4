#pragma once

#include "texplorer/reference/raster/raster.h"
#include "texplorer/reference/raster/shade.h"
#include "texplorer/reference/shading/fragment.h"

#include <algorithm>
#include <cstdint>
#include <stop_token>
#include <utility>
#include <vector>

namespace texplorer::reference {

/// Visits the fragments of a picture in drawing order, for results other than colours: those that pass the
/// alpha and the depth test (sections 4.1.4 and 4.1.5).
class FragmentWalk {
public:
    FragmentWalk(Viewport viewport, std::stop_token stop)
        : viewport_(viewport)
        , stop_(std::move(stop))
        , depth_(static_cast<std::size_t>(viewport.width) * static_cast<std::size_t>(viewport.height),
                 farthestDepth) {}

    /// Calls work(pixel index, offset as in shade.h) for each fragment of a triangle that passes the tests.
    /// Ends early after a stop request.
    template<class Work>
    void draw(const Triangle& triangle, const Work& work) {
        const Box whole{0, viewport_.width - 1, 0, viewport_.height - 1};
        eachCoveredRow(triangle, whole, [&](int first, int y, int count) {
            if (stop_.stop_requested())
                return;
            const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(viewport_.width);
            for (int x = first; x < first + count; ++x) {
                const glm::vec2 offset = glm::vec2(x, y) - triangle.origin;
                if (const std::size_t at = row + static_cast<std::size_t>(x); isDrawn(triangle, offset, at))
                    work(at, offset);
            }
        });
    }

private:
    bool isDrawn(const Triangle& triangle, glm::vec2 offset, std::size_t at) {
        const Pass& pass = *triangle.pass->pass;
        const std::uint32_t depth = pass.depthTest ? fragmentDepth(triangle, offset) : 0;
        if (pass.depthTest && !passes(pass.depthFunc, depth, depth_[at]))
            return false;
        if (pass.alphaTest &&
            !passes(pass.alphaFunc, fragmentColor(triangle, offset).a, std::clamp(pass.alphaRef, 0.0F, 1.0F)))
            return false;
        if (pass.depthTest)
            depth_[at] = depth;
        return true;
    }

    Viewport viewport_;
    std::stop_token stop_;
    std::vector<std::uint32_t> depth_;
};

} // namespace texplorer::reference
