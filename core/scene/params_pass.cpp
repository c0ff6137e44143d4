#include "core/scene/param_builder.h"

namespace texplorer {
namespace {

using build::color;
using build::param;

constexpr std::array passRows{
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

constexpr std::array unitRows{
    param<&Unit::enabled>("enabled", "Unit", "Enabled", "glEnable(target)",
                          "Whether this unit applies its texture to the result of the units before it."),
    param<&Unit::target>("target", "Unit", "Target", "glEnable({})",
                         "Whether the texture is a line, a picture or a volume."),
    param<&Unit::texture>("texture", "Unit", "Texture", "glBindTexture(target, textures[{}])",
                          "Which of the scene's textures is bound, counted from 0.",
                          {0, static_cast<float>(maxTextures - 1), 0.05F, {}}),
    param<&Unit::envMode>("envMode", "Environment", "Mode",
                          "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, {})",
                          "How the texture's colour and the fragment's colour become one."),
    color<&Unit::envColor>("envColor", "Environment", "Environment colour",
                           "glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, {})",
                           "The constant colour that GL_BLEND mixes in; the other modes ignore it."),
    param<&Unit::lodBias>("lodBias", "Level of detail", "LOD bias",
                          "glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, {})",
                          "Added to the level of detail: above 0 blurs, below 0 sharpens and aliases.",
                          {-16, 16, 0.02F, "levels"}),
};

constexpr std::array matrixStepRows{
    param<&MatrixStep::op>("op", "Step", "Operation", "", "What this step does to the texture coordinates."),
    param<&MatrixStep::amount>("amount", "Step", "Amount", "",
                               "The offset, the factors, or the axis of the rotation, at time 0.",
                               {-1000, 1000, 0.01F, {}}),
    param<&MatrixStep::angle>("angle", "Step", "Angle", "glRotatef({}, x, y, z)",
                              "How far a rotation turns at time 0; translating and scaling ignore it.",
                              {-360, 360, 0.5F, "deg"}),
    param<&MatrixStep::rate>("rate", "Animation", "Rate", "", "Added to the amount every second.",
                             {-1000, 1000, 0.01F, "/s"}),
    param<&MatrixStep::angleRate>("angleRate", "Animation", "Angle rate", "",
                                  "Added to the angle every second.", {-3600, 3600, 0.5F, "deg/s"}),
};
static_assert(matrixStepRows.size() == 5 && matrixStepRows.size() == build::memberCount<MatrixStep>());

} // namespace

const StructTable& matrixStepTable() {
    static const StructTable table{"MatrixStep", matrixStepRows, {}};
    return table;
}

const StructTable& unitTable() {
    static const std::array children{
        build::many<&Unit::matrix>("matrix", "Matrix step", matrixStepTable(), 0, maxMatrixSteps),
    };
    static_assert(unitRows.size() == 6 && unitRows.size() + children.size() == build::memberCount<Unit>());
    static const StructTable table{"Unit", unitRows, children};
    return table;
}

const StructTable& passTable() {
    static const std::array children{
        build::many<&Pass::units>("units", "Unit", unitTable(), maxUnits, maxUnits),
    };
    static_assert(passRows.size() == 9 && passRows.size() + children.size() == build::memberCount<Pass>());
    static const StructTable table{"Pass", passRows, children};
    return table;
}

} // namespace texplorer
