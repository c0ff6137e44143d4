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
};
static_assert(lightRows.size() == 7 && lightRows.size() == build::memberCount<Light>());

constexpr std::array materialRows{
    color<&Material::color>(
        "color", "Material", "glColor", "glColor4f({})",
        "The fragment's colour before texturing. Under lighting it is the ambient and diffuse "
        "reflectance (GL_COLOR_MATERIAL)."),
    color<&Material::specular>(
        "specular", "Material", "Specular", "glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, {})",
        "How much of the light's specular colour the surface mirrors; black has no highlight."),
    param<&Material::shininess>(
        "shininess", "Material", "Shininess", "glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, {})",
        "The exponent of the highlight: the larger, the smaller and sharper it is.", {0, 128, 0.5F, {}}),
    param<&Material::shadeModel>(
        "shadeModel", "Material", "Shading", "glShadeModel({})",
        "Whether lighting is interpolated across a triangle. Texture coordinates always are."),
};
static_assert(materialRows.size() == 4 && materialRows.size() == build::memberCount<Material>());

} // namespace

const StructTable& lightTable() {
    static const StructTable table{"Light", lightRows, {}};
    return table;
}

const StructTable& materialTable() {
    static const StructTable table{"Material", materialRows, {}};
    return table;
}

} // namespace texplorer
