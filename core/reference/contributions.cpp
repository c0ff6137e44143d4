#include "texplorer/reference/contributions.h"

#include "texplorer/reference/asked_unit.h"
#include "texplorer/reference/fragment_walk.h"
#include "texplorer/reference/raster/scene_triangles.h"

#include <algorithm>
#include <array>

namespace texplorer::reference {

namespace {

/// A level with one texel around it, which stands for the border.
Result<void> checkTexel(const SampledTexture& texture, const TexelQuestion& question) {
    const auto& [number, index] = question.texel;
    const Level* level = texture.level(number);
    if (!level)
        return fail(ErrorCode::OutOfRange,
                    Sentence("{0} has a texture without a level {1}: it has {2}",
                             unitName(question.pass, question.unit), number, texture.levels.size()));
    constexpr std::array names{"i", "j", "k"};
    if (const int face = index.z; texture.target == Target::CubeMap && (face < 0 || face > 5))
        return fail(ErrorCode::OutOfRange,
                    Sentence("expected k from 0 to 5 for a face of a cube map, found {0}", face));
    for (int axis = 0; axis < (texture.target == Target::CubeMap ? 2 : 3); ++axis) {
        const bool used = axis < axesOf(texture.target);
        const int low = used ? -1 : 0;
        const int high = used ? level->size()[axis] : 0; // the border's
        if (index[axis] < low || index[axis] > high)
            return fail(ErrorCode::OutOfRange,
                        Sentence("expected {0} from {1} to {2} in level {3}, its border included, found {4}",
                                 names.at(static_cast<std::size_t>(axis)), low, high, number, index[axis]));
    }
    return {};
}

} // namespace

Result<Contributions> findContributions(const DrawRequest& request, const TexelQuestion& question,
                                        const DrawOptions& options, TextureStore& textures) {
    const Scene& scene = request.scene;
    const Viewport viewport{request.width, request.height, request.cornerBits};
    const auto stopped = [] { return fail(ErrorCode::Cancelled, "the search was stopped"); };
    Contributions found;
    const std::vector<PassState> passes = passStates(scene, request.images, request.time, options.levels,
                                                     request.sampling(), textures, found.problems);
    if (options.isStopped())
        return stopped();
    const Result<const UnitState*> unit = askedUnit(passes, question.pass, question.unit);
    if (!unit)
        return fail(unit.error());
    if (const Result<void> texel = checkTexel(*(*unit)->texture, question); !texel)
        return fail(texel.error());
    found.width = viewport.width;
    found.height = viewport.height;
    found.weights.resize(static_cast<std::size_t>(viewport.width) *
                         static_cast<std::size_t>(viewport.height));
    const PassState* asked = &passes[static_cast<std::size_t>(question.pass)];
    FragmentWalk walk(viewport, options.stop);
    eachTriangle(scene, passes, request.time, viewport, options.stop, [&](const Triangle& triangle) {
        walk.draw(triangle, [&](std::size_t at, glm::vec2 offset) {
            float weight = 0;
            if (triangle.pass == asked) {
                const TexturePlace place =
                    texturePlace(triangle, static_cast<std::size_t>(question.unit), offset);
                weight = texelWeight(*(*unit)->texture, place.coords, place.derivatives, (*unit)->sampling,
                                     question.texel);
            }
            found.weights[at] = triangle.pass->pass->blend ? std::max(found.weights[at], weight) : weight;
        });
    });
    if (options.isStopped())
        return stopped();
    return found;
}

Result<Contributions> contributions(const DrawRequest& request, const TexelQuestion& question,
                                    const DrawOptions& options) {
    return ReferenceRenderer().contributions(request, question, options);
}

} // namespace texplorer::reference
