#pragma once

// The Scene: everything that decides what is drawn, as a value. It copies, compares and holds no handle.
// Default member values are OpenGL's own initial values wherever GL has one (OpenGL 2.1, chapter 6.2, state
// tables). What GL keeps in the texture object and what it keeps in the texture unit is kept apart in the
// same way.

#include "core/gl/combine.h"
#include "core/gl/environment.h"
#include "core/gl/fog.h"
#include "core/gl/fragment.h"
#include "core/gl/hint.h"
#include "core/gl/internal_format.h"
#include "core/gl/sampling.h"
#include "core/gl/tex_gen.h"
#include "core/image/mipmaps.h"
#include "core/image/patterns/pattern.h"
#include "core/image/preparation.h"
#include "core/image/transparency.h"
#include "core/mesh/mesh_data.h"
#include "core/scene/sampler_state.h"
#include "core/scene/texture_options.h"
#include "core/scene/timeline.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <string>
#include <vector>

namespace texplorer {

inline constexpr int maxUnits = 4;
inline constexpr std::size_t maxModels = 16;
inline constexpr std::size_t maxTextures = 64;
inline constexpr std::size_t maxPasses = 8;
inline constexpr std::size_t maxMatrixSteps = 32;
inline constexpr std::size_t maxGivenLevels = 15; ///< beside the base level
inline constexpr std::size_t maxImageSteps = 16;

enum class Projection : std::uint32_t { Perspective, Orthographic };
enum class SourceKind : std::uint32_t { Pattern, File, LightDepth };
enum class MatrixOp : std::uint32_t { Translate, Rotate, Scale, Multiply, Load, Projector };
enum class RotationOrder : std::uint32_t { Zyx, Zxy, Yzx, Yxz, Xzy, Xyz };
enum class Attachment : std::uint32_t { World, Eye };
enum class LightCarrier : std::uint32_t { Inverse, Transpose };

/// The camera orbits around `target`.
struct View {
    float azimuth = 0;   ///< degrees around the y axis; 0 looks along -z
    float elevation = 0; ///< degrees above the horizon; beyond 90 the camera has gone over the pole
    float roll = 0;      ///< degrees about the line of sight, clockwise as the camera turns
    float distance = 6;  ///< from camera to target, in scene units
    glm::vec3 target{0};
    Projection projection = Projection::Perspective;
    float fieldOfView = 40; ///< vertical, degrees; orthographic views show the same height at the target
    HintMode perspectiveHint = HintMode::DontCare; ///< GL_PERSPECTIVE_CORRECTION_HINT
    glm::vec4 background{0, 0, 0, 0};

    bool operator==(const View&) const = default;
};

/// What the light sees, as a slide projector or a camera in its place would: a square picture around the line
/// from the light to `target`. A light that is a direction sees in parallel, from half way between nearest
/// and farthest, what the angle shows there.
struct Projector {
    glm::vec3 target{0, 0, -6}; ///< in eye coordinates
    float fieldOfView = 45;     ///< degrees, both ways
    float nearest = 1;          ///< distances between which depths are told apart
    float farthest = 20;

    bool operator==(const Projector&) const = default;
};

/// GL_LIGHT0 and the light model. The position is in eye coordinates (the light travels with the camera).
struct Light {
    glm::vec4 position{0, 0, 1, 0}; ///< w = 0: a direction towards the light
    glm::vec4 ambient{0, 0, 0, 1};
    glm::vec4 diffuse{1, 1, 1, 1};
    glm::vec4 specular{1, 1, 1, 1};
    glm::vec4 modelAmbient{0.2F, 0.2F, 0.2F, 1};
    ColorControl colorControl = ColorControl::Single;
    bool localViewer = false;
    bool twoSide = false; ///< faces that look away are lit by the opposite normal
    Projector projector{};

