#pragma once

// Why a pixel has its colour: every number between a scene and a byte, as a plain value.

#include "core/reference/explain/tap_places.h"
#include "core/reference/explain/ties.h"
#include "core/reference/sampling/sample_record.h"
#include "core/reference/shading/combine.h"
#include "core/reference/shading/environment.h"
#include "core/reference/shading/lighting.h"
#include "core/scene/scene.h"

#include <glm/mat4x4.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::reference {

/// A pixel in window coordinates, as in the pictures of the core: (0, 0) is at the bottom left.
struct PixelPlace {
    int x = 0;
    int y = 0;

    bool operator==(const PixelPlace&) const = default;
};

using PixelBytes = std::array<std::uint8_t, 4>;

/// One set of texture coordinates on its way: as the scene gives it, moved towards the light, with what the
/// unit generates in its place, and after the texture matrix (OpenGL 2.1, section 2.11.4, then 2.11.2).
struct CoordinateSteps {
    glm::vec4 given{0, 0, 0, 1};
    glm::vec4 embossed{0, 0, 0, 1};
    glm::vec4 generated{0, 0, 0, 1};
    glm::vec4 transformed{0, 0, 0, 1};
};

/// A corner of the triangle, an end of the line, or the point.
struct VertexExplanation {
    std::uint32_t vertex = 0; ///< index into the vertices of the model's mesh
    float weight = 0;         ///< barycentric: its share of what is interpolated at the pixel
    glm::vec4 object{0, 0, 0, 1};
    glm::vec4 eye{0, 0, 0, 1};
    glm::vec3 normal{0}; ///< in eye coordinates, of unit length
    glm::vec4 clip{0};
    std::optional<LightingTerms> lighting{}; ///< of the side that is seen; none: lighting is off
    glm::vec4 primary{1};                    ///< of that side, clamped
    glm::vec3 secondary{0};
};

/// The extents of a level that was read.
struct LevelExtent {
    int level = 0;
    glm::ivec3 size{0};
    int border = 0;
};

/// What a texture unit did to the fragment.
struct UnitExplanation {
    int unit = 0;
    int texture = 0; ///< index into Scene::textures
    Target target = Target::Texture2D;
    BaseFormat format = BaseFormat::Rgba;
    InternalFormat internalFormat = InternalFormat::Rgba; ///< of blocks the one of their base format
    std::vector<ImageOp> preparation{}; ///< what was done to the image before it became a texture

    std::array<bool, 4> generates{};       ///< which of s, t, r and q are generated
    bool embosses = false;                 ///< whether coordinates follow the light
    std::vector<CoordinateSteps> vertices; ///< at the corners
    CoordinateSteps pixel;                 ///< the same, interpolated
    glm::mat4 matrix{1};
    bool flipped = false; ///< t became q - t at first, to turn the image around
    glm::vec3 coords{0};  ///< s/q, t/q, r/q
    Derivatives derivatives;

    // The state that decided, as it was at the pixel.
    SamplerState sampler; ///< of the texture object
    float lodBias = 0;    ///< of the unit

    SampleRecord sample;
    Ties ties;                        ///< what rounding decided of it
    std::vector<LevelExtent> extents; ///< of the levels in `sample`
    std::vector<LevelPatch> patches;  ///< what lies around the texels

    EnvMode mode = EnvMode::Modulate;
    EnvironmentInputs inputs;
    EnvironmentEquations equations;
    glm::vec4 result{0};
};

/// A unit that the scene switches on and that did nothing, with the reason as a sentence.
struct IdleUnit {
    int unit = 0;
    std::string reason;
};

enum class FragmentOutcome : std::uint8_t { Drawn, FailedAlphaTest, FailedDepthTest };

/// A comparison of the value of the fragment with another one; `T` is what is compared.
template<class T>
struct TestExplanation {
    bool enabled = false;
    CompareFunc function = CompareFunc::Always;
    T value{};
    T with{};
    bool passed = true;
};

/// Section 4.1.8.
struct BlendExplanation {
    bool enabled = false;
    BlendFactor sourceFactor = BlendFactor::One;
    BlendFactor destinationFactor = BlendFactor::Zero;
    glm::vec4 source{0};
    glm::vec4 sourceWeight{1};
    glm::vec4 destination{0};
    glm::vec4 destinationWeight{0};
    glm::vec4 result{0};
};

/// Section 3.10.
struct FogExplanation {
    Fog state;
    float distance = 0; ///< c: from the eye's plane, interpolated
    Equation equation;  ///< of f, before it is clamped
    float factor = 1;   ///< f
};

/// One triangle, line or point that covers the pixel, in one pass.
struct FragmentExplanation {
    int pass = 0;
    int model = 0;
    Shape shape = Shape::Cube;
    std::uint32_t part = 0;                  ///< number of the triangle, line or point in the mesh
    std::string face;                        ///< its name; empty: it belongs to none
    bool clipped = false;                    ///< the near or far plane, or the edge of the guard band, cut it
    std::vector<VertexExplanation> vertices; ///< 3 of a triangle, 2 of a line, 1 of a point

    bool lighting = false;
    bool coloredVertices = false; ///< the mesh has colours in the place of glColor
    bool flat = false;            ///< the colours of the last vertex
    bool separateSpecular = false;
    bool twoSided = false;   ///< GL_LIGHT_MODEL_TWO_SIDE: what is seen from behind is lit otherwise
    bool fromBehind = false; ///< a triangle that runs clockwise in the window
    glm::vec4 primary{1};    ///< interpolated
    glm::vec4 secondary{0};  ///< the same; used under separate specular alone
    std::vector<UnitExplanation> units;
    std::vector<IdleUnit> idle;
    glm::vec4 textured{1};               ///< after the last unit
    glm::vec4 summed{1};                 ///< after the colour sum, clamped
    std::optional<FogExplanation> fog{}; ///< none: it is off
    glm::vec4 color{1};                  ///< after fog: what the tests and blending get

    TestExplanation<float> alphaTest;
    TestExplanation<std::uint32_t> depthTest; ///< in 24 bits
    float depth = 0;                          ///< 0 at the near plane, 1 at the far one
    BlendExplanation blend;
    FragmentOutcome outcome = FragmentOutcome::Drawn;
    PixelBytes before{}; ///< in the framebuffer
    PixelBytes after{};
};

/// So many fragments of a pixel are explained at most.
inline constexpr std::size_t mostExplainedFragments = 32;

struct Explanation {
    PixelPlace pixel;
    int width = 0; ///< of the picture
    int height = 0;
    double time = 0;
    glm::vec4 background{0};
    std::size_t fragmentCount = 0; ///< that cover the pixel
    /// In the order of drawing: all, or the last up to the one that one sees, of which `firstFragment` were
    /// left out before.
    std::vector<FragmentExplanation> fragments;
    std::size_t firstFragment = 0;
    glm::vec4 color{0};                ///< what was stored last, before rounding
    PixelBytes bytes{};                ///< what the picture has
    std::vector<PixelBytes> asRight{}; ///< what it may have as well, where ties fall otherwise
    std::vector<std::string> problems; ///< sentences: what could not be drawn

    /// The last fragment that was drawn: the one that one sees, unless it was blended. nullptr: the
    /// background.
    [[nodiscard]] const FragmentExplanation* seen() const {
        for (std::size_t i = fragments.size(); i > 0; --i) {
            if (fragments[i - 1].outcome == FragmentOutcome::Drawn)
                return &fragments[i - 1];
        }
        return nullptr;
    }
};

} // namespace texplorer::reference
