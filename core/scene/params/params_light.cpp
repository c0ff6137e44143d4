#include "core/scene/params/param_builder.h"

namespace texplorer {
namespace {

using build::color;
using build::param;

constexpr std::array lightRows{
    param<&Light::position>(
        "position", "Light 0", "Position", "glLightfv(GL_LIGHT0, GL_POSITION, {})",
        "In eye coordinates: the light travels with the camera. With w = 0 it is a direction "
        "towards a light that is infinitely far away.",
        {-1000, 1000, 0.01F, {}}),
    color<&Light::ambient>("ambient", "Light 0", "Ambient", "glLightfv(GL_LIGHT0, GL_AMBIENT, {})",
                           "What this light adds everywhere, also on faces that look away from it."),
    color<&Light::diffuse>(
        "diffuse", "Light 0", "Diffuse", "glLightfv(GL_LIGHT0, GL_DIFFUSE, {})",
        "The light that a face scatters: the more it looks towards the light, the brighter."),
    color<&Light::specular>(
        "specular", "Light 0", "Specular", "glLightfv(GL_LIGHT0, GL_SPECULAR, {})",
        "The colour of highlights; it shows only where the material's specular isn't black."),
    color<&Light::modelAmbient>("modelAmbient", "Light model", "Scene ambient",
                                "glLightModelfv(GL_LIGHT_MODEL_AMBIENT, {})",
                                "Light that is there without any light source, everywhere the same."),
    param<&Light::colorControl>(
        "colorControl", "Light model", "Highlight colour", "glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, {})",
        "Whether the highlight is added before texturing, where the texture dims it, or "
        "afterwards, where it stays bright."),
    param<&Light::localViewer>(
        "localViewer", "Light model", "Local viewer", "glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, {})",
        "Highlights follow the real direction to the eye instead of one that is the same "
        "for the whole scene."),
    param<&Light::twoSide>(
        "twoSide", "Light model", "Two sides", "glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, {})",
        "Faces that look away from the eye are lit with the opposite normal, as the inside of a cup."),
};

constexpr std::array projectorRows{
    param<&Projector::target>("target", "Projector", "Target", "",
                              "The point that the light looks at, in eye coordinates.",
                              {-1000, 1000, 0.01F, {}}),
    param<&Projector::fieldOfView>("fieldOfView", "Projector", "Field of view", "",
                                   "How wide the light's square picture is, from edge to edge.",
                                   {1, 160, 0.25F, "deg"}),
    param<&Projector::nearest>("nearest", "Projector", "Near", "",
                               "The distance from the light whose depth is 0.", {0.001F, 1000, 0.01F, {}}),
    param<&Projector::farthest>("farthest", "Projector", "Far", "",
                                "The distance from the light whose depth is 1; beyond the near one.",
                                {0.001F, 10000, 0.05F, {}}),
};
static_assert(projectorRows.size() == 4 && projectorRows.size() == build::memberCount<Projector>());

constexpr std::array materialRows{
    color<&Material::color>(
        "color", "Material", "glColor", "glColor4f({})",
        "The fragment's colour before texturing. Under lighting it is the ambient and diffuse "
        "reflectance where the next switch says so."),
    param<&Material::colorMaterial>(
        "colorMaterial", "Material", "Colour material", "glEnable(GL_COLOR_MATERIAL)",
        "Whether glColor is the ambient and diffuse reflectance under lighting. Without it those below are, "
        "and glColor counts for nothing there."),
    color<&Material::ambient>("ambient", "Material", "Ambient",
                              "glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, {})",
                              "How much of the ambient light the surface scatters."),
    color<&Material::diffuse>(
        "diffuse", "Material", "Diffuse", "glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, {})",
        "How much of the light's diffuse colour the surface scatters; its alpha is the fragment's."),
    color<&Material::specular>(
        "specular", "Material", "Specular", "glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, {})",
        "How much of the light's specular colour the surface mirrors; black has no highlight."),
    color<&Material::emission>("emission", "Material", "Emission",
                               "glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, {})",
                               "What the surface shines with itself, without any light."),
    param<&Material::shininess>(
        "shininess", "Material", "Shininess", "glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, {})",
        "The exponent of the highlight: the larger, the smaller and sharper it is.", {0, 128, 0.5F, {}}),
    param<&Material::shadeModel>(
        "shadeModel", "Material", "Shading", "glShadeModel({})",
        "Whether lighting is interpolated across a triangle. Texture coordinates always are."),
};
static_assert(materialRows.back().member == memberId<&Material::shadeModel>);
static_assert(materialRows.size() == 8 && materialRows.size() == build::memberCount<Material>());

} // namespace

const StructTable& lightTable() {
    static const std::array children{
        build::single<&Light::projector>("projector", "Projector", projectorTable()),
    };
    static_assert(lightRows.size() == 8 && lightRows.size() + children.size() == build::memberCount<Light>());
    static const StructTable table{"Light", lightRows, children};
    return table;
}

const StructTable& projectorTable() {
    static const StructTable table{"Projector", projectorRows, {}};
    return table;
}

const StructTable& materialTable() {
    static const StructTable table{"Material", materialRows, {}};
    return table;
}

const StructTable& modelMaterialTable() {
    static const StructTable table{"Material", std::span(materialRows).first(materialRows.size() - 1), {}};
    return table;
}

} // namespace texplorer
