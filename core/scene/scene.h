#pragma once

// The Scene: everything that decides what is drawn. A value type without handles. Members default to OpenGL's
// initial values where GL has one (OpenGL 2.1, chapter 6.2, state tables). State of texture objects and of
// texture units is separate, as in GL.

#include "texplorer/gl/combine.h"
#include "texplorer/gl/environment.h"
#include "texplorer/gl/fog.h"
#include "texplorer/gl/fragment.h"
#include "texplorer/gl/hint.h"
#include "texplorer/gl/internal_format.h"
#include "texplorer/gl/sampling.h"
#include "texplorer/gl/tex_gen.h"
#include "texplorer/image/mipmaps.h"
#include "texplorer/image/patterns/pattern.h"
#include "texplorer/image/preparation.h"
#include "texplorer/image/transparency.h"
#include "texplorer/mesh/mesh_data.h"
#include "texplorer/scene/sampler_state.h"
#include "texplorer/scene/texture_options.h"
#include "texplorer/scene/timeline.h"
#include "texplorer/scene/upload.h"

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
inline constexpr std::size_t maxGivenLevels = 15; ///< in addition to the base level
inline constexpr std::size_t maxImageSteps = 16;
inline constexpr std::size_t maxSubimages = 16;
inline constexpr int maxPictures = 8;
inline constexpr int maxFrames = 64;

enum class Projection : std::uint32_t { Perspective, Orthographic };
enum class SourceKind : std::uint32_t { Pattern, File, LightDepth, Picture };
enum class PictureCall : std::uint32_t { Framebuffer, CopyTexImage, CopyTexSubImage };
enum class MatrixOp : std::uint32_t { Translate, Rotate, Scale, Multiply, Load, Projector };
enum class MatrixStart : std::uint32_t { Identity, Push, Keep };
enum class RotationOrder : std::uint32_t { Zyx, Zxy, Yzx, Yxz, Xzy, Xyz };
enum class Attachment : std::uint32_t { World, Eye };
enum class LightCarrier : std::uint32_t { Inverse, Transpose };

/// Whether an image is drawn in every frame.
[[nodiscard]] constexpr bool isDrawn(SourceKind source) {
    return source == SourceKind::LightDepth || source == SourceKind::Picture;
}

/// The camera orbits around `target`.
struct View {
    float azimuth = 0;   ///< degrees around the y axis; 0 looks along -z
    float elevation = 0; ///< degrees above the horizon; beyond 90 the camera is past the pole
    float roll = 0;      ///< degrees about the line of sight, clockwise as the camera turns
    float distance = 6;  ///< from camera to target, in scene units
    glm::vec3 target{0};
    Projection projection = Projection::Perspective;
    float fieldOfView = 40; ///< vertical, degrees; orthographic views have the same height at the target
    HintMode perspectiveHint = HintMode::DontCare; ///< GL_PERSPECTIVE_CORRECTION_HINT
    glm::vec4 background{0, 0, 0, 0};

    bool operator==(const View&) const = default;
};

/// The light's view, like that of a slide projector or a camera at its position: a square picture around the
/// line from the light to `target`. A directional light looks at `target` from the middle of nearest and
/// farthest, by a parallel projection of the extent that the angle has at that distance.
struct Projector {
    glm::vec3 target{0, 0, -6}; ///< in eye coordinates
    float fieldOfView = 45;     ///< degrees, horizontally and vertically
    float nearest = 1;          ///< the range of distances with different depths
    float farthest = 20;

    bool operator==(const Projector&) const = default;
};

/// GL_LIGHT0 and the light model. The position is in eye coordinates (the light moves with the camera).
struct Light {
    glm::vec4 position{0, 0, 1, 0}; ///< w = 0: a direction towards the light
    glm::vec4 ambient{0, 0, 0, 1};
    glm::vec4 diffuse{1, 1, 1, 1};
    glm::vec4 specular{1, 1, 1, 1};
    glm::vec4 modelAmbient{0.2F, 0.2F, 0.2F, 1};
    ColorControl colorControl = ColorControl::Single;
    bool localViewer = false;
    bool twoSide = false; ///< back faces are lit with the opposite normal
    Projector projector{};

    bool operator==(const Light&) const = default;
};