    bool operator==(const Light&) const = default;
};

/// What glMaterial, glColor4f and glShadeModel set.
struct Material {
    glm::vec4 color{1, 1, 1, 1}; ///< glColor4f
    bool colorMaterial = true;   ///< under lighting `color` is the ambient and diffuse reflectance
    glm::vec4 ambient{0.2F, 0.2F, 0.2F, 1};
    glm::vec4 diffuse{0.8F, 0.8F, 0.8F, 1};
    glm::vec4 specular{0, 0, 0, 1};
    glm::vec4 emission{0, 0, 0, 1};
    float shininess = 0;
    ShadeModel shadeModel = ShadeModel::Smooth; ///< the scene's counts for all models

    bool operator==(const Material&) const = default;
};

/// The coordinates of every vertex for one texture unit; empty means: those of the mesh.
using TexCoords = std::vector<glm::vec4>;

struct Model {
    std::string name{};
    Shape shape = Shape::Cube;
    bool visible = true;
    int slices = 32;
    int stacks = 16;
    float topRadius = 1;
    float innerRadius = 0;
    float tubeRadius = 0.4F;
    float startAngle = 0;
    float sweepAngle = 270;
    glm::vec3 position{0};
    glm::vec3 rotation{0}; ///< degrees about x, y and z, at time 0
    RotationOrder rotationOrder = RotationOrder::Zyx;
    glm::vec3 spin{0}; ///< degrees a second, added to `rotation`
    float size = 1;
    glm::vec3 scale{1}; ///< of each axis, times `size`
    Attachment attachment = Attachment::World;
    float lineWidth = 1; ///< pixels
    float pointSize = 1; ///< pixels
    bool ownMaterial = false;
    Material material{};                         ///< with ownMaterial
    MeshData mesh{};                             ///< for Shape::Mesh
    std::array<TexCoords, maxUnits> texCoords{}; ///< one list a unit; an empty one takes the mesh's

    bool operator==(const Model&) const = default;
};

/// The picture of one mip level.
struct GivenLevel {
    SourceKind source = SourceKind::Pattern; ///< no depths from the light
    Pattern pattern = Pattern::Checker;      ///< scaled to the level's size
    std::string file{};                      ///< as it is, whatever its size

    bool operator==(const GivenLevel&) const = default;
};

/// One thing that is done to a texture's picture before it is uploaded, to all its levels.
struct ImageStep {
    ImageOp op = ImageOp::Scale;
    glm::vec4 factor{1};                     ///< for Scale
    glm::vec4 bias{0};                       ///< for Scale
    float amount = 1;                        ///< for Sharpen
    SourceKind source = SourceKind::Pattern; ///< for AlphaFrom, as the next two; no depths from the light
    Pattern pattern = Pattern::Checker;
    std::string file{};

    bool operator==(const ImageStep&) const = default;
};

/// A texture object: its images and glTexParameter state.
struct Texture : SamplerState {
    SourceKind source = SourceKind::Pattern;
    Pattern pattern = Pattern::Checker;
    std::string file{};  ///< path of an image; relative to the scene file
    int depthSize = 256; ///< texels on each side, of depths from the light
    FlipMode flip = FlipMode::Blocks;
    Transparency transparency = Transparency::File;
    glm::vec4 stencilColor{0, 0, 0, 1}; ///< for Transparency::Stencil; its alpha says nothing
    InternalFormat internalFormat = InternalFormat::Rgba; ///< of a texture that is not compressed
    int border = 0;                                       ///< 0 or 1: glTexImage's; see core/image/border.h
    Compression compression = Compression::FromFile;
    CompressedFormat compressedFormat = CompressedFormat::Dxt1;
    EncodeQuality compressionQuality = EncodeQuality::Normal; ///< for Compression::Cached
    MipPolicy mipmaps = MipPolicy::None;
    MipFilter mipFilter = MipFilter::Box;
    bool mipGamma = false;
    NpotPolicy npot = NpotPolicy::Keep;
    float priority = 1;
    std::vector<GivenLevel> levels{};     ///< 1, 2, 3, …: for MipPolicy::Given
    std::vector<ImageStep> preparation{}; ///< in this order, before everything else but decoding

