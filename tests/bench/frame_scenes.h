#pragma once

// The scenes whose frames are compared: what texplorer shows first, and a floor that runs to the horizon,
// each with every way of filtering; lines; and an embossed cube, which three passes draw.

#include "tests/support/floor_scene.h"
#include "texplorer/conform/dice.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/scene.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace texplorer::bench {

struct FrameScene {
    const char* name;
    Scene (*make)();
    bool oneFilter = false; ///< whether one way of filtering is enough
};

struct FrameFilter {
    const char* name;
    MagFilter mag;
    MinFilter min;
    float anisotropy;
};

inline constexpr int frameWidth = 640;
inline constexpr int frameHeight = 480;

/// 2000 textured lines, three pixels wide and 60 long on average, in every direction.
[[nodiscard]] inline Scene linesScene() {
    Scene scene = defaultScene();
    scene.view.azimuth = scene.view.elevation = 0;
    Model lines;
    lines.shape = Shape::Mesh;
    lines.lineWidth = 3;
    lines.mesh.primitive = Primitive::Lines;
    conform::Dice dice("lines", 1, 0);
    for (int i = 0; i < 2000; ++i) {
        const glm::vec3 from{dice.number(-3, 3), dice.number(-2.2F, 2.2F), 0};
        lines.mesh.positions.push_back(from);
        lines.mesh.positions.push_back(from + glm::vec3(dice.number(-1, 1), dice.number(-1, 1), 0));
        lines.mesh.texCoords.emplace_back(0, 0, 0, 1);
        lines.mesh.texCoords.emplace_back(1, 0, 0, 1);
    }
    scene.models = {lines};
    scene.textures[0].pattern = Pattern::ColorLine;
    scene.passes[0].lighting = false;
    scene.passes[0].units[0].target = Target::Texture1D;
    return scene;
}

[[nodiscard]] inline Scene embossedScene() {
    const Result<std::string> text = readText(TEXPLORER_SCENES "/nehe-bumps-1-unit.json", maxSceneBytes);
    return text ? parseScene(*text).value_or(Scene{}) : Scene{};
}

inline constexpr std::array frameScenes{
    FrameScene{"default", defaultScene},
    FrameScene{"floor", test::floorScene},
    FrameScene{"lines", linesScene, true},
    FrameScene{"embossed", embossedScene, true},
};

inline constexpr std::array frameFilters{
    FrameFilter{"nearest", MagFilter::Nearest, MinFilter::Nearest, 1},
    FrameFilter{"linear", MagFilter::Linear, MinFilter::Linear, 1},
    FrameFilter{"nearestMipmapNearest", MagFilter::Nearest, MinFilter::NearestMipmapNearest, 1},
    FrameFilter{"linearMipmapNearest", MagFilter::Linear, MinFilter::LinearMipmapNearest, 1},
    FrameFilter{"nearestMipmapLinear", MagFilter::Nearest, MinFilter::NearestMipmapLinear, 1},
    FrameFilter{"trilinear", MagFilter::Linear, MinFilter::LinearMipmapLinear, 1},
    FrameFilter{"anisotropic", MagFilter::Linear, MinFilter::LinearMipmapLinear, 16},
};

/// The ways of filtering in which a scene is drawn.
[[nodiscard]] inline std::span<const FrameFilter> filtersOf(const FrameScene& scene) {
    return scene.oneFilter ? std::span(frameFilters).subspan(1, 1) : std::span(frameFilters);
}

[[nodiscard]] inline Scene frameScene(const FrameScene& which, const FrameFilter& filter) {
    Scene scene = which.make();
    Texture& texture = scene.textures[0];
    texture.magFilter = filter.mag;
    texture.minFilter = filter.min;
    texture.maxAnisotropy = filter.anisotropy;
    return scene;
}

/// By name; nullopt where there is none.
[[nodiscard]] inline std::optional<Scene> frameScene(std::string_view sceneName,
                                                     std::string_view filterName) {
    for (const FrameScene& scene : frameScenes) {
        for (const FrameFilter& filter : filtersOf(scene)) {
            if (scene.name == sceneName && filter.name == filterName)
                return frameScene(scene, filter);
        }
    }
    return std::nullopt;
}

} // namespace texplorer::bench
