#include "texplorer/scene/params/param_builder.h"

namespace texplorer {
namespace {

using build::color;
using build::param;

constexpr std::array viewRows{
    param<&View::azimuth>("azimuth", N_("Camera"), N_("Azimuth"), "glRotatef(-{}, 0, 1, 0)",
                          N_("The angle of the camera around the y axis. At 0 it looks along -z."),
                          {-360, 360, 0.5F, N_("deg")}),
    param<&View::elevation>(
        "elevation", N_("Camera"), N_("Elevation"), "glRotatef({}, 1, 0, 0)",
        N_("The angle of the camera above the horizon. Negative angles look up from below; beyond 90 degrees "
           "the camera is past the pole."),
        {-360, 360, 0.5F, N_("deg")}),
    param<&View::roll>("roll", N_("Camera"), N_("Roll"), "glRotatef({}, 0, 0, 1)",
                       N_("The angle by which the camera is turned about its line of sight."),
                       {-360, 360, 0.5F, N_("deg")}),
    param<&View::distance>(
        "distance", N_("Camera"), N_("Distance"), "glTranslatef(0, 0, -{})",
        N_("The distance from the camera to its target. From afar, a pixel covers many texels (minification)."),
        {0.1F, 1000, 0.05F, {}}),
    param<&View::target>("target", N_("Camera"), N_("Target"), "glTranslatef(-{})",
                         N_("The point that the camera orbits and looks at."), {-1000, 1000, 0.01F, {}}),
    param<&View::projection>(
        "projection", N_("Camera"), N_("Projection"), "",
        N_("Whether far objects look smaller. In an orthographic view a texel has the same size everywhere on "
           "a plane.")),
    param<&View::fieldOfView>(
        "fieldOfView", N_("Camera"), N_("Field of view"), N_("gluPerspective({}, aspect, zNear, zFar)"),
        N_("The vertical opening angle. An orthographic view shows the same height at the target."),
        {1, 170, 0.25F, N_("deg")}),
    param<&View::perspectiveHint>(
        "perspectiveHint", N_("Camera"), N_("Perspective hint"), "glHint(GL_PERSPECTIVE_CORRECTION_HINT, {})",
        N_("GL_FASTEST interpolates without perspective, as old hardware did, and images swim. The shaders "
           "and the reference do so; most drivers ignore the hint.")),
    color<&View::background>(
        "background", N_("Background"), N_("Background"), "glClearColor({})",
        N_("The colour that the frame is cleared to. Its alpha matters only to blend factors that read it; "
           "screenshots are opaque.")),
};
static_assert(viewRows.size() == 9 && viewRows.size() == build::memberCount<View>());

} // namespace

const StructTable& viewTable() {
    static const StructTable table{N_("View"), viewRows, {}};
    return table;
}

} // namespace texplorer
