#include "texplorer/scene/params/param_builder.h"

namespace texplorer {
namespace {

using build::color;
using build::param;

constexpr std::array lightRows{
    param<&Light::position>(
        "position", N_("Light 0"), N_("Position"), "glLightfv(GL_LIGHT0, GL_POSITION, {})",
        N_("In eye coordinates, so the light moves with the camera. With w = 0 it is the direction towards an "
           "infinitely distant light."),
        {-1000, 1000, 0.01F, {}}),
    color<&Light::ambient>("ambient", N_("Light 0"), N_("Ambient"), "glLightfv(GL_LIGHT0, GL_AMBIENT, {})",
                           N_("The light that this source adds everywhere, also on faces that look away from "
                              "it.")),
    color<&Light::diffuse>(
        "diffuse", N_("Light 0"), N_("Diffuse"), "glLightfv(GL_LIGHT0, GL_DIFFUSE, {})",
        N_("The light that a face scatters. The more the face looks towards the light, the brighter it is.")),
    color<&Light::specular>(
        "specular", N_("Light 0"), N_("Specular"), "glLightfv(GL_LIGHT0, GL_SPECULAR, {})",
        N_("The colour of highlights. It shows only where the material's specular isn't black.")),
    color<&Light::modelAmbient>("modelAmbient", N_("Light model"), N_("Scene ambient"),
                                "glLightModelfv(GL_LIGHT_MODEL_AMBIENT, {})",
                                N_("Light that needs no light source and is the same everywhere.")),
    param<&Light::colorControl>(
        "colorControl", N_("Light model"), N_("Highlight colour"),
        "glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, {})",
        N_("Whether the highlight is added before texturing, which dims it, or after texturing, where it "
           "stays bright.")),
    param<&Light::localViewer>(
        "localViewer", N_("Light model"), N_("Local viewer"),
        "glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, {})",
        N_("Highlights use the real direction to the eye instead of one direction for the whole scene.")),
    param<&Light::twoSide>("twoSide", N_("Light model"), N_("Two sides"),
                           "glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, {})",
                           N_("Back faces, such as the inside of a cup, are lit with the opposite normal.")),
};

constexpr std::array projectorRows{
    param<&Projector::target>("target", N_("Projector"), N_("Target"), "",
                              N_("The point that the light looks at, in eye coordinates."),
                              {-1000, 1000, 0.01F, {}}),
    param<&Projector::fieldOfView>("fieldOfView", N_("Projector"), N_("Field of view"), "",
                                   N_("The angle of the light's square picture, from edge to edge."),
                                   {1, 160, 0.25F, N_("deg")}),
    param<&Projector::nearest>("nearest", N_("Projector"), N_("Near"), "",
                               N_("The distance from the light whose depth is 0."),
                               {0.001F, 1000, 0.01F, {}}),
    param<&Projector::farthest>(
        "farthest", N_("Projector"), N_("Far"), "",
        N_("The distance from the light whose depth is 1. It is greater than the near "
           "one."),
        {0.001F, 10000, 0.05F, {}}),
};
static_assert(projectorRows.size() == 4 && projectorRows.size() == build::memberCount<Projector>());

constexpr std::array materialRows{
    color<&Material::color>(
        "color", N_("Material"), "glColor", "glColor4f({})",
        N_("The fragment's colour before texturing. With lighting it is the ambient and diffuse reflectance "
           "if the next switch is on.")),
    param<&Material::colorMaterial>(
        "colorMaterial", N_("Material"), N_("Colour material"), "glEnable(GL_COLOR_MATERIAL)",
        N_("With lighting, glColor sets the ambient and diffuse reflectance. If off, the two below are used "
           "and glColor has no effect.")),
    color<&Material::ambient>("ambient", N_("Material"), N_("Ambient"),
                              "glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, {})",
                              N_("How much of the ambient light the surface scatters.")),
    color<&Material::diffuse>(
        "diffuse", N_("Material"), N_("Diffuse"), "glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, {})",
        N_("How much of the light's diffuse colour the surface scatters; its alpha is the fragment's.")),
    color<&Material::specular>(
        "specular", N_("Material"), N_("Specular"), "glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, {})",
        N_("How much of the light's specular colour the surface reflects. Black has no highlight.")),
    color<&Material::emission>("emission", N_("Material"), N_("Emission"),
                               "glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, {})",
                               N_("The light that the surface emits by itself.")),
    param<&Material::shininess>(
        "shininess", N_("Material"), N_("Shininess"), "glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, {})",
        N_("The exponent of the highlight. The larger it is, the smaller and sharper the highlight."),
        {0, 128, 0.5F, {}}),
    param<&Material::shadeModel>(
        "shadeModel", N_("Material"), N_("Shading"), "glShadeModel({})",
        N_("Whether lighting is interpolated across a triangle. Texture coordinates always are.")),
};
static_assert(materialRows.back().member == memberId<&Material::shadeModel>);
static_assert(materialRows.size() == 8 && materialRows.size() == build::memberCount<Material>());

} // namespace

const StructTable& lightTable() {
    static const std::array children{
        build::single<&Light::projector>("projector", N_("Projector"), projectorTable()),
    };
    static_assert(lightRows.size() == 8 && lightRows.size() + children.size() == build::memberCount<Light>());
    static const StructTable table{N_("Light"), lightRows, children};
    return table;
}

const StructTable& projectorTable() {
    static const StructTable table{N_("Projector"), projectorRows, {}};
    return table;
}

const StructTable& materialTable() {
    static const StructTable table{N_("Material"), materialRows, {}};
    return table;
}

const StructTable& modelMaterialTable() {
    static const StructTable table{
        N_("Material"), std::span(materialRows).first(materialRows.size() - 1), {}};
    return table;
}

} // namespace texplorer
