// Environments, and several units one after the other.

#include "texplorer/preset/preset_rows.h"
#include "texplorer/scene/show_shapes.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

namespace texplorer::preset {
namespace {

constexpr std::string_view unitGroup = N_("Environments and several units");

Result<void> decal(const PresetTarget& target) {
    showPatternUnlessOwn(target.texture, Pattern::Tree);
    generateNothing(target.unit);
    target.unit.envMode = EnvMode::Decal;
    target.scene.material.color = {0.95F, 0.6F, 0.2F, 1};
    return {};
}

/// The bricks' heights, trilinear.
Texture heights() {
    Texture texture;
    texture.pattern = Pattern::BrickHeight;
    filterTrilinear(texture);
    return texture;
}

/// A unit that shows them already in this way; nullptr: none.
Unit* unitOfHeights(const PresetTarget& target, bool embossed) {
    const auto found = std::ranges::find_if(target.pass.units, [&](const Unit& unit) {
        const auto texture = static_cast<std::size_t>(unit.texture);
        return unit.enabled && &unit != &target.unit && unit.envMode == EnvMode::Combine &&
               unit.emboss.enabled == embossed && texture < target.scene.textures.size() &&
               target.scene.textures[texture].pattern == Pattern::BrickHeight;
    });
    return found == target.pass.units.end() ? nullptr : &*found;
}

Result<std::size_t> laterUnit(const PresetTarget& target) {
    Result<std::size_t> free = freeUnit(target);
    if (free && *free < target.place.unit)
        return fail(ErrorCode::TooLarge, "all units after this one are in use");
    return free;
}

/// That one, or a free one with a texture of its own.
Result<Unit*> heightsIn(const PresetTarget& target, bool embossed) {
    if (Unit* there = unitOfHeights(target, embossed))
        return there;
    const Result<std::size_t> free = laterUnit(target);
    if (!free)
        return fail(free.error());
    const Result<std::size_t> texture = addTexture(target.scene, heights());
    if (!texture)
        return fail(texture.error());
    Unit& unit = target.pass.units[*free];
    unit = Unit{.enabled = true, .texture = static_cast<int>(*texture), .envMode = EnvMode::Combine};
    return &unit;
}

Result<void> detail(const PresetTarget& target) {
    const Result<Unit*> unit = heightsIn(target, false);
    if (!unit)
        return fail(unit.error());
    (*unit)->combine = Combine{.rgbScale = CombineScale::Two};
    (*unit)->matrix = {{.op = MatrixOp::Scale, .amount = {4, 4, 1}}};
    return {};
}

/// One cube: at the poles of a sphere the coordinates have no direction that could follow the light.
Model& showCube(Scene& scene) {
    constexpr std::array cube{Shape::Cube};
    showOnlyShapes(scene, cube);
    Model& model = *std::ranges::find(scene.models, Shape::Cube, &Model::shape);
    scene.view.target = model.position;
    scene.view.distance = 5;
    return model;
}

Result<void> emboss(const PresetTarget& target) {
    showCube(target.scene);
    showPattern(target.texture, Pattern::BrickHeight);
    filterTrilinear(target.texture);
    takeGivenCoordinates(target.unit);
    target.unit.envMode = EnvMode::Replace;
    const Result<Unit*> moved = heightsIn(target, true);
    if (!moved)
        return fail(moved.error());
    Unit& unit = **moved;
    unit.combine = Combine{.rgb = CombineRgb::AddSigned, .operand0Rgb = OperandRgb::OneMinusSrcColor};
    unit.emboss = Emboss{.enabled = true};
    return {};
}

/// A later unit that shows the same texture; nullptr: none.
Unit* unitOfSame(const PresetTarget& target) {
    const std::span<Unit> later = std::span(target.pass.units).subspan(target.place.unit + 1);
    const auto found = std::ranges::find_if(
        later, [&](const Unit& unit) { return unit.enabled && unit.texture == target.unit.texture; });
    return found == later.end() ? nullptr : &*found;
}

Result<void> wrongUnit(const PresetTarget& target) {
    Unit* other = unitOfSame(target);
    if (!other) {
        const Result<std::size_t> free = laterUnit(target);
        if (!free)
            return fail(free.error());
        other = &target.pass.units[*free];
        *other = target.unit;
    }
    showPatternUnlessOwn(target.texture, Pattern::Planet); // white at (0, 0)
    target.texture.magFilter = MagFilter::Nearest;         // one texel, and not the mean of four corners
    target.texture.minFilter = MinFilter::Nearest;
    takeGivenCoordinates(*other);
    target.unit.enabled = false;
    std::vector<int>& leftOut =
        showCube(target.scene).noTexCoord[static_cast<std::size_t>(other - target.pass.units.data())];
    leftOut.resize(24); // all vertices of a cube
    std::iota(leftOut.begin(), leftOut.end(), 0);
    return {};
}

/// Back to the unit before it that is off, or to the first one.
Result<void> wrongUnitCure(const PresetTarget& target) {
    std::array<Unit, maxUnits>& units = target.pass.units;
    for (std::size_t u = 1; u < maxUnits; ++u) {
        const bool lacks = std::ranges::any_of(
            target.scene.models, [u](const Model& model) { return !model.noTexCoord[u].empty(); });
        if (!units[u].enabled || !lacks)
            continue;
        Unit& right = target.place.unit < u ? target.unit : units.front();
        if (&right != &target.unit)
            right = units[u];
        units[u].enabled = false;
        for (Model& model : target.scene.models)
            model.noTexCoord[u].clear();
    }
    return {};
}

constexpr std::array unitRows{
    Preset{"decal", unitGroup, N_("Decal with alpha"),
           N_("GL_DECAL with an image with alpha, over an orange glColor."),
           N_("Where the image's alpha is 0 the lit colour shows; where it is 1, the unlit image."), decal},
    Preset{"detail", unitGroup, N_("Detail texture"),
           N_("A second unit: GL_COMBINE with GL_MODULATE and GL_RGB_SCALE 2, repeated four times as often."),
           N_("Fine grain over the image: the surface keeps its detail from close by. A grey of 0.5 changes "
              "nothing."),
           detail},
    Preset{"wrong-unit", unitGroup, N_("Image on another unit"),
           N_("The image is on a later unit, as after glActiveTexture(GL_TEXTURE1), but only glTexCoord is "
              "called, which sends the coordinates of unit 0."),
           N_("The cube has one colour: all of it reads the texel at (0, 0), OpenGL's initial coordinates."),
           wrongUnit},
    Preset{"wrong-unit-cure", unitGroup, N_("Image on another unit, cured"),
           N_("The image is on this unit, as after glActiveTexture(GL_TEXTURE0), and the other one is off."),
           N_("The image is back: glTexCoord sends the coordinates that its unit reads."), wrongUnitCure,
           true},
    Preset{
        "emboss", unitGroup, N_("Embossed bumps"),
        N_("Two units show heights on a cube, the second one inverted and moved towards the light, with "
           "GL_ADD_SIGNED."),
        N_("Bricks stand out of a grey surface. Slopes towards the light are bright and follow it when you "
           "orbit."),
        emboss},
};

} // namespace

std::span<const Preset> unitPresets() {
    return unitRows;
}

} // namespace texplorer::preset
