#include "texplorer/scene/params/param_builder.h"

namespace texplorer {
namespace {

using build::color;
using build::list;
using build::param;

constexpr std::array passRows{
    param<&Pass::enabled>(
        "enabled", "Pass", "Drawn", "",
        "Whether this pass is drawn. Passes are drawn one after the other, each over the ones before."),
    param<&Pass::name>("name", "Pass", "Name", "", "The name of the pass in lists. It has no other effect."),
    list<&Pass::models>(
        "models", "Pass", "Models", "",
        "The models that this pass draws, counted from 0 and in this order. Without a list: all models.",
        maxModels, {0, static_cast<float>(maxModels - 1), 1, {}}),
    param<&Pass::lighting>("lighting", "Lighting", "Lighting", "glEnable(GL_LIGHTING)",
                           "Whether light 0 decides the fragment's colour. If off, the colour is glColor."),
    param<&Pass::depthTest>("depthTest", "Depth", "Depth test", "glEnable(GL_DEPTH_TEST)",
                            "Whether near surfaces hide far ones. If off, what is drawn last covers the "
                            "rest."),
    param<&Pass::depthFunc>("depthFunc", "Depth", "Depth function", "glDepthFunc({})",
                            "How a fragment's depth must compare with the stored one to pass the depth "
                            "test."),
    param<&Pass::alphaTest>("alphaTest", "Alpha test", "Alpha test", "glEnable(GL_ALPHA_TEST)",
                            "Whether fragments are discarded by their alpha. Used for cut-outs such as "
                            "leaves."),
    param<&Pass::alphaFunc>("alphaFunc", "Alpha test", "Alpha function", "glAlphaFunc({}, alphaRef)",
                            "How a fragment's alpha must compare with the reference value to pass the "
                            "alpha test."),
    param<&Pass::alphaRef>("alphaRef", "Alpha test", "Reference value", "glAlphaFunc(alphaFunc, {})",
                           "The alpha that each fragment is compared with.", {0, 1, 0.005F, {}}),
    param<&Pass::blend>("blend", "Blending", "Blending", "glEnable(GL_BLEND)",
                        "Whether a fragment is mixed with the stored colour instead of replacing it."),
    param<&Pass::blendSrc>("blendSrc", "Blending", "Source factor", "glBlendFunc({}, blendDst)",
                           "The factor of the new fragment's colour before both are added."),
    param<&Pass::blendDst>("blendDst", "Blending", "Destination factor", "glBlendFunc(blendSrc, {})",
                           "The factor of the stored colour before both are added."),
    param<&Pass::seamlessCubeMap>(
        "seamlessCubeMap", "Seamless cube maps", "Seamless cube maps",
        "glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS)",
        "Whether linear filtering continues across the edges of a cube map's faces instead of ending there "
        "(OpenGL 3.2)."),
};

constexpr std::array fogRows{
    param<&Fog::enabled>("enabled", "Fog", "Fog", "glEnable(GL_FOG)",
                         "Whether colours fade with distance, after texturing."),
    param<&Fog::mode>("mode", "Fog", "Fog mode", "glFogi(GL_FOG_MODE, {})",
                      "How fog gets denser with distance."),
    param<&Fog::density>("density", "Fog", "Density", "glFogf(GL_FOG_DENSITY, {})",
                         "The density of exponential fog. At a distance of 1 / density about a third of "
                         "the colour is left.",
                         {0, 1000, 0.005F, {}}),
    param<&Fog::start>("start", "Fog", "Start", "glFogf(GL_FOG_START, {})",
                       "The distance from the eye at which linear fog begins.", {-1000, 1000, 0.02F, {}}),
    param<&Fog::end>("end", "Fog", "End", "glFogf(GL_FOG_END, {})",
                     "The distance from the eye at which linear fog hides everything.",
                     {-1000, 1000, 0.02F, {}}),
    color<&Fog::color>("color", "Fog", "Fog colour", "glFogfv(GL_FOG_COLOR, {})",
                       "The colour that colours fade to, usually the background's. Its alpha is ignored."),
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
