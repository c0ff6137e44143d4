#include "core/scene/params/param_builder.h"

namespace texplorer {
namespace {

using build::color;
using build::param;

constexpr std::array viewRows{
    param<&View::azimuth>("azimuth", "Camera", "Azimuth", "glRotatef(-{}, 0, 1, 0)",
                          "How far the camera has gone around the y axis; at 0 it looks along -z.",
                          {-360, 360, 0.5F, "deg"}),
    param<&View::elevation>(
        "elevation", "Camera", "Elevation", "glRotatef({}, 1, 0, 0)",
        "How high the camera stands above the horizon; negative looks up from below, and beyond 90 "
        "degrees it has gone over the pole.",
        {-360, 360, 0.5F, "deg"}),
    param<&View::roll>("roll", "Camera", "Roll", "glRotatef({}, 0, 0, 1)",
                       "How far the camera is turned about its line of sight.", {-360, 360, 0.5F, "deg"}),
    param<&View::distance>(
        "distance", "Camera", "Distance", "glTranslatef(0, 0, -{})",
        "From the camera to its target. Far away, a pixel covers many texels: minification.",
        {0.1F, 1000, 0.05F, {}}),
    param<&View::target>("target", "Camera", "Target", "glTranslatef(-{})",
                         "The point that the camera orbits and looks at.", {-1000, 1000, 0.01F, {}}),
    param<&View::projection>(
        "projection", "Camera", "Projection", "",
        "Whether far things look smaller. Without it a texel keeps its size across a plane."),
    param<&View::fieldOfView>(
        "fieldOfView", "Camera", "Field of view", "gluPerspective({}, aspect, zNear, zFar)",
        "The vertical opening angle. An orthographic view shows the same height at the target.",
        {1, 170, 0.25F, "deg"}),
    param<&View::perspectiveHint>(
        "perspectiveHint", "Camera", "Perspective hint", "glHint(GL_PERSPECTIVE_CORRECTION_HINT, {})",
        "GL_FASTEST interpolates straight across the window, as old hardware did: images swim. The shaders "
        "and the reference do so; most drivers ignore the hint."),
    color<&View::background>(
        "background", "Background", "Background", "glClearColor({})",
        "What the frame is cleared to. Its alpha shows only where a blend factor asks for it; "
        "screenshots are opaque."),
};
static_assert(viewRows.size() == 9 && viewRows.size() == build::memberCount<View>());

} // namespace

const StructTable& viewTable() {
    static const StructTable table{"View", viewRows, {}};
    return table;
}

} // namespace texplorer
