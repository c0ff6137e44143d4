#include "texplorer/reference/level_map.h"

#include "texplorer/reference/asked_unit.h"
#include "texplorer/reference/fragment_walk.h"
#include "texplorer/reference/raster/scene_triangles.h"
#include "texplorer/reference/sampling/cube.h"

#include <algorithm>
#include <cmath>

namespace texplorer::reference {

namespace {

/// Pmax / Pmin of EXT_texture_filter_anisotropic; 1 where nothing changes from pixel to pixel.
float ratioOf(const Lod& lod) {
    const double longer = std::max(lod.lengthX, lod.lengthY);
    const double shorter = std::min(lod.lengthX, lod.lengthY);
    return std::isfinite(longer) && longer > shorter ? static_cast<float>(longer / shorter) : 1.0F;
}

/// As sampler.cpp chooses.
PixelLevels levelsAt(const SampledTexture& texture, const TexturePlace& place, const SampleOptions& options) {
    const bool isCube = texture.target == Target::CubeMap;
    const Lod lod = levelOfDetail(
        texture, isCube ? cubePlace(place.coords, place.derivatives).derivatives : place.derivatives,
        options);
    LevelChoice choice = chooseLevels(texture, lod);
    if (lod.ellipse && choice.first < lastMipLevel(texture)) { // which averages one level
        choice.second = choice.first;
        choice.share = 0;
    }
    return {lod.lambda,
            ratioOf(lod),
            choice.share,
            static_cast<std::uint8_t>(choice.first),
            static_cast<std::uint8_t>(choice.second),
            static_cast<std::uint16_t>(lod.probes)};
}

} // namespace

const PixelLevels* LevelMap::at(int x, int y) const {
    if (x < 0 || y < 0 || x >= width || y >= height)
        return nullptr;
    const PixelLevels& pixel =
        pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    return pixel.isSampled() ? &pixel : nullptr;
}

bool LevelMap::isMagnified(const PixelLevels& pixel) const {
    return !(pixel.lambda > (zeroSwitchOver ? 0 : switchOverOf(sampler.magFilter, sampler.minFilter)));
}

Result<LevelMap> findLevels(const DrawRequest& request, const LevelQuestion& question,
                            const DrawOptions& options, TextureStore& textures) {
    const Scene& scene = request.scene;
    const Viewport viewport{request.width, request.height, request.cornerBits};
    const auto stopped = [] { return fail(ErrorCode::Cancelled, "the search was stopped"); };
    LevelMap map;
    const std::vector<PassState> passes = passStates(scene, request.images, request.time, options.levels,
                                                     request.sampling(), textures, map.problems);
    if (options.isStopped())
        return stopped();
    const Result<const UnitState*> unit = askedUnit(passes, question.pass, question.unit);
    if (!unit)
        return fail(unit.error());
    const SampledTexture& texture = *(*unit)->texture;
    map.width = viewport.width;
    map.height = viewport.height;
    map.zeroSwitchOver = request.zeroSwitchOver;
    map.sampler = texture;
    map.lastLevel = lastMipLevel(texture);
    map.pixels.resize(static_cast<std::size_t>(viewport.width) * static_cast<std::size_t>(viewport.height));
    const PassState* asked = &passes[static_cast<std::size_t>(question.pass)];
    FragmentWalk walk(viewport, options.stop);
    eachTriangle(scene, passes, request.time, viewport, options.stop, [&](const Triangle& triangle) {
        if (triangle.pass > asked) // which comes too late to hide anything
            return;
        walk.draw(triangle, [&](std::size_t at, glm::vec2 offset) {
            if (triangle.pass == asked)
                map.pixels[at] =
                    levelsAt(texture, texturePlace(triangle, static_cast<std::size_t>(question.unit), offset),
                             (*unit)->sampling);
        });
    });
    if (options.isStopped())
        return stopped();
    return map;
}

Result<LevelMap> levelMap(const DrawRequest& request, const LevelQuestion& question,
                          const DrawOptions& options) {
    return ReferenceRenderer().levels(request, question, options);
}

Sentence levelsText(const LevelMap& map, const PixelLevels& pixel) {
    if (map.isMagnified(pixel))
        return Sentence("λ = {0:.2f}: magnified, level {1}", pixel.lambda, pixel.first);
    if (pixel.share <= 0)
        return Sentence("λ = {0:.2f}: level {1}", pixel.lambda, pixel.first);
    const int second = std::clamp(static_cast<int>(std::lround(100 * pixel.share)), 1, 99);
    return Sentence("λ = {0:.2f}: {1} % of level {2}, {3} % of level {4}", pixel.lambda, 100 - second,
                    pixel.first, second, pixel.second);
}

Sentence footprintText(const PixelLevels& pixel) {
    if (!std::isfinite(pixel.ratio))
        return N_("footprint without a width");
    if (pixel.samples > 1)
        return Sentence("footprint {0:.1f} : 1, {1} samples along it", pixel.ratio, pixel.samples);
    return Sentence("footprint {0:.1f} : 1", pixel.ratio);
}

} // namespace texplorer::reference
