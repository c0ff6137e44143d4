#include "texplorer/reference/sampling/completeness.h"

#include "texplorer/reference/sampling/lod.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::reference {

namespace {

std::string extents(glm::ivec3 size, int axes) {
    std::string text = std::to_string(size.x);
    for (int axis = 1; axis < axes; ++axis)
        text += fmt::format(" × {}", size[axis]);
    return text;
}

/// A cube map is cube complete where its six base levels are squares of one size (and one format, which ours
/// always have).
Completeness checkFaces(const SampledTexture& texture, int number) {
    const Level* first = texture.level(number);
    if (texture.target != Target::CubeMap)
        return {};
    if (first->width != first->height)
        return {
            CompletenessRule::CubeFaces, number,
            Sentence(
                "the texture is incomplete: the faces of a cube map must be square, and they have {0} texels",
                ProperName{extents(first->size(), 2)})};
    for (int face = 1; face < facesOf(texture.target); ++face) {
        const Level* level = texture.level(number, face);
        const std::string name(rowOf(cubeFaceAt(face)).label);
        if (!level)
            return {
                CompletenessRule::CubeFaces, number,
                Sentence("the texture is incomplete: a cube map has six faces, and {0} is missing", name)};
        if (level->size() != first->size() || level->border != first->border)
            return {
                CompletenessRule::CubeFaces, number,
                Sentence(
                    "the texture is incomplete: the faces of a cube map must have one size; +x has {0} texels "
                    "and {1} {2}",
                    ProperName{extents(first->size(), 2)}, name, ProperName{extents(level->size(), 2)})};
    }
    return {};
}

} // namespace

Completeness checkCompleteness(const SampledTexture& texture) {
    using Rule = CompletenessRule;
    const int axes = axesOf(texture.target);
    const int first = texture.baseLevel;
    const Level* base = texture.level(first);
    if (!base)
        return {Rule::BaseLevelMissing, first,
                Sentence("the texture is incomplete: its base level is {0}, which does not exist", first)};
    if (Completeness faces = checkFaces(texture, first); !faces.complete())
        return faces;
    if (!wantsMipmaps(texture.minFilter))
        return {};

    const std::string filter(rowOf(texture.minFilter).name);
    if (first > texture.maxLevel)
        return {
            Rule::BaseAboveMaxLevel, first,
            Sentence(
                "the texture is incomplete: its base level {0} exceeds its maximal level {1}, and {2} uses the "
                "levels between them",
                first, texture.maxLevel, ProperName{filter})};
    const int last = lastMipLevel(texture);
    for (int face = 0; face < facesOf(texture.target); ++face) {
        for (int at = first + 1; at <= last; ++at) {
            const Level* level = texture.level(at, face);
            if (!level)
                return {
                    Rule::LevelMissing, at,
                    Sentence(
                        "the texture is incomplete: {0} needs the levels {1} to {2}, and level {3} is missing; "
                        "generate mipmaps, or choose {4}",
                        ProperName{filter}, first, last, at, ProperName{rowOf(MinFilter::Linear).name})};
            glm::ivec3 expected(1);
            for (int axis = 0; axis < axes; ++axis)
                expected[axis] = std::max(1, base->size()[axis] >> (at - first));
            glm::ivec3 found = level->size();
            for (int axis = axes; axis < 3; ++axis)
                found[axis] = 1;
            if (found != expected)
                return {Rule::LevelSize, at,
                        Sentence("the texture is incomplete: level {0} should have {1} texels and has {2}",
                                 at, ProperName{extents(expected, axes)}, ProperName{extents(found, axes)})};
            if (level->border != base->border)
                return {
                    Rule::LevelBorder, at,
                    Sentence(
                        "the texture is incomplete: level {0} has a border of {1} and the base level one of {2}",
                        at, level->border, base->border)};
        }
    }
    return {};
}

} // namespace texplorer::reference
