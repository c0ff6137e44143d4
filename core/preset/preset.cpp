#include "texplorer/preset/preset.h"

#include "texplorer/preset/preset_rows.h"
#include "texplorer/scene/show_shapes.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace texplorer {
namespace preset {

void showPattern(Texture& texture, Pattern pattern) {
    texture.source = SourceKind::Pattern;
    texture.pattern = pattern;
    texture.internalFormat = InternalFormat::Rgba;
    texture.compression = Compression::FromFile;
    texture.transparency = Transparency::File;
    texture.preparation.clear();
    texture.border = 0;
    texture.upload = {};
    texture.compareMode = CompareMode::None;
    if (texture.mipmaps == MipPolicy::Given || texture.mipmaps == MipPolicy::FromFile)
        texture.mipmaps = MipPolicy::Generated;
}

void showPatternUnless(Texture& texture, Pattern pattern, bool suits) {
    if (!suits)
        showPattern(texture, pattern);
}

void showPatternUnlessOwn(Texture& texture, Pattern pattern) {
    showPatternUnless(texture, pattern, texture.source == SourceKind::File);
}

void filterTrilinear(Texture& texture) {
    texture.mipmaps = MipPolicy::Generated;
    texture.minFilter = MinFilter::LinearMipmapLinear;
    texture.magFilter = MagFilter::Linear;
    texture.baseLevel = Texture{}.baseLevel;
    texture.maxLevel = Texture{}.maxLevel;
}

void generateNothing(Unit& unit) {
    unit.target = Target::Texture2D;
    for (TexGen* each : {&unit.texGenS, &unit.texGenT, &unit.texGenR, &unit.texGenQ})
        each->enabled = false;
    unit.emboss.enabled = false;
    std::erase_if(unit.matrix, [](const MatrixStep& step) { return step.op == MatrixOp::Projector; });
}

void takeGivenCoordinates(Unit& unit, Target target) {
    generateNothing(unit);
    unit.target = target;
    unit.matrix.clear();
    unit.matrixStart = MatrixStart::Identity;
}

void showFloor(const PresetTarget& target) {
    constexpr std::array floor{Shape::Floor};
    showOnlyShapes(target.scene, floor);
    lookAlongFloor(target.scene.view);
    takeGivenCoordinates(target.unit);
}

Model& showSquare(Scene& scene) {
    constexpr std::array square{Shape::Quad};
    showOnlyShapes(scene, square);
    Model& model = *std::ranges::find(scene.models, Shape::Quad, &Model::shape);
    View& view = scene.view;
    view.azimuth = view.elevation = view.roll = 0;
    view.target = model.position;
    view.distance = 3.6F;
    return model;
}

Result<std::size_t> freeUnit(const PresetTarget& target) {
    const auto isFree = [&](std::size_t unit) { return !target.pass.units[unit].enabled; };
    for (std::size_t i = 1; i < maxUnits; ++i) {
        if (const std::size_t unit = (target.place.unit + i) % maxUnits; isFree(unit))
            return unit;
    }
    return fail(ErrorCode::TooLarge, Sentence("all {0} units of the pass are in use", maxUnits));
}

Result<std::size_t> addTexture(Scene& scene, Texture texture) {
    if (scene.textures.size() >= maxTextures)
        return fail(ErrorCode::TooLarge, Sentence("the scene already has {0} textures", maxTextures));
    scene.textures.push_back(std::move(texture));
    return scene.textures.size() - 1;
}

} // namespace preset

std::span<const Preset> presets() {
    static const std::vector<Preset> all = [] {
        std::vector<Preset> rows;
        for (const auto& group : {preset::filterPresets, preset::alphaPresets, preset::coordinatePresets,
                                  preset::unitPresets, preset::uploadPresets})
            rows.insert(rows.end(), group().begin(), group().end());
        return rows;
    }();
    return all;
}

const Preset* findPreset(std::string_view name) {
    const std::span<const Preset> rows = presets();
    const auto found = std::ranges::find(rows, name, &Preset::name);
    return found == rows.end() ? nullptr : &*found;
}

Result<void> applyPreset(const Preset& preset, Scene& scene, const PresetPlace& place) {
    if (place.pass >= scene.passes.size() || place.unit >= maxUnits)
        return fail(ErrorCode::OutOfRange,
                    Sentence("there is no unit {0} of pass {1}", place.unit, place.pass));
    Scene edited = scene;
    Pass& pass = edited.passes[place.pass];
    Unit& unit = pass.units[place.unit];
    if (unit.texture < 0 || std::cmp_greater_equal(unit.texture, edited.textures.size())) {
        const Result<std::size_t> added = preset::addTexture(edited, {});
        if (!added)
            return fail(added.error());
        unit.texture = static_cast<int>(*added);
    }
    pass.enabled = unit.enabled = true;
    if (!preset.cures && edited.view.background == preset::paper)
        edited.view.background = defaultScene().view.background;
    Texture& texture = edited.textures[static_cast<std::size_t>(unit.texture)];
    if (isRefused(texture.internalFormat)) // what another preset is about
        texture.internalFormat = InternalFormat::Rgba;
    if (Result<void> done = preset.edit({edited, pass, unit, texture, place}); !done)
        return done;
    scene = std::move(edited);
    return {};
}

} // namespace texplorer
