#include "texplorer/base/translatable.h"
#include "texplorer/scene/params/param_builder.h"

#include <array>

namespace texplorer {
namespace {

using build::color;
using build::param;

constexpr std::array unitRows{
    param<&Unit::enabled>("enabled", N_("Unit"), N_("Enabled"), "glEnable(target)",
                          N_("Whether this unit applies its texture to the result of the units before it.")),
    param<&Unit::target>("target", N_("Unit"), N_("Target"), "glEnable({})",
                         N_("Whether the texture is a line, an image, a volume or the six faces of a cube.")),
    param<&Unit::texture>("texture", N_("Unit"), N_("Texture"), "glBindTexture(target, textures[{}])",
                          N_("The texture of the scene that is bound, counted from 0."),
                          {0, static_cast<float>(maxTextures - 1), 0.05F, {}}),
    param<&Unit::envMode>("envMode", N_("Environment"), N_("Environment mode"),
                          "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, {})",
                          N_("How the texture's colour and the fragment's colour are combined.")),
    color<&Unit::envColor>(
        "envColor", N_("Environment"), N_("Environment colour"),
        "glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, {})",
        N_("The constant colour that GL_BLEND mixes in and that GL_COMBINE can use as GL_CONSTANT.")),
    param<&Unit::lodBias>("lodBias", N_("Level of detail"), N_("LOD bias"),
                          "glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, {})",
                          N_("Added to the level of detail. Above 0 blurs, below 0 sharpens and aliases."),
                          {-16, 16, 0.02F, N_("levels")}),
    param<&Unit::matrixStart>("matrixStart", N_("Texture matrix"), N_("Begins with"), "",
                              N_("What the texture matrix is before the steps of this pass. A frame begins "
                                 "with the identity.")),
};

constexpr std::array matrixStepRows{
    param<&MatrixStep::op>("op", N_("Step"), N_("Operation"), "",
                           N_("What this step does to the texture coordinates.")),
    param<&MatrixStep::amount>("amount", N_("Step"), N_("Amount"), "",
                               N_("The offset, the factors, or the axis of the rotation, at time 0."),
                               {-1000, 1000, 0.01F, {}}),
    param<&MatrixStep::pivot>(
        "pivot", N_("Step"), N_("About"), "",
        N_("The fixed point of a rotation or a scale. (0.5, 0.5, 0) is the middle of an image."),
        {-1000, 1000, 0.01F, {}}),
    param<&MatrixStep::matrix>("matrix", N_("Step"), N_("Matrix"), "",
                               N_("16 numbers, column by column as OpenGL takes them. The last four are the "
                                  "offset."),
                               {-1e6F, 1e6F, 0.01F, {}}),
    param<&MatrixStep::angle>("angle", N_("Step"), N_("Angle"), "glRotatef({}, x, y, z)",
                              N_("The angle of a rotation at time 0. Translations and scales ignore it."),
                              {-360, 360, 0.5F, N_("deg")}),
    param<&MatrixStep::rate>("rate", N_("Animation"), N_("Rate"), "", N_("Added to the amount every second."),
                             {-1000, 1000, 0.01F, N_("/s")}),
    param<&MatrixStep::angleRate>("angleRate", N_("Animation"), N_("Angle rate"), "",
                                  N_("Added to the angle every second."), {-3600, 3600, 0.5F, N_("deg/s")}),
};
static_assert(matrixStepRows.size() == 7 && matrixStepRows.size() == build::memberCount<MatrixStep>());

constexpr std::array combineRows{
    param<&Combine::rgb>("rgb", N_("Colour"), N_("Colour function"),
                         "glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, {})",
                         N_("The function that combines the arguments, for red, green and blue.")),
    param<&Combine::source0Rgb>("source0Rgb", N_("Colour"), N_("Colour source 0"),
                                "glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, {})",
                                N_("Where the first argument comes from.")),
    param<&Combine::operand0Rgb>("operand0Rgb", N_("Colour"), N_("Colour operand 0"),
                                 "glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_RGB, {})",
                                 N_("Which components of source 0 are used, and whether they are inverted.")),
    param<&Combine::source1Rgb>("source1Rgb", N_("Colour"), N_("Colour source 1"),
                                "glTexEnvi(GL_TEXTURE_ENV, GL_SRC1_RGB, {})",
                                N_("Where the second argument comes from. GL_REPLACE ignores it.")),
    param<&Combine::operand1Rgb>("operand1Rgb", N_("Colour"), N_("Colour operand 1"),
                                 "glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND1_RGB, {})",
                                 N_("Which components of source 1 are used, and whether they are inverted.")),
    param<&Combine::source2Rgb>("source2Rgb", N_("Colour"), N_("Colour source 2"),
                                "glTexEnvi(GL_TEXTURE_ENV, GL_SRC2_RGB, {})",
                                N_("Where the third argument comes from. Only GL_INTERPOLATE uses it.")),
    param<&Combine::operand2Rgb>("operand2Rgb", N_("Colour"), N_("Colour operand 2"),
                                 "glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND2_RGB, {})",
                                 N_("Which components of source 2 are used, and whether they are inverted.")),
    param<&Combine::rgbScale>("rgbScale", N_("Colour"), N_("Colour scale"),
                              "glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, {})",
                              N_("The factor of the result before it is clamped to 1.")),
    param<&Combine::alpha>(
        "alpha", N_("Alpha"), N_("Alpha function"), "glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, {})",
        N_("The function that combines the arguments, for alpha. GL_DOT3_RGBA overrides it.")),
    param<&Combine::source0Alpha>("source0Alpha", N_("Alpha"), N_("Alpha source 0"),
                                  "glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_ALPHA, {})",
                                  N_("Where the first argument comes from.")),
    param<&Combine::operand0Alpha>("operand0Alpha", N_("Alpha"), N_("Alpha operand 0"),
                                   "glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_ALPHA, {})",
                                   N_("Whether the alpha of source 0 is used as it is or inverted.")),
    param<&Combine::source1Alpha>("source1Alpha", N_("Alpha"), N_("Alpha source 1"),
                                  "glTexEnvi(GL_TEXTURE_ENV, GL_SRC1_ALPHA, {})",
                                  N_("Where the second argument comes from. GL_REPLACE ignores it.")),
    param<&Combine::operand1Alpha>("operand1Alpha", N_("Alpha"), N_("Alpha operand 1"),
                                   "glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND1_ALPHA, {})",
                                   N_("Whether the alpha of source 1 is used as it is or inverted.")),
    param<&Combine::source2Alpha>("source2Alpha", N_("Alpha"), N_("Alpha source 2"),
                                  "glTexEnvi(GL_TEXTURE_ENV, GL_SRC2_ALPHA, {})",
                                  N_("Where the third argument comes from. Only GL_INTERPOLATE uses it.")),
    param<&Combine::operand2Alpha>("operand2Alpha", N_("Alpha"), N_("Alpha operand 2"),
                                   "glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND2_ALPHA, {})",
                                   N_("Whether the alpha of source 2 is used as it is or inverted.")),
    param<&Combine::alphaScale>("alphaScale", N_("Alpha"), N_("Alpha scale"),
                                "glTexEnvf(GL_TEXTURE_ENV, GL_ALPHA_SCALE, {})",
                                N_("The factor of the result before it is clamped to 1.")),
};
static_assert(combineRows.size() == 16 && combineRows.size() == build::memberCount<Combine>());

constexpr std::array embossRows{
    param<&Emboss::enabled>("enabled", N_("Emboss"), N_("Follow the light"), "",
                            N_("Moves the coordinates of every vertex towards the light, by its distance to "
                               "the side. An image minus its moved copy is a relief.")),
    param<&Emboss::depth>("depth", N_("Emboss"), N_("Depth"), "",
                          N_("The maximum distance that coordinates move, in widths of the image."),
                          {-1, 1, 0.0005F, {}}),
    param<&Emboss::carrier>("carrier", N_("Emboss"), N_("Light to model by"), "",
                            N_("How the light's position is transformed to the model's coordinates.")),
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
    ParamRow mode = param<&TexGen::mode>("mode", N_("Generation"), N_("Generation mode"), calls.mode,
                                         N_("What the coordinate is computed from, instead of the vertex's "
                                            "own."));
    mode.choices = calls.modes;
    return std::array{
        param<&TexGen::enabled>("enabled", N_("Generation"), N_("Enabled"), calls.enable,
                                N_("Whether OpenGL generates this coordinate, before the texture matrix.")),
        mode,
        param<&TexGen::objectPlane>(
            "objectPlane", N_("Generation"), N_("Object plane"), calls.objectPlane,
            N_("For GL_OBJECT_LINEAR: the coordinate is x*x0 + y*y0 + z*z0 + w*w0, of these four numbers and "
               "the vertex in model coordinates."),
            {-1000, 1000, 0.01F, {}}),
        param<&TexGen::eyePlane>(
            "eyePlane", N_("Generation"), N_("Eye plane"), calls.eyePlane,
            N_("For GL_EYE_LINEAR: the same with the vertex in eye coordinates. The eye is at the origin and "
               "looks along -z."),
            {-1000, 1000, 0.01F, {}}),
    };
}

constexpr std::array texGenTableRows{texGenRows(texGenCalls[0]), texGenRows(texGenCalls[1]),
                                     texGenRows(texGenCalls[2]), texGenRows(texGenCalls[3])};
static_assert(texGenTableRows[0].size() == 4 && texGenTableRows[0].size() == build::memberCount<TexGen>());

} // namespace

const StructTable& combineTable() {
    static const StructTable table{N_("Combine"), combineRows, {}};
    return table;
}

const StructTable& embossTable() {
    static const StructTable table{N_("Emboss"), embossRows, {}};
    return table;
}

const StructTable& texGenTable(std::size_t coordinate) {
    static const std::array tables{StructTable{N_("TexGenS"), texGenTableRows[0], {}},
                                   StructTable{N_("TexGenT"), texGenTableRows[1], {}},
                                   StructTable{N_("TexGenR"), texGenTableRows[2], {}},
                                   StructTable{N_("TexGenQ"), texGenTableRows[3], {}}};
    return tables[coordinate];
}

const StructTable& matrixStepTable() {
    static const StructTable table{N_("MatrixStep"), matrixStepRows, {}};
    return table;
}

const StructTable& unitTable() {
    static const std::array children{
        build::single<&Unit::combine>("combine", N_("Combine"), combineTable()),
        build::single<&Unit::texGenS>("texGenS", N_("Generated s"), texGenTable(0)),
        build::single<&Unit::texGenT>("texGenT", N_("Generated t"), texGenTable(1)),
        build::single<&Unit::texGenR>("texGenR", N_("Generated r"), texGenTable(2)),
        build::single<&Unit::texGenQ>("texGenQ", N_("Generated q"), texGenTable(3)),
        build::single<&Unit::emboss>("emboss", N_("Emboss"), embossTable()),
        build::many<&Unit::matrix>("matrix", N_("Matrix step"), matrixStepTable(), 0, maxMatrixSteps),
    };
    static_assert(unitRows.size() == 7 && unitRows.size() + children.size() == build::memberCount<Unit>());
    static const StructTable table{N_("Unit"), unitRows, children};
    return table;
}

} // namespace texplorer
