#include "tests/random/random_skip.h"

#include "texplorer/conform/skip.h"
#include "texplorer/reference/raster/triangle.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/model_mesh.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace texplorer::random {

namespace {

bool anyTexture(const Scene& scene, auto condition) {
    return std::ranges::any_of(scene.textures, condition);
}

bool isFound(const Comparison& comparison, std::string_view rule) {
    return std::ranges::find(comparison.findings, rule, &Finding::rule) != comparison.findings.end();
}

bool runsThroughZero(const TexCoords& list) {
    return std::ranges::any_of(list, [](const glm::vec4& each) { return each.q <= 0; });
}

/// Whether a matrix makes a q of its own out of the other coordinates.
bool mixesQ(const MatrixStep& step) {
    if (step.op != MatrixOp::Multiply && step.op != MatrixOp::Load)
        return false;
    return glm::transpose(step.matrix)[3] != glm::vec4(0, 0, 0, 1);
}

/// Whether a q is generated or comes out of a matrix, or some vertex has one that isn't above 0.
bool mayRunThroughZero(const Scene& scene) {
    return std::ranges::any_of(
               scene.passes,
               [](const Pass& pass) {
                   return pass.enabled && std::ranges::any_of(pass.units, [](const Unit& unit) {
                              return unit.enabled &&
                                     (unit.texGenQ.enabled || std::ranges::any_of(unit.matrix, mixesQ));
                          });
               }) ||
           std::ranges::any_of(scene.models, [](const Model& model) {
               return std::ranges::any_of(model.texCoords, runsThroughZero) ||
                      runsThroughZero(model.mesh.texCoords) ||
                      std::ranges::any_of(model.units, [](const ModelUnit& unit) {
                          return std::ranges::any_of(unit.matrix, mixesQ);
                      });
           });
}

bool anyDrawn(const Scene& scene, auto condition) {
    return std::ranges::any_of(scene.passes, [&](const Pass& pass) {
        return std::ranges::any_of(drawnModels(scene, pass),
                                   [&](std::size_t model) { return condition(scene.models[model]); });
    });
}

bool hasThinLines(const Model& model) {
    const Primitive primitive = model.mesh.primitive;
    const bool lines = primitive == Primitive::Lines || primitive == Primitive::LineStrip ||
                       primitive == Primitive::LineLoop;
    return model.shape == Shape::Mesh && lines && reference::roundedSize(model.lineWidth) == 1;
}

bool isFar(const glm::vec3& position) {
    const glm::vec3 amount = glm::abs(position);
    return std::max({amount.x, amount.y, amount.z}) > 1e5F;
}

/// Whether a depth test decides over parts with a vertex so far away that a float's bits leave their depths
/// no difference.
bool comparesFarDepths(const Scene& scene) {
    return std::ranges::any_of(scene.passes,
                               [](const Pass& pass) { return pass.enabled && pass.depthTest; }) &&
           anyDrawn(scene, [](const Model& model) {
               return model.shape == Shape::Mesh && std::ranges::any_of(model.mesh.positions, isFar);
           });
}

/// Whether a point's size is so near to half a pixel that it is rounded either way.
bool isHalfAPoint(const Model& model) {
    const float fraction = model.pointSize - std::floor(model.pointSize);
    return model.shape == Shape::Mesh && model.mesh.primitive == Primitive::Points &&
           std::abs(fraction - 0.5F) < 1.0F / 128;
}

constexpr std::array rows{
    RandomSkip{"wild-numbers",
               [](const Comparison& each) {
                   return each.random.temper > Temper::Ordinary && each.pair.has(RendererKind::Reference);
               },
               "numbers at their limits leave a float's 24 bits no texel to tell"},
    RandomSkip{"far-vertices",
               [](const Comparison& each) {
                   return each.random.temper > Temper::Ordinary && comparesFarDepths(each.random.scene);
               },
               "where a part reaches beyond 100,000, two vertex programs round its depths to either side of "
               "what another pass left there"},
    RandomSkip{
        "anisotropy",
        [](const Comparison& each) {
            return each.pair.has(RendererKind::Reference) &&
                   anyTexture(each.random.scene,
                              [](const Texture& texture) { return texture.maxAnisotropy > 1; });
        },
        "EXT_texture_filter_anisotropic leaves the method open: it has a rule and scenes of its own in "
        "the sweep"},
    RandomSkip{
        "q-through-zero", [](const Comparison& each) { return mayRunThroughZero(each.random.scene); },
        "where q changes its sign, coordinates have no bound, and no bit of theirs is right; the sweep has "
        "scenes whose q stays above 0"},
    RandomSkip{
        "drawn-twice",
        [](const Comparison& each) {
            return each.driver.name.starts_with("llvmpipe") && anyDrawn(each.random.scene, drawsAPartTwice);
        },
        "llvmpipe's depth of a part that is drawn again, from another corner on, differs in its last bit; so it is "
        "with a torus of two stacks, which is flat"},
    RandomSkip{
        "thin-lines",
        [](const Comparison& each) {
            return each.pair.has(RendererKind::Reference) && each.driver.name.starts_with("llvmpipe") &&
                   anyDrawn(each.random.scene, hasThinLines);
        },
        "along a line of one pixel llvmpipe interpolates by its longer axis, while equation 3.5 of "
        "OpenGL 2.1 projects the centre of the pixel on it: the sweep has thin lines without textures"},
    RandomSkip{"half-points",
               [](const Comparison& each) {
                   return each.pair.has(RendererKind::Reference) && anyDrawn(each.random.scene, isHalfAPoint);
               },
               "OpenGL 2.1, section 3.3, doesn't say which way a point size of half a pixel is rounded"},
    RandomSkip{"undefined-crossbar",
               [](const Comparison& each) { return isFound(each, "undefined-crossbar"); },
               "GL_COMBINE reads the texture of a unit that is off or incomplete, which is undefined (OpenGL "
               "2.1, section 3.8.13)"},
    RandomSkip{
        "lod-range", [](const Comparison& each) { return isFound(each, "lod-range"); },
        "lambda is undefined where its lower limit is above the upper one (OpenGL 2.1, section 3.8.8)"},
    RandomSkip{
        "zero-q",
        [](const Comparison& each) { return isFound(each, "zero-q") || isFound(each, "zero-q-of-vertex"); },
        "a coordinate divided by 0 is no place in an image"},
};

} // namespace

