// Coordinates that move, by the texture matrix, and those that OpenGL generates.

#include "texplorer/preset/preset_rows.h"
#include "texplorer/scene/light_projection.h"
#include "texplorer/scene/show_shapes.h"

#include <algorithm>
#include <array>
#include <utility>

namespace texplorer::preset {
namespace {

constexpr std::string_view motionGroup = N_("Texture matrix");
constexpr std::string_view generatedGroup = N_("Generated coordinates");
constexpr glm::vec3 centre{0.5F, 0.5F, 0};

Result<void> moveBy(const PresetTarget& target, std::vector<MatrixStep> steps) {
    target.unit.matrix = std::move(steps);
    return {};
}

Result<void> scroll(const PresetTarget& target) {
    return moveBy(target, {{.op = MatrixOp::Translate, .rate = {0.25F, 0, 0}}});
}

MatrixStep turning(float rate, glm::vec3 pivot) {
    return {.op = MatrixOp::Rotate, .amount = {0, 0, 1}, .angleRate = rate, .pivot = pivot};
}

Result<void> spin(const PresetTarget& target) {
    return moveBy(target, {turning(45, {})});
}

Result<void> rotateAboutCentre(const PresetTarget& target) {
    return moveBy(target, {turning(45, centre)});
}

/// A stretch whose direction turns: along each axis the factor goes up and down, and it never grows beyond
/// all bounds as one with a rate does.
Result<void> pulse(const PresetTarget& target) {
    return moveBy(target, {turning(60, centre),
                           {.op = MatrixOp::Scale, .amount = {0.7F, 1.3F, 1}, .pivot = centre},
                           turning(-60, centre)});
}

void generate(Unit& unit, Target target, TexGenMode mode, int coordinates) {
    takeGivenCoordinates(unit, target);
    for (TexGen* each : {&unit.texGenS, &unit.texGenT, &unit.texGenR}) {
        if (coordinates-- == 0)
            break;
        each->enabled = true;
        each->mode = mode;
    }
}

Result<void> sphereMap(const PresetTarget& target) {
    showPatternUnlessOwn(target.texture, Pattern::MirrorBall);
    generate(target.unit, Target::Texture2D, TexGenMode::SphereMap, 2);
    return {};
}

Result<void> contours(const PresetTarget& target) {
    showPattern(target.texture, Pattern::CheckerRed);
    target.texture.internalFormat = InternalFormat::Intensity;
    target.unit.envMode = EnvMode::Blend;
    target.unit.envColor = {0.15F, 0.3F, 0.1F, 1};
    generate(target.unit, Target::Texture1D, TexGenMode::ObjectLinear, 1);
    target.unit.texGenS.objectPlane = {0, 3, 0, 0};
    return {};
}

Result<void> reflection(const PresetTarget& target) {
    showPattern(target.texture, Pattern::CubeFaces);
    Texture& texture = target.texture;
    texture.wrapS = texture.wrapT = texture.wrapR = Wrap::ClampToEdge;
    generate(target.unit, Target::CubeMap, TexGenMode::ReflectionMap, 3);
    return {};
}

Result<void> projector(const PresetTarget& target) {
    showPatternUnlessOwn(target.texture, Pattern::Planet);
    Texture& texture = target.texture;
    texture.wrapS = texture.wrapT = Wrap::ClampToBorder;
    texture.borderColor = glm::vec4(1);
    target.unit.envMode = EnvMode::Modulate;
    target.pass.lighting = true; // what is turned away from the light stays dark
    takeGivenCoordinates(target.unit);
    projectFromLight(target.unit); // an empty matrix has room for it
    return {};
}

bool showsShadows(const Scene& scene, const Unit& unit) {
    const auto texture = static_cast<std::size_t>(unit.texture);
    return unit.enabled && texture < scene.textures.size() &&
           scene.textures[texture].source == SourceKind::LightDepth;
}

Result<void> shadowMap(const PresetTarget& target) {
    Scene& scene = target.scene;
    showShape(scene, Shape::Floor);
    if (std::ranges::any_of(target.pass.units, [&](const Unit& unit) { return showsShadows(scene, unit); }))
        return {};
    const Result<std::size_t> unit = freeUnit(target);
    if (!unit)
        return fail(unit.error());
    if (!castShadows(scene, target.place.pass, *unit))
        return fail(ErrorCode::TooLarge, "the scene cannot have another texture");
    return {};
}

constexpr std::array coordinateRows{
    Preset{"scroll", motionGroup, N_("Scroll"),
           N_("Replaces the steps of the texture matrix by a translation with a rate."),
           N_("The image moves over the surface towards smaller s, like water or a conveyor belt."), scroll},
    Preset{"spin", motionGroup, N_("Spin"),
           N_("Replaces the steps of the texture matrix by a rotation with a rate."),
           N_("The image turns about (0, 0), one of its corners: glRotatef has no other centre."), spin},
    Preset{"rotate-centre", motionGroup, N_("Rotate about the centre"),
           N_("The same about (0.5, 0.5): glTranslatef there, glRotatef, glTranslatef back."),
           N_("The centre of the image stays where it is."), rotateAboutCentre},
    Preset{
        "pulse", motionGroup, N_("Pulse"), N_("Scales between two opposite rotations, all about the centre."),
        N_("The image grows and shrinks along a rotating axis. A factor below 1 enlarges a smaller part of it."),
        pulse},
    Preset{
        "sphere-map", generatedGroup, N_("Sphere map"),
        N_("glTexGen with GL_SPHERE_MAP for s and t, and the image of a mirror ball."),
        N_("The surface reflects an image. Orbit: the reflection moves with the eye, not with the surface."),
        sphereMap},
    Preset{"contours", generatedGroup, N_("Contour lines"),
           N_("glTexGen with GL_OBJECT_LINEAR for s, and a one-dimensional texture."),
           N_("Equal heights have one colour: s is three times the y of each vertex."), contours},
    Preset{"reflection", generatedGroup, N_("Cube map reflection"),
           N_("glTexGen with GL_REFLECTION_MAP for s, t and r, and a cube map."),
           N_("The surface reflects the face that the reflected line of sight hits. Each face shows the name "
              "of its axis."),
           reflection},
    Preset{
        "projector", generatedGroup, N_("Slide projector"),
        N_("glTexGen with GL_EYE_LINEAR for s, t, r and q, and a texture matrix for the light's view."),
        N_("The light projects one image over all models. Surfaces that face away from it stay dark. Outside "
           "the image, the white border leaves colours unchanged."),
        projector},
    Preset{"shadow-map", generatedGroup, N_("Shadow map"),
           N_("A depth texture of the light's view in a unit of its own, and a floor that receives shadows."),
           N_("Surfaces that the light does not see are dark: r is compared with the depth stored by the "
              "light."),
           shadowMap},
};

} // namespace

std::span<const Preset> coordinatePresets() {
    return coordinateRows;
}

} // namespace texplorer::preset
