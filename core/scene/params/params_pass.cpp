#include "texplorer/scene/params/param_builder.h"

namespace texplorer {
namespace {

using build::color;
using build::list;
using build::param;

constexpr std::array passRows{
    param<&Pass::enabled>(
        "enabled", N_("Pass"), N_("Drawn"), "",
        N_("Whether this pass is drawn. Passes are drawn one after the other, each over the ones before.")),
    param<&Pass::name>("name", N_("Pass"), N_("Name"), "",
                       N_("The name of the pass in lists. It has no other effect.")),
    param<&Pass::picture>(
        "picture", N_("Pass"), N_("Draws in"), "",
        N_("Where this pass draws: in the window, or in a picture that textures show. Each is cleared to the "
           "background before its first pass."),
        {0, static_cast<float>(maxPictures), 0.02F, {}, N_("the window")}),
    list<&Pass::models>(
        "models", N_("Pass"), N_("Models"), "",
        N_("The models that this pass draws, counted from 0 and in this order. Without a list: all models."),
        maxModels, {0, static_cast<float>(maxModels - 1), 1, {}}),
    param<&Pass::lighting>(
        "lighting", N_("Lighting"), N_("Lighting"), "glEnable(GL_LIGHTING)",
        N_("Whether light 0 decides the fragment's colour. If off, the colour is glColor.")),
    param<&Pass::depthTest>("depthTest", N_("Depth"), N_("Depth test"), "glEnable(GL_DEPTH_TEST)",
                            N_("Whether near surfaces hide far ones. If off, what is drawn last covers the "
                               "rest.")),
    param<&Pass::depthFunc>("depthFunc", N_("Depth"), N_("Depth function"), "glDepthFunc({})",
                            N_("How a fragment's depth must compare with the stored one to pass the depth "
                               "test.")),
    param<&Pass::alphaTest>("alphaTest", N_("Alpha test"), N_("Alpha test"), "glEnable(GL_ALPHA_TEST)",
                            N_("Whether fragments are discarded by their alpha. Used for cut-outs such as "
                               "leaves.")),
    param<&Pass::alphaFunc>("alphaFunc", N_("Alpha test"), N_("Alpha function"), "glAlphaFunc({}, alphaRef)",
                            N_("How a fragment's alpha must compare with the reference value to pass the "
                               "alpha test.")),
    param<&Pass::alphaRef>("alphaRef", N_("Alpha test"), N_("Reference value"), "glAlphaFunc(alphaFunc, {})",
                           N_("The alpha that each fragment is compared with."), {0, 1, 0.005F, {}}),
    param<&Pass::blend>("blend", N_("Blending"), N_("Blending"), "glEnable(GL_BLEND)",
                        N_("Whether a fragment is mixed with the stored colour instead of replacing it.")),
    param<&Pass::blendSrc>("blendSrc", N_("Blending"), N_("Source factor"), "glBlendFunc({}, blendDst)",
                           N_("The factor of the new fragment's colour before both are added.")),
    param<&Pass::blendDst>("blendDst", N_("Blending"), N_("Destination factor"), "glBlendFunc(blendSrc, {})",
                           N_("The factor of the stored colour before both are added.")),
    param<&Pass::seamlessCubeMap>(
        "seamlessCubeMap", N_("Seamless cube maps"), N_("Seamless cube maps"),
        "glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS)",
        N_("Whether linear filtering continues across the edges of a cube map's faces instead of ending there "
           "(OpenGL 3.2).")),
};

constexpr std::array fogRows{
    param<&Fog::enabled>("enabled", N_("Fog"), N_("Fog"), "glEnable(GL_FOG)",
                         N_("Whether colours fade with distance, after texturing.")),
    param<&Fog::mode>("mode", N_("Fog"), N_("Fog mode"), "glFogi(GL_FOG_MODE, {})",
                      N_("How fog gets denser with distance.")),
    param<&Fog::density>("density", N_("Fog"), N_("Density"), "glFogf(GL_FOG_DENSITY, {})",
                         N_("The density of exponential fog. At a distance of 1 / density about a third of "
                            "the colour is left."),
                         {0, 1000, 0.005F, {}}),
    param<&Fog::start>("start", N_("Fog"), N_("Start"), "glFogf(GL_FOG_START, {})",
                       N_("The distance from the eye at which linear fog begins."), {-1000, 1000, 0.02F, {}}),
    param<&Fog::end>("end", N_("Fog"), N_("End"), "glFogf(GL_FOG_END, {})",
                     N_("The distance from the eye at which linear fog hides everything."),
                     {-1000, 1000, 0.02F, {}}),
    color<&Fog::color>(
        "color", N_("Fog"), N_("Fog colour"), "glFogfv(GL_FOG_COLOR, {})",
        N_("The colour that colours fade to, usually the background's. Its alpha is ignored.")),
};
static_assert(fogRows.size() == 6 && fogRows.size() == build::memberCount<Fog>());

} // namespace

const StructTable& passTable() {
    static const std::array children{
        build::single<&Pass::fog>("fog", N_("Fog"), fogTable()),
        build::many<&Pass::units>("units", N_("Unit"), unitTable(), maxUnits, maxUnits),
    };
    static_assert(passRows.size() == 14 && passRows.size() + children.size() == build::memberCount<Pass>());
    static const StructTable table{N_("Pass"), passRows, children};
    return table;
}

const StructTable& fogTable() {
    static const StructTable table{N_("Fog"), fogRows, {}};
    return table;
}

} // namespace texplorer
