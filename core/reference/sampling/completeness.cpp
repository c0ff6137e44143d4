#include "core/reference/sampling/completeness.h"

#include "core/reference/sampling/lod.h"

#include <algorithm>

namespace texplorer::reference {

namespace {

std::string number(int value) {
    return std::to_string(value);
}

std::string extents(glm::ivec3 size, int axes) {
    std::string text = number(size.x);
    for (int axis = 1; axis < axes; ++axis)
        text += " x " + number(size[axis]);
    return text;
}

/// A cube map is cube complete where its six base levels are squares of one size (and one format, which ours
/// always have).
Completeness checkFaces(const SampledTexture& texture, int number) {
    const Level* first = texture.level(number);
    if (texture.target != Target::CubeMap)
        return {};
    const std::string incomplete = "the texture is incomplete: ";
    if (first->width != first->height)
        return {CompletenessRule::CubeFaces, number,
                incomplete + "the faces of a cube map must be square, and they have " +
                    extents(first->size(), 2) + " texels"};
    for (int face = 1; face < facesOf(texture.target); ++face) {
        const Level* level = texture.level(number, face);
        const std::string name(rowOf(cubeFaceAt(face)).label);
        if (!level)
            return {CompletenessRule::CubeFaces, number,
                    incomplete + "a cube map has six faces, and " + name + " is missing"};
        if (level->size() != first->size() || level->border != first->border)
            return {CompletenessRule::CubeFaces, number,
                    incomplete + "the faces of a cube map must have one size; +x has " +
                        extents(first->size(), 2) + " texels and " + name + " " + extents(level->size(), 2)};
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
                "the texture is incomplete: its base level is " + number(first) +
                    ", and there is no such level"};
    if (Completeness faces = checkFaces(texture, first); !faces.complete())
        return faces;
    if (!wantsMipmaps(texture.minFilter))
        return {};

    const std::string filter(rowOf(texture.minFilter).name);
    if (first > texture.maxLevel)
        return {Rule::BaseAboveMaxLevel, first,
                "the texture is incomplete: its base level " + number(first) + " exceeds its maximal level " +
                    number(texture.maxLevel) + ", and " + filter + " uses the levels between them"};
    const int last = lastMipLevel(texture);
    for (int face = 0; face < facesOf(texture.target); ++face) {
        for (int at = first + 1; at <= last; ++at) {
            const Level* level = texture.level(at, face);
            if (!level)
                return {Rule::LevelMissing, at,
                        "the texture is incomplete: " + filter + " needs the levels " + number(first) +
                            " to " + number(last) + ", and level " + number(at) +
                            " is missing; generate mipmaps, or choose " +
                            std::string(rowOf(MinFilter::Linear).name)};
            glm::ivec3 expected(1);
            for (int axis = 0; axis < axes; ++axis)
                expected[axis] = std::max(1, base->size()[axis] >> (at - first));
            glm::ivec3 found = level->size();
            for (int axis = axes; axis < 3; ++axis)
                found[axis] = 1;
            if (found != expected)
                return {Rule::LevelSize, at,
                        "the texture is incomplete: level " + number(at) + " should have " +
                            extents(expected, axes) + " texels and has " + extents(found, axes)};
            if (level->border != base->border)
                return {Rule::LevelBorder, at,
                        "the texture is incomplete: level " + number(at) + " has a border of " +
                            number(level->border) + " and the base level one of " + number(base->border)};
        }
    }
    return {};
}

} // namespace texplorer::reference