/// The state of glMaterial, glColor4f and glShadeModel.
struct Material {
    glm::vec4 color{1, 1, 1, 1}; ///< glColor4f
    bool colorMaterial = true;   ///< with lighting, `color` is the ambient and diffuse reflectance
    glm::vec4 ambient{0.2F, 0.2F, 0.2F, 1};
    glm::vec4 diffuse{0.8F, 0.8F, 0.8F, 1};
    glm::vec4 specular{0, 0, 0, 1};
    glm::vec4 emission{0, 0, 0, 1};
    float shininess = 0;
    ShadeModel shadeModel = ShadeModel::Smooth; ///< the scene's is used for all models

    bool operator==(const Material&) const = default;
};

/// The coordinates of every vertex for one texture unit.
using TexCoords = std::vector<glm::vec4>;

/// A glTranslate, glRotate, glScale, glMultMatrix or glLoadMatrix on the texture matrix, with its rate of
/// change; or the projector, which multiplies.
struct MatrixStep {
    MatrixOp op = MatrixOp::Translate;
    glm::vec3 amount{0}; ///< offset, factor or axis of rotation, at time 0
    glm::vec3 rate{0};   ///< added to `amount` per second
    float angle = 0;     ///< degrees, only for Rotate, at time 0
    float angleRate = 0; ///< degrees per second
    glm::vec3 pivot{0};  ///< the fixed point, for Rotate and Scale
    glm::mat4 matrix{1}; ///< for Multiply and Load

    bool operator==(const MatrixStep&) const = default;
};

/// What a model has for one texture unit.
struct ModelUnit {
    std::vector<MatrixStep> matrix{}; ///< multiplied after those of the pass: see textureSteps

    bool operator==(const ModelUnit&) const = default;
};

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
    glm::vec3 spin{0}; ///< degrees per second, added to `rotation`
    float size = 1;
    glm::vec3 scale{1}; ///< for each axis, multiplied by `size`
    Attachment attachment = Attachment::World;
    float lineWidth = 1; ///< pixels
    float pointSize = 1; ///< pixels
    bool ownMaterial = false;
    Material material{};                                     ///< if ownMaterial
    MeshData mesh{};                                         ///< for Shape::Mesh
    std::array<SharedList<glm::vec4>, maxUnits> texCoords{}; ///< one list per unit; empty: the mesh's
    /// Per unit: the vertices whose glTexCoord is left out (texplorer/scene/sent_vertices.h).
    std::array<std::vector<int>, maxUnits> noTexCoord{};
    bool pushMatrix = true; ///< glPushMatrix and glPopMatrix around the model: its steps hold for it alone
    std::array<ModelUnit, maxUnits> units{};

    bool operator==(const Model&) const = default;
};

/// The image of one mip level.
struct GivenLevel {
    SourceKind source = SourceKind::Pattern; ///< Pattern or File
    Pattern pattern = Pattern::Checker;      ///< scaled to the level's size
    std::string file{};                      ///< not scaled

    bool operator==(const GivenLevel&) const = default;
};

/// An operation on all levels of a texture's image before the upload.
struct ImageStep {
    ImageOp op = ImageOp::Scale;
    glm::vec4 factor{1};                        ///< for Scale
    glm::vec4 bias{0};                          ///< for Scale
    float amount = 1;                           ///< for Sharpen and Normals
    ComponentSource red = ComponentSource::Red; ///< for Swizzle, like the next three
    ComponentSource green = ComponentSource::Green;
    ComponentSource blue = ComponentSource::Blue;
    ComponentSource alpha = ComponentSource::Alpha;
    float share = 0.5F;                      ///< for Resize: of each extent, rounded down, at least one texel
    int width = 0;                           ///< for Resize, of the base level; 0: by the share
    int height = 0;                          ///< likewise
    SourceKind source = SourceKind::Pattern; ///< of another image, like the next two; Pattern or File
    Pattern pattern = Pattern::Checker;
    std::string file{};

    bool operator==(const ImageStep&) const = default;
};

/// Whether a step reads another image.
[[nodiscard]] inline bool readsOther(const ImageStep& step) {
    return step.op == ImageOp::AlphaFrom ||
           (step.op == ImageOp::Swizzle &&
            (isOfOther(step.red) || isOfOther(step.green) || isOfOther(step.blue) || isOfOther(step.alpha)));
}

