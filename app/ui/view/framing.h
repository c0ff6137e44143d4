#pragma once

#include "app/ui/model/session.h"
#include "app/ui/state/layout.h"

#include <array>
#include <optional>

namespace texplorer::ui {

/// What the view shows, as one choice.
enum class Show { CubeAndSphere, Cube, Sphere, Quad, Floor };

struct ShowRow {
    Show show;
    const char* label;
    Shape shape; ///< the only one, or the first one
};

inline constexpr std::array showRows{
    ShowRow{Show::CubeAndSphere, N_("Both"), Shape::Cube}, ShowRow{Show::Cube, N_("Cube"), Shape::Cube},
    ShowRow{Show::Sphere, N_("Sphere"), Shape::Sphere},    ShowRow{Show::Quad, N_("Square"), Shape::Quad},
    ShowRow{Show::Floor, N_("Floor"), Shape::Floor},
};

/// Shows only the first model of the shape; adds it if the scene has none. Aims the camera at it. `aspect` is
/// the view's width / height.
void showOnly(Scene& scene, Show show, double time, float aspect);

/// The current choice; nothing if it is none of them.
[[nodiscard]] std::optional<Show> shownNow(const Scene& scene);

// Move the camera, each as an undo step. Until the user moves the camera, it follows the shape of the view.

/// Restores the initial camera, fitted to the view.
void resetCamera(const Session& session, const Layout& layout);
void frameAll(const Session& session, const Layout& layout);
void show(const Session& session, const ShowRow& row,
          const Layout& layout); ///< also selects the shown object

} // namespace texplorer::ui