    bool operator==(const Texture&) const = default;
};

/// One glTranslate, glRotate, glScale, glMultMatrix or glLoadMatrix on the texture matrix, with its rate of
/// change; or the projector, which multiplies.
struct MatrixStep {
    MatrixOp op = MatrixOp::Translate;
    glm::vec3 amount{0}; ///< offset, factor or axis of rotation, at time 0
    glm::vec3 rate{0};   ///< added to `amount` every second
    float angle = 0;     ///< degrees, for Rotate alone, at time 0
    float angleRate = 0; ///< degrees a second
    glm::vec3 pivot{0};  ///< what stays in its place, for Rotate and Scale
    glm::mat4 matrix{1}; ///< for Multiply and Load

    bool operator==(const MatrixStep&) const = default;
};

/// How one of s, t, r and q is generated. The eye plane is given while the modelview matrix is the identity,
/// so that it is in eye coordinates as it stands here.
struct TexGen {
    bool enabled = false;
    TexGenMode mode = TexGenMode::EyeLinear;
    glm::vec4 objectPlane{0};
    glm::vec4 eyePlane{0};

    bool operator==(const TexGen&) const = default;
};

/// Coordinates that follow the light, as an embossed bump map asks for: those of every vertex move by how far
/// the light stands aside, along the image's own axes on the surface.
struct Emboss {
    bool enabled = false;
    float depth = 0.01F; ///< how far they move at most
    LightCarrier carrier = LightCarrier::Inverse;

    bool operator==(const Emboss&) const = default;
};

/// A texture unit: which texture is bound, and the environment that applies it.
struct Unit {
    bool enabled = false;
    Target target = Target::Texture2D;
    int texture = 0; ///< index into Scene::textures
    EnvMode envMode = EnvMode::Modulate;
    glm::vec4 envColor{0, 0, 0, 0};
    float lodBias = 0;
    Combine combine{}; ///< for EnvMode::Combine
    TexGen texGenS{.objectPlane = {1, 0, 0, 0}, .eyePlane = {1, 0, 0, 0}};
    TexGen texGenT{.objectPlane = {0, 1, 0, 0}, .eyePlane = {0, 1, 0, 0}};
    TexGen texGenR{}; ///< has no sphere map
    TexGen texGenQ{}; ///< has eye and object planes alone
    Emboss emboss{};
    std::vector<MatrixStep> matrix{}; ///< multiplied in this order, as successive GL calls are

    bool operator==(const Unit&) const = default;
};

/// glFog: what of a fragment's colour the distance leaves (OpenGL 2.1, section 3.10).
struct Fog {
    bool enabled = false;
    FogMode mode = FogMode::Exp;
    float density = 1; ///< for both exponential modes
    float start = 0;   ///< for Linear: distances from the eye's plane
    float end = 1;
    glm::vec4 color{0, 0, 0, 0}; ///< its alpha says nothing

    bool operator==(const Fog&) const = default;
};

/// One time that models are drawn.
struct Pass {
    bool enabled = true; ///< off: nothing is drawn, and nothing else of it counts
    std::string name{};
    std::vector<int> models{}; ///< indices of those that it draws, in this order; empty: all
    bool lighting = false;
    bool depthTest = false;
    CompareFunc depthFunc = CompareFunc::Less;
    bool alphaTest = false;
    CompareFunc alphaFunc = CompareFunc::Always;
    float alphaRef = 0;
    bool blend = false;
    BlendFactor blendSrc = BlendFactor::One;
    BlendFactor blendDst = BlendFactor::Zero;
    bool seamlessCubeMap = false; ///< GL_TEXTURE_CUBE_MAP_SEAMLESS
    Fog fog{};
    std::array<Unit, maxUnits> units{};

    bool operator==(const Pass&) const = default;
};

struct Scene {
    View view;
    Light light;
    Material material;
    std::vector<Model> models;
    std::vector<Texture> textures;
    std::vector<Pass> passes{Pass{}};
    Timeline timeline{}; ///< what of all this moves: see sceneAt