std::span<const RandomSkip> randomSkips() {
    return rows;
}

Skipped skipOf(const Comparison& comparison) {
    const auto& [random, findings, pair, driver] = comparison;
    if (const conform::Skip* skip = conform::skipOf(random.scene, pair, driver))
        return {skip->name, skip->reason};
    const auto found =
        std::ranges::find_if(rows, [&](const RandomSkip& row) { return row.applies(comparison); });
    return found == rows.end() ? Skipped{} : Skipped{found->name, found->reason};
}

bool drawsAPartTwice(const Model& model) {
    if (model.shape == Shape::Torus)
        return model.stacks <= minStacks;
    if (model.shape != Shape::Mesh)
        return false;
    const Mesh mesh = meshOf(model);
    const auto anyTwice = [](const std::vector<std::uint32_t>& indices, std::size_t corners) {
        std::set<std::vector<std::uint32_t>> seen;
        for (std::size_t i = 0; i + corners <= indices.size(); i += corners) {
            const auto first = indices.begin() + static_cast<std::ptrdiff_t>(i);
            std::vector<std::uint32_t> part(first, first + static_cast<std::ptrdiff_t>(corners));
            std::ranges::sort(part);
            if (!seen.insert(std::move(part)).second)
                return true;
        }
        return false;
    };
    return anyTwice(mesh.triangles, 3) || anyTwice(mesh.lines, 2) || anyTwice(mesh.points, 1);
}

std::string_view reasonOf(std::string_view name) {
    for (const conform::Skip& row : conform::skips()) {
        if (row.name == name)
            return row.reason;
    }
    const auto found = std::ranges::find(rows, name, &RandomSkip::name);
    return found == rows.end() ? std::string_view() : found->reason;
}

} // namespace texplorer::random
