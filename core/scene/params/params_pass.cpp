#include "core/scene/params/param_builder.h"

namespace texplorer {
namespace {

using build::color;
using build::list;
using build::param;

constexpr std::array passRows{
    param<&Pass::enabled>(
        "enabled", "Pass", "Drawn", "",
        "Whether this pass is drawn. Passes come one after the other, each over what is there."),
    param<&Pass::name>("name", "Pass", "Name", "", "What it is called in lists. It changes nothing else."),
    list<&Pass::models>(
        "models", "Pass", "Models", "",
        "Which models this pass draws, counted from 0 and in this order. No list: all of them.", maxModels,
        {0, static_cast<float>(maxModels - 1), 1, {}}),
    param<&Pass::lighting>(
        "lighting", "Lighting", "Lighting", "glEnable(GL_LIGHTING)",
        "Whether light 0 decides the fragment's colour. Without it the colour is glColor alone."),
    param<&Pass::depthTest>("depthTest", "Depth", "Depth test", "glEnable(GL_DEPTH_TEST)",
                            "Whether near surfaces hide far ones. Without it what is drawn last wins."),
    param<&Pass::depthFunc>("depthFunc", "Depth", "Depth function", "glDepthFunc({})",
                            "When a fragment passes the depth test: its depth compared with the stored one."),
    param<&Pass::alphaTest>("alphaTest", "Alpha test", "Alpha test", "glEnable(GL_ALPHA_TEST)",
                            "Whether fragments are dropped by their alpha: cut-outs, as leaves on a tree."),
    param<&Pass::alphaFunc>("alphaFunc", "Alpha test", "Alpha function", "glAlphaFunc({}, alphaRef)",
                            "When a fragment passes the alpha test: its alpha compared with the reference."),
    param<&Pass::alphaRef>("alphaRef", "Alpha test", "Reference value", "glAlphaFunc(alphaFunc, {})",
                           "The alpha that each fragment is compared with.", {0, 1, 0.005F, {}}),
    param<&Pass::blend>("blend", "Blending", "Blending", "glEnable(GL_BLEND)",
                        "Whether a fragment is mixed with what is there already instead of replacing it."),
    param<&Pass::blendSrc>("blendSrc", "Blending", "Source factor", "glBlendFunc({}, blendDst)",
                           "What the new fragment is multiplied by before both are added."),
    param<&Pass::blendDst>("blendDst", "Blending", "Destination factor", "glBlendFunc(blendSrc, {})",
                           "What the stored colour is multiplied by before both are added."),
    param<&Pass::seamlessCubeMap>(
        "seamlessCubeMap", "Cube maps", "Seamless", "glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS)",
        "Whether linear filtering goes on across the edges of a cube map's faces, instead of ending at each "
        "(OpenGL 3.2)."),
};

constexpr std::array fogRows{
    param<&Fog::enabled>("enabled", "Fog", "Fog", "glEnable(GL_FOG)",
                         "Whether colours fade with the distance, after texturing."),
    param<&Fog::mode>("mode", "Fog", "Fog mode", "glFogi(GL_FOG_MODE, {})",
                      "How fog thickens with the distance."),
    param<&Fog::density>("density", "Fog", "Density", "glFogf(GL_FOG_DENSITY, {})",
                         "How thick exponential fog is: at a distance of 1 / density a third is left.",
                         {0, 1000, 0.005F, {}}),
    param<&Fog::start>("start", "Fog", "Start", "glFogf(GL_FOG_START, {})",
                       "The distance from the eye at which linear fog begins.", {-1000, 1000, 0.02F, {}}),
    param<&Fog::end>("end", "Fog", "End", "glFogf(GL_FOG_END, {})",
                     "The distance from the eye at which linear fog hides everything.",
                     {-1000, 1000, 0.02F, {}}),
    color<&Fog::color>("color", "Fog", "Fog colour", "glFogfv(GL_FOG_COLOR, {})",
                       "What colours fade to: usually the background's. Its alpha says nothing."),
};
static_assert(fogRows.size() == 6 && fogRows.size() == build::memberCount<Fog>());

} // namespace

const StructTable& passTable() {
    static const std::array children{
        build::single<&Pass::fog>("fog", "Fog", fogTable()),
        build::many<&Pass::units>("units", "Unit", unitTable(), maxUnits, maxUnits),
    };
    static_assert(passRows.size() == 13 && passRows.size() + children.size() == build::memberCount<Pass>());
    static const StructTable table{"Pass", passRows, children};
    return table;
}

const StructTable& fogTable() {
    static const StructTable table{"Fog", fogRows, {}};
    return table;
}

} // namespace texplorer
