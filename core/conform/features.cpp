#include "texplorer/conform/feature.h"
#include "texplorer/conform/scenes.h"

#include <algorithm>
#include <array>

namespace texplorer::conform {

namespace {

constexpr std::array rows{
    Feature{"coverage", "shapes, projections, sizes, without texture", "3.5.1", 72, scenes::coverage,
            rules::outline, rules::outline},
    Feature{"depth", "depth functions, three intersecting models", "4.1.6", 48, scenes::depth, rules::outline,
            rules::outline},
    Feature{"lighting", "shade models, colour control, viewer, directional or positional light", "2.14.1", 64,
            scenes::lighting, rules::outline, rules::outline},
    Feature{"specular", "separate specular over each environment mode", "3.9", 40, scenes::separateSpecular,
            rules::texelEdge, rules::lastBit},
    Feature{"two-sided", "open shapes from both sides, shade models, colour control", "2.14.1", 48,
            scenes::twoSided, rules::outline, rules::outline},
    Feature{"fog", "modes, projections, densities and ranges, lit or not", "3.10", 64, scenes::fog,
            rules::outline, rules::outline},
    Feature{"lines", "points and lines of every primitive, odd widths, colours, textures", "3.3, 3.4", 72,
            scenes::lines, rules::lines, rules::outline},
    Feature{"meshes", "every other primitive: normals, colours, indices, flat and smooth", "2.6.1", 72,
            scenes::meshes, rules::outline, rules::outline},
    Feature{"quadrics", "cylinders, cones, disks, parts of disks, tori, teapots", "3.5.1", 48,
            scenes::quadrics, rules::outline, rules::outline},
    Feature{"materials", "colour material or not, ambient, diffuse, emission, one for each model", "2.14.3",
            48, scenes::materials, rules::outline, rules::outline},
    Feature{"placement", "orders of rotation, scales of each axis, in the world or fixed to the eye, roll",
            "2.11.2", 48, scenes::placement, rules::outline, rules::outline},
    Feature{"environment", "modes × base formats", "3.8.13", 144, scenes::environment, rules::exact,
            rules::exact},
    Feature{"internal-formats", "formats of few bits and of sRGB × filters × wrap modes", "3.8.1", 112,
            scenes::internalFormats, rules::texelEdge, rules::exact},
    Feature{"float-formats", "formats of floats × filters × modes; texels beyond 0 and 1", "3.8.13", 96,
            scenes::floatFormats, rules::texelEdge, rules::exact},
    Feature{"preparation", "one to three operations on the image before its levels are made", "3.6.5", 132,
            scenes::preparation, rules::exact, rules::exact},
    Feature{"upload", "formats × types × alignments, row lengths, scale and bias, that fit the memory or not",
            "3.6.4", 132, scenes::upload, rules::exact, rules::exact},
    Feature{"depth-textures", "compare functions × depth modes, bits, filters, 1D and 2D; r beyond 0 and 1",
            "3.8.14", 96, scenes::depthTextures, rules::texelEdge, rules::exact},
    Feature{"combine", "functions, sources, operands, scales, on one to three units", "3.8.13", 112,
            scenes::combine, rules::exact, rules::exact},
    Feature{"units", "two to four units of any mode, format and texture", "3.8.13", 72, scenes::units,
            rules::exact, rules::exact},
    Feature{"wrap", "wrap modes of s × t × r, 1D, 2D and 3D, nearest", "3.8.7", 100, scenes::wrap,
            rules::exact, rules::exact},
    Feature{"wrap-linear", "the same, linear: borders blend in", "3.8.7", 100, scenes::wrapLinear,
            rules::texelEdge, rules::exact},
    Feature{"texgen-linear", "object and eye planes of s, t and r, models that have moved", "2.11.4", 72,
            scenes::linearTexGen, rules::exact, rules::exact},
    Feature{"texgen-maps", "every mode of s and t, generated q, a texture matrix after it", "2.11.4", 64,
            scenes::mappedTexGen, rules::texelEdgeOnQuads, rules::lastBit},
    Feature{"texgen-shapes", "every mode on every shape", "2.11.4", 64, scenes::texGenOnShapes,
            rules::texelEdge, rules::lastBit},
    Feature{"matrix", "texture matrix: pairs of steps, pivots, and a q for each vertex", "2.11.2", 144,
            scenes::matrix, rules::texelEdgeOnQuads, rules::lastBit},
    Feature{"matrix-stack", "texture matrices of models, pushed or not, and what passes leave on the stack",
            "2.11.2", 72, scenes::matrixStack, rules::texelEdgeOnQuads, rules::lastBit},
    Feature{"projector", "the projector in the matrix: slides and shadows × wrap × filters × shapes",
            "2.11.2, 3.8.14", 80, scenes::projector, rules::texelEdge, rules::lastBit},
    Feature{"subimages", "one to three replaced parts, that fit or not", "3.8.2", 48, scenes::subimages,
            rules::exact, rules::exact},
    Feature{"pictures", "pictures of passes × wrap × base formats, of themselves too", "3.8.2", 48,
            scenes::pictures, rules::passes, rules::exact},
    Feature{"emboss", "coordinates that follow the light, by either matrix, at a place or not", "2.7", 48,
            scenes::emboss, rules::texelEdge, rules::lastBit},
    Feature{"nearest", "GL_NEAREST × wrap × shapes", "3.8.8", 72, scenes::nearest, rules::texelEdge,
            rules::lastBit},
    Feature{"linear", "GL_LINEAR × wrap × shapes", "3.8.8", 48, scenes::linear, rules::texelEdge,
            rules::lastBit},
    Feature{"magnification", "different filters near and far × wrap × shapes", "3.8.9", 24,
            scenes::magnification, rules::levelChoice, rules::lastBit},
    Feature{"mipmap-nearest", "*_MIPMAP_NEAREST × magnification × wrap × shapes", "3.8.8", 80,
            scenes::mipmapNearest, rules::levelChoice, rules::lastBit},
    Feature{"trilinear", "*_MIPMAP_LINEAR × magnification × wrap × shapes", "3.8.8", 80, scenes::trilinear,
            rules::levelBlend, rules::lastBit},
    Feature{"lod", "bias, limits of lambda, base and max level × *_MIPMAP_NEAREST", "3.8.8", 64,
            scenes::lodOfOneLevel, rules::levelChoice, rules::lastBit},
    Feature{"lod-trilinear", "bias, limits of lambda, base and max level × *_MIPMAP_LINEAR", "3.8.8", 64,
            scenes::lodOfTwoLevels, rules::levelBlend, rules::lastBit},
    Feature{"levels", "base and max level, min and max LOD, valid or not, missing levels × filters", "3.8.10",
            64, scenes::levelSettings, rules::levelBlend, rules::lastBit},
    Feature{"anisotropy", "2x to 16x, linear", "EXT_texture_filter_anisotropic", 32, scenes::anisotropy,
            rules::ellipse, rules::lastBit},
    Feature{"targets", "1D and 3D textures on every shape, linear", "3.8.1", 48, scenes::targets,
            rules::texelEdge, rules::lastBit},
    Feature{"cube-map", "reflection and normal maps on shapes, wrap modes, nearest and linear", "3.8.6", 64,
            scenes::cubeMap, rules::texelEdge, rules::lastBit},
    Feature{"seamless", "cube maps of few texels, filtered across their edges × wrap modes × levels",
            "ARB_seamless_cube_map", 64, scenes::seamless, rules::texelEdge, rules::lastBit},
    Feature{"border", "images with a border × wrap × filters", "3.8.1", 32, scenes::border, rules::texelEdge,
            rules::exact},
    Feature{"hint", "coordinates without perspective × wrap × shapes", "5.6", 24, scenes::hint,
            rules::texelEdge, rules::lastBit},
    Feature{"compression", "S3TC formats, made by Texplorer and by the driver", "3.8.3", 32,
            scenes::compression, rules::blocks, rules::exact},
    Feature{"incomplete", "missing mip levels × filters", "3.8.10", 32, scenes::incomplete, rules::exact,
            rules::exact},
    Feature{"given-levels", "a picture for each level: complete, too few, of another size × filters",
            "3.8.10", 72, scenes::givenLevels, rules::foreignLevels, rules::lastBit},
    Feature{"alpha-test", "functions and references", "4.1.4", 64, scenes::alphaTest, rules::exact,
            rules::exact},
    Feature{"blend", "factors of source × destination", "4.1.8", 80, scenes::blend, rules::exact,
            rules::exact},
    Feature{"passes",
            "two and three passes of two units, of some models in any order, depth equal, blended, some off",
            "4.1", 60, scenes::passes, rules::passes, rules::exact},
    Feature{"mixture", "anything with anything, several units and passes", "2.11 to 4.1", 48, scenes::mixture,
            rules::levelBlend, rules::lastBit},
};

constexpr int sumOfWeights() {
    int sum = 0;
    for (const Feature& row : rows)
        sum += row.scenes;
    return sum;
}
static_assert(rows.size() == 51 && sumOfWeights() == defaultScenes);

} // namespace

std::span<const Feature> features() {
    return rows;
}

const Feature* findFeature(std::string_view name) {
    const auto found = std::ranges::find(rows, name, &Feature::name);
    return found == rows.end() ? nullptr : &*found;
}

} // namespace texplorer::conform