/// A part of a level that is replaced after the upload: glTexSubImage (OpenGL 2.1, section 3.8.2).
struct Subimage {
    int level = 0;
    int x = 0; ///< where the part begins, in texels; (0, 0, 0) is the level's first texel
    int y = 0;
    int z = 0;                               ///< for 3D textures
    int width = 8;                           ///< of a pattern, which is scaled to it
    int height = 8;                          ///< likewise
    SourceKind source = SourceKind::Pattern; ///< Pattern or File
    Pattern pattern = Pattern::Checker;
    std::string file{}; ///< not scaled

    bool operator==(const Subimage&) const = default;
};

/// A texture object: its images and glTexParameter state.
struct Texture : SamplerState {
    SourceKind source = SourceKind::Pattern;
    Pattern pattern = Pattern::Checker;
    std::string file{};  ///< path of an image, relative to the scene file
    int depthSize = 256; ///< texels per side, for LightDepth
    int picture = 1;     ///< for Picture, like the next three: the number of passes' picture (Pass::picture)
    int pictureSize = 256; ///< texels per side
    int frames = 1;        ///< that are drawn one after the other: see texplorer/scene/pass_pictures.h
    PictureCall pictureCall = PictureCall::Framebuffer; ///< the call that programs fill it with
    FlipMode flip = FlipMode::Blocks;
    Transparency transparency = Transparency::File;
    glm::vec4 stencilColor{0, 0, 0, 1};                   ///< for Transparency::Stencil; its alpha is ignored
    InternalFormat internalFormat = InternalFormat::Rgba; ///< for a texture without compression
    int border = 0; ///< 0 or 1: that of glTexImage; see texplorer/image/border.h
    Compression compression = Compression::FromFile;
    CompressedFormat compressedFormat = CompressedFormat::Dxt1;
    EncodeQuality compressionQuality = EncodeQuality::Normal; ///< for Compression::Cached
    MipPolicy mipmaps = MipPolicy::None;
    MipFilter mipFilter = MipFilter::Box;
    bool mipGamma = false;
    float mipCoverage = 0; ///< above 0: an alpha test's reference, whose coverage generated levels keep
    NpotPolicy npot = NpotPolicy::Keep;
    Oversize oversize = Oversize::None;
    float priority = 1;
    std::vector<GivenLevel> levels{};     ///< 1, 2, 3, …: for MipPolicy::Given
    std::vector<ImageStep> preparation{}; ///< in this order, before everything else except decoding
    std::vector<Subimage> subimages{};    ///< in this order, after the upload
    Upload upload{};

    bool operator==(const Texture&) const = default;
};

/// How one of s, t, r and q is generated. The eye plane is specified with an identity modelview matrix, so it
/// is in eye coordinates.
struct TexGen {
    bool enabled = false;
    TexGenMode mode = TexGenMode::EyeLinear;
    glm::vec4 objectPlane{0};
    glm::vec4 eyePlane{0};

    bool operator==(const TexGen&) const = default;
};

/// Coordinates that follow the light, for emboss bump mapping: those of every vertex are moved towards the
/// light, along the axes of the image on the surface.
struct Emboss {
    bool enabled = false;
    float depth = 0.01F; ///< the maximum offset
    LightCarrier carrier = LightCarrier::Inverse;

    bool operator==(const Emboss&) const = default;
};

/// A texture unit: the bound texture, and the environment that applies it.
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
    TexGen texGenR{}; ///< cannot be a sphere map
    TexGen texGenQ{}; ///< only eye and object planes
    Emboss emboss{};
    MatrixStart matrixStart = MatrixStart::Identity;
    std::vector<MatrixStep> matrix{}; ///< multiplied in this order, like successive GL calls

    bool operator==(const Unit&) const = default;
};

/// glFog: how the distance blends a fragment's colour (OpenGL 2.1, section 3.10).
struct Fog {
    bool enabled = false;
    FogMode mode = FogMode::Exp;
    float density = 1; ///< for both exponential modes
    float start = 0;   ///< for Linear: a distance from the eye's plane
    float end = 1;
    glm::vec4 color{0, 0, 0, 0}; ///< its alpha is ignored

    bool operator==(const Fog&) const = default;
};

/// Draws models once.
struct Pass {
    bool enabled = true; ///< off: draws nothing and has no effect
    std::string name{};
    int picture = 0; ///< 0: it draws in the window; else in the picture of that number, for textures
    std::vector<int> models{}; ///< indices of the models that it draws, in this order; empty: all
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
    Timeline timeline{}; ///< the animation of the scene: see sceneAt

    bool operator==(const Scene&) const = default;
};

