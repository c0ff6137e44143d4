#pragma once

#include "core/scene/scene.h"

#include <array>
#include <optional>

namespace texplorer::ui {

/// What the view shows, as one choice.
enum class Show { CubeAndSphere, Cube, Sphere, Quad, Floor };

struct ShowRow {
    Show show;
    const char* label;
};

inline constexpr std::array showRows{
    ShowRow{Show::CubeAndSphere, "Both"}, ShowRow{Show::Cube, "Cube"},   ShowRow{Show::Sphere, "Sphere"},
    ShowRow{Show::Quad, "Square"},        ShowRow{Show::Floor, "Floor"},
};

/// Shows only the first model of the shape; adds it if the scene has none. Aims the camera at it. `aspect` is
/// the view's width / height.
void showOnly(Scene& scene, Show show, double time, float aspect);

/// The current choice; nothing if it is none of them.
[[nodiscard]] std::optional<Show> shownNow(const Scene& scene);

} // namespace texplorer::ui
