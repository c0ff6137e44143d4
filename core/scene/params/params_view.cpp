#include "texplorer/scene/params/param_builder.h"

namespace texplorer {
namespace {

using build::color;
using build::param;

constexpr std::array viewRows{
    param<&View::azimuth>("azimuth", "Camera", "Azimuth", "glRotatef(-{}, 0, 1, 0)",
                          "The angle of the camera around the y axis. At 0 it looks along -z.",
                          {-360, 360, 0.5F, "deg"}),
    param<&View::elevation>(
        "elevation", "Camera", "Elevation", "glRotatef({}, 1, 0, 0)",
        "The angle of the camera above the horizon. Negative angles look up from below; beyond 90 degrees "
        "the camera is past the pole.",
        {-360, 360, 0.5F, "deg"}),
    param<&View::roll>("roll", "Camera", "Roll", "glRotatef({}, 0, 0, 1)",
                       "The angle by which the camera is turned about its line of sight.",
                       {-360, 360, 0.5F, "deg"}),
    param<&View::distance>(
        "distance", "Camera", "Distance", "glTranslatef(0, 0, -{})",
        "The distance from the camera to its target. From afar, a pixel covers many texels (minification).",
        {0.1F, 1000, 0.05F, {}}),
    param<&View::target>("target", "Camera", "Target", "glTranslatef(-{})",
                         "The point that the camera orbits and looks at.", {-1000, 1000, 0.01F, {}}),
    param<&View::projection>(
        "projection", "Camera", "Projection", "",
        "Whether far objects look smaller. In an orthographic view a texel has the same size everywhere on "
        "a plane."),
    param<&View::fieldOfView>(
        "fieldOfView", "Camera", "Field of view", "gluPerspective({}, aspect, zNear, zFar)",
        "The vertical opening angle. An orthographic view shows the same height at the target.",
        {1, 170, 0.25F, "deg"}),
    param<&View::perspectiveHint>(
        "perspectiveHint", "Camera", "Perspective hint", "glHint(GL_PERSPECTIVE_CORRECTION_HINT, {})",
        "GL_FASTEST interpolates without perspective, as old hardware did, and images swim. The shaders "
        "and the reference do so; most drivers ignore the hint."),
    color<&View::background>(
        "background", "Background", "Background", "glClearColor({})",
        "The colour that the frame is cleared to. Its alpha matters only to blend factors that read it; "
        "screenshots are opaque."),
};
static_assert(viewRows.size() == 9 && viewRows.size() == build::memberCount<View>());

} // namespace

const StructTable& viewTable() {
    static const StructTable table{"View", viewRows, {}};
    return table;
}

} // namespace texplorer