inline constexpr std::array projectionRows{
    row(Projection::Perspective, "perspective", "Perspective", "Far objects look smaller."),
    row(Projection::Orthographic, "orthographic", "Orthographic",
        "Far objects keep their size. A texel has the same size everywhere on a plane."),
};

inline constexpr std::array sourceKindRows{
    row(SourceKind::Pattern, "pattern", "Built-in", "A pattern that Texplorer generates."),
    row(SourceKind::File, "file", "Image file", "An image from a file."),
    row(SourceKind::LightDepth, "light-depth", "Shadow map",
        "The distance from the light to each point that it sees, drawn in every frame."),
    row(SourceKind::Picture, "picture", "Picture of passes",
        "What the passes that do not draw in the window draw (Draws in, in the tab Pass), in every frame."),
};

inline constexpr std::array pictureCallRows{
    row(PictureCall::Framebuffer, "glFramebufferTexture2D", "Framebuffer object",
        "The passes draw into the texture itself, which is attached to a framebuffer object.",
        "GL_EXT_framebuffer_object"),
    row(PictureCall::CopyTexImage, "glCopyTexImage2D", "Copy, new image",
        "The passes draw in a corner of the window, and the pixels are copied into a new image."),
    row(PictureCall::CopyTexSubImage, "glCopyTexSubImage2D", "Copy, same image",
        "The same, but the pixels are copied into the image that the texture has."),
};

inline constexpr std::array matrixOpRows{
    row(MatrixOp::Translate, "translate", "Translate", "Moves the image over the surface (glTranslatef)."),
    row(MatrixOp::Rotate, "rotate", "Rotate", "Turns the image about an axis through (0, 0) (glRotatef)."),
    row(MatrixOp::Scale, "scale", "Scale",
        "A factor of 2 shows the image twice as often at half the size (glScalef)."),
    row(MatrixOp::Multiply, "multiply", "Multiply", "Multiplies by 16 numbers (glMultMatrixf)."),
    row(MatrixOp::Load, "load", "Load",
        "Replaces the result of the steps before it by 16 numbers (glLoadMatrixf)."),
    row(MatrixOp::Projector, "projector", "Projector",
        "From eye coordinates to the light's view: s and t from 0 to 1 across it, r is the depth. With "
        "coordinates generated in eye space, the light projects the image like a slide."),
};

inline constexpr std::array matrixStartRows{
    row(MatrixStart::Identity, "glLoadIdentity", "Identity",
        "glLoadIdentity: the steps begin with the identity. What earlier passes left is gone."),
    row(MatrixStart::Push, "glPushMatrix", "Push, pop",
        "glPushMatrix: the steps multiply what earlier passes left. glPopMatrix restores it after the pass."),
    row(MatrixStart::Keep, "keep", "Keep",
        "The steps multiply what earlier passes left, and later passes that keep or push go on from there."),
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
    row(Attachment::World, "world", "The world", "The model stays in place while the camera moves."),
    row(Attachment::Eye, "eye", "The eye",
        "The model moves with the camera, like a logo. Its position is in eye coordinates."),
};

inline constexpr std::array lightCarrierRows{
    row(LightCarrier::Inverse, "inverse", "Inverse matrix",
        "The light's position times the inverse of the modelview matrix. Correct for every model."),
    row(LightCarrier::Transpose, "transpose", "Transposed inverse",
        "The result of multiplying the row instead of the column. The relief is lit as if the model were "
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
/// The sources of a level's image and of a step's other one: a pattern or a file.
inline constexpr std::span<const EnumRow> pictureSourceRows = std::span(sourceKindRows).first(2);
template<>
struct EnumTable<PictureCall> {
    static constexpr std::span<const EnumRow> rows = pictureCallRows;
};
template<>
struct EnumTable<MatrixOp> {
    static constexpr std::span<const EnumRow> rows = matrixOpRows;
};
template<>
struct EnumTable<MatrixStart> {
    static constexpr std::span<const EnumRow> rows = matrixStartRows;
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

static_assert(projectionRows.size() == 2 && sourceKindRows.size() == 4 && pictureCallRows.size() == 3 &&
              matrixOpRows.size() == 6 && matrixStartRows.size() == 3 && rotationOrderRows.size() == 6 &&
              attachmentRows.size() == 2 && lightCarrierRows.size() == 2);

/// The scene at the start of Texplorer: a cube and a sphere next to each other, lit, with the checkerboard,
/// trilinear.
[[nodiscard]] Scene defaultScene();

} // namespace texplorer
