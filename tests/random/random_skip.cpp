#include "tests/random/random_skip.h"

#include "core/conform/skip.h"

#include <algorithm>
#include <array>

namespace texplorer::random {

namespace {

bool anyUnit(const Scene& scene, auto condition) {
    return std::ranges::any_of(scene.passes, [&](const Pass& pass) {
        return std::ranges::any_of(pass.units, [&](const Unit& unit) {
            return unit.enabled && condition(unit, scene.textures[static_cast<std::size_t>(unit.texture)]);
        });
    });
}

constexpr std::array rows{
    RandomSkip{"wild-numbers",
               [](const RandomScene& random, const conform::Pair& pair) {
                   return random.temper != Temper::Ordinary && pair.has(RendererKind::Reference);
               },
               "numbers at their limits leave a float's 24 bits no texel to tell"},
    RandomSkip{"anisotropy",
               [](const RandomScene& random, const conform::Pair& pair) {
                   return pair.has(RendererKind::Reference) &&
                          anyUnit(random.scene, [](const Unit&, const Texture& texture) {
                              return texture.maxAnisotropy > 1;
                          });
               },
               "EXT_texture_filter_anisotropic leaves the method open: it has a rule and scenes of its own in "
               "the sweep"},
};

} // namespace

std::span<const RandomSkip> randomSkips() {
    return rows;
}

Skipped skipOf(const RandomScene& scene, const conform::Pair& pair, const conform::Driver& driver) {
    if (const conform::Skip* skip = conform::skipOf(scene.scene, pair, driver))
        return {skip->name, skip->reason};
    const auto found =
        std::ranges::find_if(rows, [&](const RandomSkip& row) { return row.applies(scene, pair); });
    return found == rows.end() ? Skipped{} : Skipped{found->name, found->reason};
}

} // namespace texplorer::random
