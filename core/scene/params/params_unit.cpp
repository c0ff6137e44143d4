#include "texplorer/scene/params/param_builder.h"
#include "texplorer/text/word.h"

#include <array>

namespace texplorer {
namespace {

using build::color;
using build::param;

constexpr std::array unitRows{
    param<&Unit::enabled>("enabled", "Unit", "Enabled", "glEnable(target)",
                          "Whether this unit applies its texture to the result of the units before it."),
    param<&Unit::target>("target", "Unit", "Target", "glEnable({})",
                         "Whether the texture is a line, an image, a volume or the six faces of a cube."),
    param<&Unit::texture>("texture", "Unit", "Texture", "glBindTexture(target, textures[{}])",
                          "The texture of the scene that is bound, counted from 0.",
                          {0, static_cast<float>(maxTextures - 1), 0.05F, {}}),
    param<&Unit::envMode>("envMode", "Environment", "Environment mode",
                          "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, {})",
                          "How the texture's colour and the fragment's colour are combined."),
    color<&Unit::envColor>(
        "envColor", "Environment", "Environment colour",
        "glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, {})",
        "The constant colour that GL_BLEND mixes in and that GL_COMBINE can use as GL_CONSTANT."),
    param<&Unit::lodBias>("lodBias", "Level of detail", "LOD bias",
                          "glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, {})",
                          "Added to the level of detail. Above 0 blurs, below 0 sharpens and aliases.",
                          {-16, 16, 0.02F, word("levels")}),
};

constexpr std::array matrixStepRows{
    param<&MatrixStep::op>("op", "Step", "Operation", "", "What this step does to the texture coordinates."),
    param<&MatrixStep::amount>("amount", "Step", "Amount", "",
                               "The offset, the factors, or the axis of the rotation, at time 0.",
                               {-1000, 1000, 0.01F, {}}),
    param<&MatrixStep::pivot>(
        "pivot", "Step", "About", "",
        "The fixed point of a rotation or a scale. (0.5, 0.5, 0) is the middle of an image.",
        {-1000, 1000, 0.01F, {}}),
    param<&MatrixStep::matrix>("matrix", "Step", "Matrix", "",
                               "16 numbers, column by column as OpenGL takes them. The last four are the "
                               "offset.",
                               {-1e6F, 1e6F, 0.01F, {}}),
    param<&MatrixStep::angle>("angle", "Step", "Angle", "glRotatef({}, x, y, z)",
                              "The angle of a rotation at time 0. Translations and scales ignore it.",
                              {-360, 360, 0.5F, "deg"}),
    param<&MatrixStep::rate>("rate", "Animation", "Rate", "", "Added to the amount every second.",
                             {-1000, 1000, 0.01F, "/s"}),
    param<&MatrixStep::angleRate>("angleRate", "Animation", "Angle rate", "",
                                  "Added to the angle every second.", {-3600, 3600, 0.5F, "deg/s"}),
};
static_assert(matrixStepRows.size() == 7 && matrixStepRows.size() == build::memberCount<MatrixStep>());

constexpr std::array combineRows{
    param<&Combine::rgb>("rgb", "Colour", "Colour function", "glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, {})",
                         "The function that combines the arguments, for red, green and blue."),
    param<&Combine::source0Rgb>("source0Rgb", "Colour", "Colour source 0",
                                "glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, {})",
                                "Where the first argument comes from."),
    param<&Combine::operand0Rgb>("operand0Rgb", "Colour", "Colour operand 0",
                                 "glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_RGB, {})",
                                 "Which components of source 0 are used, and whether they are inverted."),
    param<&Combine::source1Rgb>("source1Rgb", "Colour", "Colour source 1",
                                "glTexEnvi(GL_TEXTURE_ENV, GL_SRC1_RGB, {})",
                                "Where the second argument comes from. GL_REPLACE ignores it."),
    param<&Combine::operand1Rgb>("operand1Rgb", "Colour", "Colour operand 1",
                                 "glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND1_RGB, {})",
                                 "Which components of source 1 are used, and whether they are inverted."),
    param<&Combine::source2Rgb>("source2Rgb", "Colour", "Colour source 2",
                                "glTexEnvi(GL_TEXTURE_ENV, GL_SRC2_RGB, {})",
                                "Where the third argument comes from. Only GL_INTERPOLATE uses it."),
    param<&Combine::operand2Rgb>("operand2Rgb", "Colour", "Colour operand 2",
                                 "glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND2_RGB, {})",
                                 "Which components of source 2 are used, and whether they are inverted."),
    param<&Combine::rgbScale>("rgbScale", "Colour", "Colour scale",
                              "glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, {})",
                              "The factor of the result before it is clamped to 1."),
    param<&Combine::alpha>("alpha", "Alpha", "Alpha function",
                           "glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, {})",
                           "The function that combines the arguments, for alpha. GL_DOT3_RGBA overrides it."),
    param<&Combine::source0Alpha>("source0Alpha", "Alpha", "Alpha source 0",
                                  "glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_ALPHA, {})",
                                  "Where the first argument comes from."),
    param<&Combine::operand0Alpha>("operand0Alpha", "Alpha", "Alpha operand 0",
                                   "glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_ALPHA, {})",
                                   "Whether the alpha of source 0 is used as it is or inverted."),
    param<&Combine::source1Alpha>("source1Alpha", "Alpha", "Alpha source 1",
                                  "glTexEnvi(GL_TEXTURE_ENV, GL_SRC1_ALPHA, {})",
                                  "Where the second argument comes from. GL_REPLACE ignores it."),
    param<&Combine::operand1Alpha>("operand1Alpha", "Alpha", "Alpha operand 1",
                                   "glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND1_ALPHA, {})",
                                   "Whether the alpha of source 1 is used as it is or inverted."),
    param<&Combine::source2Alpha>("source2Alpha", "Alpha", "Alpha source 2",
                                  "glTexEnvi(GL_TEXTURE_ENV, GL_SRC2_ALPHA, {})",
                                  "Where the third argument comes from. Only GL_INTERPOLATE uses it."),
    param<&Combine::operand2Alpha>("operand2Alpha", "Alpha", "Alpha operand 2",
                                   "glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND2_ALPHA, {})",
                                   "Whether the alpha of source 2 is used as it is or inverted."),
    param<&Combine::alphaScale>("alphaScale", "Alpha", "Alpha scale",
                                "glTexEnvf(GL_TEXTURE_ENV, GL_ALPHA_SCALE, {})",
                                "The factor of the result before it is clamped to 1."),
};
static_assert(combineRows.size() == 16 && combineRows.size() == build::memberCount<Combine>());

constexpr std::array embossRows{
    param<&Emboss::enabled>("enabled", "Emboss", "Follow the light", "",
                            "Moves the coordinates of every vertex towards the light, by its distance to "
                            "the side. An image minus its moved copy is a relief."),
    param<&Emboss::depth>("depth", "Emboss", "Depth", "",
                          "The maximum distance that coordinates move, in widths of the image.",
                          {-1, 1, 0.0005F, {}}),
    param<&Emboss::carrier>("carrier", "Emboss", "Light to model by", "",
                            "How the light's position is transformed to the model's coordinates."),
};
static_assert(embossRows.size() == 3 && embossRows.size() == build::memberCount<Emboss>());

struct TexGenCalls {
    std::string_view enable;
    std::string_view mode;
    std::string_view objectPlane;
    std::string_view eyePlane;
    std::span<const EnumRow> modes;
};

constexpr std::array<TexGenCalls, 4> texGenCalls{{
    {"glEnable(GL_TEXTURE_GEN_S)", "glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, {})",
     "glTexGenfv(GL_S, GL_OBJECT_PLANE, {})", "glTexGenfv(GL_S, GL_EYE_PLANE, {})", texGenModeRows},
    {"glEnable(GL_TEXTURE_GEN_T)", "glTexGeni(GL_T, GL_TEXTURE_GEN_MODE, {})",
     "glTexGenfv(GL_T, GL_OBJECT_PLANE, {})", "glTexGenfv(GL_T, GL_EYE_PLANE, {})", texGenModeRows},
    {"glEnable(GL_TEXTURE_GEN_R)", "glTexGeni(GL_R, GL_TEXTURE_GEN_MODE, {})",
     "glTexGenfv(GL_R, GL_OBJECT_PLANE, {})", "glTexGenfv(GL_R, GL_EYE_PLANE, {})", texGenModesOfR},
    {"glEnable(GL_TEXTURE_GEN_Q)", "glTexGeni(GL_Q, GL_TEXTURE_GEN_MODE, {})",
     "glTexGenfv(GL_Q, GL_OBJECT_PLANE, {})", "glTexGenfv(GL_Q, GL_EYE_PLANE, {})", texGenModesOfQ},
}};

constexpr auto texGenRows(const TexGenCalls& calls) {
    ParamRow mode = param<&TexGen::mode>("mode", "Generation", "Generation mode", calls.mode,
                                         "What the coordinate is computed from, instead of the vertex's "
                                         "own.");
    mode.choices = calls.modes;
    return std::array{
        param<&TexGen::enabled>("enabled", "Generation", "Enabled", calls.enable,
                                "Whether OpenGL generates this coordinate, before the texture matrix."),
        mode,
        param<&TexGen::objectPlane>(
            "objectPlane", "Generation", "Object plane", calls.objectPlane,
            "For GL_OBJECT_LINEAR: the coordinate is x*x0 + y*y0 + z*z0 + w*w0, of these four numbers and "
            "the vertex in model coordinates.",
            {-1000, 1000, 0.01F, {}}),
        param<&TexGen::eyePlane>(
            "eyePlane", "Generation", "Eye plane", calls.eyePlane,
            "For GL_EYE_LINEAR: the same with the vertex in eye coordinates. The eye is at the origin and "
            "looks along -z.",
            {-1000, 1000, 0.01F, {}}),
    };
}

constexpr std::array texGenTableRows{texGenRows(texGenCalls[0]), texGenRows(texGenCalls[1]),
                                     texGenRows(texGenCalls[2]), texGenRows(texGenCalls[3])};
static_assert(texGenTableRows[0].size() == 4 && texGenTableRows[0].size() == build::memberCount<TexGen>());

} // namespace

const StructTable& combineTable() {
    static const StructTable table{"Combine", combineRows, {}};
    return table;
}

const StructTable& embossTable() {
    static const StructTable table{"Emboss", embossRows, {}};
    return table;
}

const StructTable& texGenTable(std::size_t coordinate) {
    static const std::array tables{
        StructTable{"TexGenS", texGenTableRows[0], {}}, StructTable{"TexGenT", texGenTableRows[1], {}},
        StructTable{"TexGenR", texGenTableRows[2], {}}, StructTable{"TexGenQ", texGenTableRows[3], {}}};
    return tables[coordinate];
}

const StructTable& matrixStepTable() {
    static const StructTable table{"MatrixStep", matrixStepRows, {}};
    return table;
}

const StructTable& unitTable() {
    static const std::array children{
        build::single<&Unit::combine>("combine", "Combine", combineTable()),
        build::single<&Unit::texGenS>("texGenS", "Generated s", texGenTable(0)),
        build::single<&Unit::texGenT>("texGenT", "Generated t", texGenTable(1)),
        build::single<&Unit::texGenR>("texGenR", "Generated r", texGenTable(2)),
        build::single<&Unit::texGenQ>("texGenQ", "Generated q", texGenTable(3)),
        build::single<&Unit::emboss>("emboss", "Emboss", embossTable()),
        build::many<&Unit::matrix>("matrix", "Matrix step", matrixStepTable(), 0, maxMatrixSteps),
    };
    static_assert(unitRows.size() == 6 && unitRows.size() + children.size() == build::memberCount<Unit>());
    static const StructTable table{"Unit", unitRows, children};
    return table;
}

} // namespace texplorer
