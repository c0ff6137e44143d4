#include "core/reference/contributions.h"

#include "core/reference/raster/raster.h"
#include "core/reference/raster/scene_triangles.h"
#include "core/reference/raster/shade.h"
#include "core/reference/shading/fragment.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace texplorer::reference {

namespace {

std::string nameOf(const TexelQuestion& question) {
    return fmt::format("passes[{}].units[{}]", question.pass, question.unit);
}

Result<const UnitState*> unitOf(const std::vector<PassState>& passes, const TexelQuestion& question) {
    if (question.pass < 0 || static_cast<std::size_t>(question.pass) >= passes.size())
        return fail(ErrorCode::OutOfRange,
                    fmt::format("there is no pass {}, the scene has {}", question.pass, passes.size()));
    if (question.unit < 0 || question.unit >= maxUnits)
        return fail(ErrorCode::OutOfRange,
                    fmt::format("expected a unit from 0 to {}, found {}", maxUnits - 1, question.unit));
    const UnitState& unit =
        passes[static_cast<std::size_t>(question.pass)].units[static_cast<std::size_t>(question.unit)];
    if (!unit.texture)
        return fail(ErrorCode::Unsupported,
                    nameOf(question) + " samples nothing: it is off, or its texture can't be drawn");
    return &unit;
}

/// A level with one texel around it, which stands for the border.
Result<void> checkTexel(const SampledTexture& texture, const TexelQuestion& question) {
    const auto& [number, index] = question.texel;
    const Level* level = texture.level(number);
    if (!level)
        return fail(ErrorCode::OutOfRange, fmt::format("{} has a texture without a level {}: it has {}",
                                                       nameOf(question), number, texture.levels.size()));
    constexpr std::array names{"i", "j", "k"};
    if (const int face = index.z; texture.target == Target::CubeMap && (face < 0 || face > 5))
        return fail(ErrorCode::OutOfRange,
                    fmt::format("expected k from 0 to 5 for a face of a cube map, found {}", face));
    for (int axis = 0; axis < (texture.target == Target::CubeMap ? 2 : 3); ++axis) {
        const bool used = axis < axesOf(texture.target);
        const int low = used ? -1 : 0;
        const int high = used ? level->size()[axis] : 0; // the border's
        if (index[axis] < low || index[axis] > high)
            return fail(ErrorCode::OutOfRange,
                        fmt::format("expected {} from {} to {} in level {}, its border included, found {}",
                                    names.at(static_cast<std::size_t>(axis)), low, high, number,
                                    index[axis]));
    }
    return {};
}

class Weighing {
public:
    Weighing(Contributions& found, const TexelQuestion& question, const PassState* asked,
             const UnitState& unit, std::stop_token stop)
        : found_(found)
        , question_(question)
        , asked_(asked)
        , unit_(unit)
        , stop_(std::move(stop))
        , depth_(found.weights.size(), farthestDepth) {}

    void draw(const Triangle& triangle) {
        eachCoveredRow(triangle, {0, found_.width - 1, 0, found_.height - 1}, [&](int x, int y, int count) {
            for (const int end = x + count; x < end && !stop_.stop_requested(); ++x)
                draw(triangle, x, y);
        });
    }

private:
    void draw(const Triangle& triangle, int x, int y) {
        const Pass& pass = *triangle.pass->pass;
        const glm::vec2 offset = glm::vec2(x, y) - triangle.origin;
        const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(found_.width) +
                        static_cast<std::size_t>(x);
        const std::uint32_t depth = pass.depthTest ? fragmentDepth(triangle, offset) : 0;
        if (pass.depthTest && !passes(pass.depthFunc, depth, depth_[at]))
            return;
        if (pass.alphaTest &&
            !passes(pass.alphaFunc, fragmentColor(triangle, offset).a, std::clamp(pass.alphaRef, 0.0F, 1.0F)))
            return;
        if (pass.depthTest)
            depth_[at] = depth;
        float weight = 0;
        if (triangle.pass == asked_) {
            const TexturePlace place =
                texturePlace(triangle, static_cast<std::size_t>(question_.unit), offset);
            weight =
                texelWeight(*unit_.texture, place.coords, place.derivatives, unit_.sampling, question_.texel);
        }
        found_.weights[at] = pass.blend ? std::max(found_.weights[at], weight) : weight;
    }

    Contributions& found_;
    const TexelQuestion& question_;
    const PassState* asked_;
    const UnitState& unit_;
    std::stop_token stop_;
    std::vector<std::uint32_t> depth_;
};

} // namespace

Result<Contributions> findContributions(const DrawRequest& request, const TexelQuestion& question,
                                        const DrawOptions& options, TextureStore& textures) {
    const auto& [scene, images, time, width, height, anisotropy] = request;
    const Viewport viewport{width, height};
    const auto stopped = [] { return fail(ErrorCode::Cancelled, "the search was stopped"); };
    Contributions found;
    const std::vector<PassState> passes =
        passStates(scene, images, time, options.levels, anisotropy, textures, found.problems);
    if (options.isStopped())
        return stopped();
    const Result<const UnitState*> unit = unitOf(passes, question);
    if (!unit)
        return fail(unit.error());
    if (const Result<void> texel = checkTexel(*(*unit)->texture, question); !texel)
        return fail(texel.error());
    found.width = viewport.width;
    found.height = viewport.height;
    found.weights.resize(static_cast<std::size_t>(viewport.width) *
                         static_cast<std::size_t>(viewport.height));
    Weighing weighing(found, question, &passes[static_cast<std::size_t>(question.pass)], **unit,
                      options.stop);
    eachTriangle(scene, passes, time, viewport, options.stop,
                 [&](const Triangle& triangle) { weighing.draw(triangle); });
    if (options.isStopped())
        return stopped();
    return found;
}

Result<Contributions> contributions(const DrawRequest& request, const TexelQuestion& question,
                                    const DrawOptions& options) {
    return ReferenceRenderer().contributions(request, question, options);
}

} // namespace texplorer::reference