    bool operator==(const Scene&) const = default;
};

inline constexpr std::array projectionRows{
    row(Projection::Perspective, "perspective", "Perspective", "Far things are smaller, as for an eye."),
    row(Projection::Orthographic, "orthographic", "Orthographic",
        "No foreshortening: a texel has the same size everywhere on a plane."),
};

inline constexpr std::array sourceKindRows{
    row(SourceKind::Pattern, "pattern", "Built-in", "A pattern that Texplorer draws itself."),
    row(SourceKind::File, "file", "Image file", "An image that is read from a file."),
    row(SourceKind::LightDepth, "light-depth", "Shadow map",
        "How far away from the light each point is that it sees, drawn anew with every frame."),
};

inline constexpr std::array matrixOpRows{
    row(MatrixOp::Translate, "translate", "Translate", "Moves the image over the surface (glTranslatef)."),
    row(MatrixOp::Rotate, "rotate", "Rotate", "Turns the image about an axis through (0, 0) (glRotatef)."),
    row(MatrixOp::Scale, "scale", "Scale",
        "A factor of 2 shows the image twice as often, half as big (glScalef)."),
    row(MatrixOp::Multiply, "multiply", "Multiply", "Multiplies by 16 numbers (glMultMatrixf)."),
    row(MatrixOp::Load, "load", "Load",
        "Puts 16 numbers in the place of all that the steps before it made (glLoadMatrixf)."),
    row(MatrixOp::Projector, "projector", "Projector",
        "From eye coordinates to the light's picture: s and t from 0 to 1 across it, r its depth. With "
        "coordinates that are generated in eye space, the light projects the image as a slide."),
};

inline constexpr std::array rotationOrderRows{
    row(RotationOrder::Zyx, "zyx", "x, then y, then z", "glRotatef about z, y, x: x turns the model first."),
    row(RotationOrder::Zxy, "zxy", "y, then x, then z", "glRotatef about z, x, y: y turns the model first."),
    row(RotationOrder::Yzx, "yzx", "x, then z, then y", "glRotatef about y, z, x: x turns the model first."),
    row(RotationOrder::Yxz, "yxz", "z, then x, then y", "glRotatef about y, x, z: z turns the model first."),
    row(RotationOrder::Xzy, "xzy", "y, then z, then x", "glRotatef about x, z, y: y turns the model first."),
    row(RotationOrder::Xyz, "xyz", "z, then y, then x", "glRotatef about x, y, z: z turns the model first."),
};

inline constexpr std::array attachmentRows{
    row(Attachment::World, "world", "The world", "It stays where it is while the camera moves."),
    row(Attachment::Eye, "eye", "The eye",
        "It moves with the camera, as a logo or an instrument: its place is in eye coordinates."),
};

inline constexpr std::array lightCarrierRows{
    row(LightCarrier::Inverse, "inverse", "Inverse matrix",
        "The light's place times the inverse of the modelview matrix: right for every model."),
    row(LightCarrier::Transpose, "transpose", "Transposed inverse",
        "What one gets who multiplies the row instead of the column: the relief is lit as if the model had "
        "turned the other way."),
};

template<>
struct EnumTable<Projection> {
    static constexpr std::span<const EnumRow> rows = projectionRows;
};
template<>
struct EnumTable<SourceKind> {
    static constexpr std::span<const EnumRow> rows = sourceKindRows;
};
/// Of a level's picture and of alpha's: from a pattern or a file.
inline constexpr std::span<const EnumRow> pictureSourceRows = std::span(sourceKindRows).first(2);
template<>
struct EnumTable<MatrixOp> {
    static constexpr std::span<const EnumRow> rows = matrixOpRows;
};
template<>
struct EnumTable<RotationOrder> {
    static constexpr std::span<const EnumRow> rows = rotationOrderRows;
};
template<>
struct EnumTable<Attachment> {
    static constexpr std::span<const EnumRow> rows = attachmentRows;
};
template<>
struct EnumTable<LightCarrier> {
    static constexpr std::span<const EnumRow> rows = lightCarrierRows;
};

static_assert(projectionRows.size() == 2 && sourceKindRows.size() == 3 && matrixOpRows.size() == 6 &&
              rotationOrderRows.size() == 6 && attachmentRows.size() == 2 && lightCarrierRows.size() == 2);

/// What Texplorer starts with: a cube and a sphere side by side, lit, with the checkerboard, trilinear.
[[nodiscard]] Scene defaultScene();

} // namespace texplorer
