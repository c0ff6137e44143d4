#include "core/scene/params/param_builder.h"

namespace texplorer {
namespace {

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
    param<&Pass::alphaRef>("alphaRef", "Alpha test", "Reference", "glAlphaFunc(alphaFunc, {})",
                           "The alpha that each fragment is compared with.", {0, 1, 0.005F, {}}),
    param<&Pass::blend>("blend", "Blending", "Blending", "glEnable(GL_BLEND)",
                        "Whether a fragment is mixed with what is there already instead of replacing it."),
    param<&Pass::blendSrc>("blendSrc", "Blending", "Source factor", "glBlendFunc({}, blendDst)",
                           "What the new fragment is multiplied by before both are added."),
    param<&Pass::blendDst>("blendDst", "Blending", "Destination factor", "glBlendFunc(blendSrc, {})",
                           "What the stored colour is multiplied by before both are added."),
};

} // namespace

const StructTable& passTable() {
    static const std::array children{
        build::many<&Pass::units>("units", "Unit", unitTable(), maxUnits, maxUnits),
    };
    static_assert(passRows.size() == 12 && passRows.size() + children.size() == build::memberCount<Pass>());
    static const StructTable table{"Pass", passRows, children};
    return table;
}

} // namespace texplorer
