#pragma once

// The scenes whose frames are compared: what texplorer shows first, and a floor that runs to the horizon,
// each with every way of filtering.

#include "core/scene/scene.h"
#include "tests/support/floor_scene.h"

#include <array>
#include <optional>
#include <string_view>

namespace texplorer::bench {

struct FrameScene {
    const char* name;
    Scene (*make)();
};

struct FrameFilter {
    const char* name;
    MagFilter mag;
    MinFilter min;
    float anisotropy;
};

inline constexpr int frameWidth = 640;
inline constexpr int frameHeight = 480;

inline constexpr std::array frameScenes{
    FrameScene{"default", defaultScene},
    FrameScene{"floor", test::floorScene},
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
        for (const FrameFilter& filter : frameFilters) {
            if (scene.name == sceneName && filter.name == filterName)
                return frameScene(scene, filter);
        }
    }
    return std::nullopt;
}

} // namespace texplorer::bench
