#pragma once

// What textures cost on a driver: two ways to do the same, timed in turns. The rows are claims of documents:
// slides of a university, lesson 22 of NeHe, tutorial 5 of opengl-tutorial.org, and the article "Load DDS
// files in OpenGL".

#include "texplorer/base/sentence.h"
#include "texplorer/compare/paired_times.h"
#include "texplorer/scene/scene.h"
#include "texplorer/texture/levels_source.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::view {

inline constexpr int largeSquare = 256; // pixels: a texel for each, of the usual texture
inline constexpr int smallSquare = 16;  // drawn in no time, so that the call before it counts

/// A way to draw a textured square.
struct CostVariant {
    const char* label;
    bool uploads = false; ///< the image each time, instead of binding an object that has it
    int side = 256;       ///< texels
    Compression compression = Compression::None; ///< to DXT1
    MipPolicy mipmaps = MipPolicy::None;
    MinFilter minFilter = MinFilter::Linear;
    MagFilter magFilter = MagFilter::Linear;
    float anisotropy = 1;
};

/// Two variants, and a claim about them.
struct CostRow {
    std::string_view name; ///< for texshot
    const char* label;
    CostVariant a;
    CostVariant b;
    int pixels = largeSquare; ///< side of the square
    glm::vec2 repeats{1, 1};  ///< of the texture on the square
    const char* claim;
    bool ofScene = false; ///< with the scene's texture: of the variants only `uploads` counts

    [[nodiscard]] constexpr bool needsS3tc() const {
        return a.compression != Compression::None || b.compression != Compression::None;
    }
};

inline constexpr CostVariant trilinear{
    .label = "1", .mipmaps = MipPolicy::Generated, .minFilter = MinFilter::LinearMipmapLinear};
inline constexpr CostVariant anisotropic{.label = "16",
                                         .mipmaps = MipPolicy::Generated,
                                         .minFilter = MinFilter::LinearMipmapLinear,
                                         .anisotropy = 16};

inline constexpr std::array costRows{
    CostRow{.name = "bind",
            .label = N_("Bind or upload"),
            .a = {.label = N_("Bind")},
            .b = {.label = N_("Upload"), .uploads = true},
            .pixels = smallSquare,
            .claim = N_("Slides: binding again beats uploading again.")},
    CostRow{.name = "upload-size",
            .label = N_("Size, uploaded"),
            .a = {.label = "128 × 128", .uploads = true, .side = 128},
            .b = {.label = "256 × 256", .uploads = true},
            .pixels = smallSquare,
            .claim = N_("NeHe 22 advises against 256 × 256.")},
    CostRow{.name = "draw-size",
            .label = N_("Size, drawn"),
            .a = {.label = "128 × 128", .side = 128},
            .b = {.label = "256 × 256"},
            .claim = N_("NeHe 22 advises against 256 × 256.")},
    CostRow{
        .name = "upload-dxt1",
        .label = N_("DXT1, uploaded"),
        .a = {.label = N_("Blocks"), .uploads = true, .side = 128, .compression = Compression::Cached},
        .b = {.label = N_("By the driver"), .uploads = true, .side = 128, .compression = Compression::Driver},
        .pixels = smallSquare,
        .claim = N_("DDS article: driver compression can be slow.")},
    CostRow{.name = "draw-dxt1",
            .label = N_("DXT1, drawn"),
            .a = {.label = "DXT1", .compression = Compression::Cached},
            .b = {.label = "RGBA8"},
            .claim = N_("Tutorial 5: compressed is 20 % faster.")},
    CostRow{.name = "mipmaps",
            .label = N_("Mipmaps, minified 8×"),
            .a = {.label = N_("With mipmaps"),
                  .mipmaps = MipPolicy::Generated,
                  .minFilter = MinFilter::LinearMipmapNearest},
            .b = {.label = N_("Without them")},
            .repeats = {8, 8},
            .claim = N_("No document says what mipmaps cost in time.")},
    CostRow{.name = "linear",
            .label = N_("Filter, magnified 4×"),
            .a = {.label = "GL_NEAREST", .magFilter = MagFilter::Nearest},
            .b = {.label = "GL_LINEAR"},
            .repeats = {0.25F, 0.25F},
            .claim = N_("Slides: GL_LINEAR is slower than GL_NEAREST.")},
    CostRow{.name = "anisotropy",
            .label = N_("Anisotropy, s minified"),
            .a = trilinear,
            .b = anisotropic,
            .repeats = {8, 1},
            .claim = N_("Tutorial 5: anisotropic filtering is slower.")},
    CostRow{.name = "scene",
            .label = N_("Texture of the scene"),
            .a = {.label = N_("Bind")},
            .b = {.label = N_("Upload"), .uploads = true},
            .pixels = smallSquare,
            .claim = N_("Slides: binding again beats uploading again."),
            .ofScene = true},
};

/// The number of pairs that are measured of each row unless another one is asked for.
inline constexpr std::size_t costPairs = 21;
static_assert(costPairs >= minTimePairs);

/// The scene's texture, with its levels.
struct CostSubject {
    Target target = Target::Texture2D;
    std::shared_ptr<const PreparedLevels> levels; ///< nullptr: there is none
    Sentence lack = N_("there is no texture");    ///< then: why
};

/// What was measured of a row.
struct CostTimes {
    PairedTimes times;
    Sentence lack{}; ///< why it can't be measured; empty: it can
};
using TextureCosts = std::array<CostTimes, costRows.size()>;

/// Measures on the context that made it.
class CostMeter {
public:
    CostMeter() = default;
    CostMeter(const CostMeter&) = delete;
    CostMeter& operator=(const CostMeter&) = delete;
    virtual ~CostMeter() = default;

    /// Continues for about the given time. Returns whether there is more to measure.
    [[nodiscard]] virtual bool measure(TextureCosts& costs, std::chrono::milliseconds time) = 0;
};

/// The texture of a variant, filled with a pattern by the meter.
[[nodiscard]] Texture textureOf(const CostVariant& variant);

/// How much is measured, 0 to 1.
[[nodiscard]] double progressOf(const TextureCosts& costs, std::size_t pairs);

/// "12.3 µs".
[[nodiscard]] Sentence timeText(double seconds);

/// "B takes 3.1 times (2.8 to 3.4) the time of A", or why that can't be said. Empty if nothing is measured.
[[nodiscard]] Sentence verdictOn(const CostTimes& row);

/// What such numbers can't tell, on a driver with this GL_RENDERER.
[[nodiscard]] std::vector<Sentence> costLimits(std::string_view renderer);

} // namespace texplorer::view
