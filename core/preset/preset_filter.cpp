// Filters, wrap modes and levels: each trouble, and its cure.

#include "texplorer/preset/preset_rows.h"

#include <array>

namespace texplorer::preset {
namespace {

constexpr std::string_view filterGroup = N_("Filters, levels and seams");

/// With a checkerboard or a picture from a file, trilinear: the levels are visible.
void showTrilinearFloor(const PresetTarget& target) {
    showFloor(target);
    showPatternUnless(target.texture, Pattern::Checker, !isDrawn(target.texture.source));
    filterTrilinear(target.texture);
}

Result<void> shimmer(const PresetTarget& target) {
    showFloor(target);
    showPatternUnlessOwn(target.texture, Pattern::Checker);
    target.texture.minFilter = MinFilter::Nearest;
    target.texture.maxAnisotropy = 1;
    target.texture.wrapS = target.texture.wrapT = Wrap::Repeat;
    target.unit.matrix = {{.op = MatrixOp::Translate, .rate = {0, 0.3F, 0}}};
    return {};
}

Result<void> shimmerCure(const PresetTarget& target) {
    filterTrilinear(target.texture);
    return {};
}

/// Begins with a level of so few texels that one sees each of them.
void showFewTexels(const PresetTarget& target, Pattern pattern) {
    showPattern(target.texture, pattern);
    filterTrilinear(target.texture);
    target.texture.baseLevel = 4;
    takeGivenCoordinates(target.unit);
}

Result<void> blocks(const PresetTarget& target) {
    showFewTexels(target, Pattern::Tree);
    target.texture.magFilter = MagFilter::Nearest;
    return {};
}

Result<void> blocksCure(const PresetTarget& target) {
    target.texture.magFilter = MagFilter::Linear;
    return {};
}

Result<void> seam(const PresetTarget& target) {
    showFewTexels(target, Pattern::Brick);
    Texture& texture = target.texture;
    texture.minFilter = MinFilter::Linear;
    texture.wrapS = texture.wrapT = Wrap::Clamp;
    texture.borderColor = {1, 0, 1, 1};
    return {};
}

Result<void> seamCure(const PresetTarget& target) {
    target.texture.wrapS = target.texture.wrapT = Wrap::ClampToEdge;
    return {};
}

/// The middle one of the faces, of 128 x 128 texels, in levels from that of 4 x 4 texels on, in pure colours.
/// `inset`: in texels of the image.
void showTile(const PresetTarget& target, float inset) {
    showPattern(target.texture, Pattern::CubeFaces);
    target.texture.preparation = {
        {.op = ImageOp::Scale, .factor = {16, 16, 16, 1}, .bias = {-9.5F, -9.5F, -7.5F, 0}}};
    filterTrilinear(target.texture);
    target.texture.baseLevel = 5;
    takeGivenCoordinates(target.unit);
    target.unit.envMode = EnvMode::Replace;
    const glm::vec2 image{512, 384};
    const glm::vec2 low = (glm::vec2(128) + inset) / image;
    const glm::vec2 high = (glm::vec2(256) - inset) / image;
    showSquare(target.scene).texCoords[target.place.unit] = {
        {low.x, low.y, 0, 1}, {high.x, low.y, 0, 1}, {high.x, high.y, 0, 1}, {low.x, high.y, 0, 1}};
}

Result<void> atlas(const PresetTarget& target) {
    showTile(target, 0);
    return {};
}

Result<void> atlasCure(const PresetTarget& target) {
    showTile(target, 16); // half a texel of the base level
    target.texture.maxLevel = target.texture.baseLevel;
    return {};
}

Result<void> colouredLevels(const PresetTarget& target) {
    showTrilinearFloor(target);
    target.texture.mipmaps = MipPolicy::Colored;
    return {};
}

Result<void> anisotropy(const PresetTarget& target) {
    showTrilinearFloor(target);
    target.texture.maxAnisotropy = 16;
    return {};
}

constexpr std::array filterRows{
    Preset{"shimmer", filterGroup, N_("Shimmer"),
           N_("A moving checkerboard that recedes into the distance, with GL_NEAREST minification."),
           N_("Far squares turn into flickering noise: each pixel reads one texel of many."), shimmer},
    Preset{
        "shimmer-cure", filterGroup, N_("Shimmer, cured"),
        N_("Mipmaps, and GL_LINEAR_MIPMAP_LINEAR, for the texture of this unit."),
        N_("Far away the texture fades to its mean: each pixel reads a level with texels of its own size."),
        shimmerCure, true},
    Preset{"blocks", filterGroup, N_("Blocky magnification"),
           N_("An image of 16 × 16 texels, with GL_NEAREST magnification."),
           N_("Each texel is a block of pixels: a magnified texture has no finer detail."), blocks},
    Preset{"blocks-cure", filterGroup, N_("Blocky magnification, cured"),
           N_("GL_LINEAR magnification for the texture of this unit."),
           N_("The blocks blend into each other: smooth, but no sharper than the texels."), blocksCure, true},
    Preset{"seam", filterGroup, N_("Seam of GL_CLAMP"),
           N_("GL_CLAMP with GL_LINEAR, an image of 16 × 16 texels and a magenta border colour."),
           N_("A magenta seam where the image ends: GL_CLAMP mixes half of the border colour into the edge."),
           seam},
    Preset{"seam-cure", filterGroup, N_("Seam of GL_CLAMP, cured"),
           N_("GL_CLAMP_TO_EDGE for the texture of this unit."),
           N_("The seam is gone: the outermost texels continue, and the border colour is never read."),
           seamCure, true},
    Preset{
        "atlas-bleeding", filterGroup, N_("Bleeding tiles"),
        N_("One tile, of 4 × 4 texels, of an image of several, with GL_LINEAR and mipmaps. Its coordinates "
           "reach its edges."),
        N_("A blue tile with edges in the colours of the tiles around: GL_LINEAR mixes them in within half a "
           "texel, and the texels of each smaller level are twice as wide."),
        atlas},
    Preset{"atlas-bleeding-cure", filterGroup, N_("Bleeding tiles, cured"),
           N_("Coordinates half a texel inside of the tile, and no smaller levels: GL_TEXTURE_MAX_LEVEL."),
           N_("The tile has only its own colours. Programs with smaller levels leave room between tiles."),
           atlasCure, true},
    Preset{"coloured-levels", filterGroup, N_("Coloured mip levels"),
           N_("A floor that recedes into the distance. Each level above the base has its own colour."),
           N_("Each band of colour is a level. Change the LOD bias, and the bands move."), colouredLevels},
    Preset{"anisotropy", filterGroup, N_("Anisotropy on a far floor"),
           N_("A trilinear floor that recedes into the distance, with GL_TEXTURE_MAX_ANISOTROPY_EXT 16."),
           N_("The board stays sharp far into the distance: more samples along the footprint of each pixel."),
           anisotropy},
};

} // namespace

std::span<const Preset> filterPresets() {
    return filterRows;
}

} // namespace texplorer::preset
