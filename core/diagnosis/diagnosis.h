#pragma once

// Reports what is wrong, undefined or without effect in a scene, as sentences. The window, `texshot shot` and
// `texshot check` use one table of rules (diagnosis_*.cpp).

#include "texplorer/base/sentence.h"
#include "texplorer/scene/edit/edit.h"
#include "texplorer/scene/scene.h"
#include "texplorer/texture/image_source.h"

#include <string>
#include <string_view>
#include <vector>

namespace texplorer {

/// The properties of a driver that decide whether it can draw a scene. The defaults lack nothing.
struct DriverFacts {
    std::string renderer{};      ///< GL_RENDERER, which identifies its flaws
    std::string version{};       ///< GL_VERSION
    int textureUnits = maxUnits; ///< of the fixed-function pipeline
    int maxTextureSize = 1 << 30;
    int max3DTextureSize = 1 << 30;
    int maxCubeMapSize = 1 << 30;
    float maxAnisotropy = 16; ///< 1 without anisotropic filtering
    bool nonPowerOfTwo = true;
    bool s3tc = true;
    bool rgtc = true;
    bool floatTextures = true;
    bool seamlessCubeMaps = true;
    bool textureBorders = true; ///< texture borders are supported

    bool operator==(const DriverFacts&) const = default;

    [[nodiscard]] constexpr TextureLimits limits() const {
        return {maxTextureSize, max3DTextureSize, maxCubeMapSize};
    }
    /// The maximum number of texels of the base level along each axis.
    [[nodiscard]] constexpr int maxTexels(Target target) const { return limits().of(target); }
};

enum class Severity : std::uint32_t { Error, Warning, Note, Hint, Unused };

inline constexpr std::array severityRows{
    row(Severity::Error, "error", "Error",
        "Something that the scene needs is missing. The scene is drawn without it."),
    row(Severity::Warning, "warning", "Warning",
        "OpenGL leaves the result undefined, or does something unexpected."),
    row(Severity::Note, "note", "Worth knowing",
        "Nothing is wrong. The setting works as designed, and this is the result."),
    row(Severity::Hint, "hint", "No effect",
        "The setting changes no pixel with the present values of the "
        "others."),
    row(Severity::Unused, "unused", "Not used",
        "The setting belongs to a choice that isn't selected. A panel need not show it."),
};
template<>
struct EnumTable<Severity> {
    static constexpr std::span<const EnumRow> rows = severityRows;
};
static_assert(severityRows.size() == 5);

struct Fix {
    Sentence label; ///< "Generate mipmaps"
    std::vector<edit::Set> assignments;
};

struct Finding {
    std::string_view rule; ///< its name in the table: "incomplete"
    Severity severity = Severity::Warning;
    /// The parameter, "textures[0].minFilter"; or a struct, "passes[0].units[1].combine", with everything in
    /// it.
    std::string path;
    Sentence sentence;      ///< without a capital and a full stop, like an error message
    std::vector<Fix> fixes; ///< each of them alone fixes it; the most likely one first
    /// Whether a renderer also reports this when it draws.
    bool reportedByRenderer = false;
};

/// Returns all findings: errors first, then warnings, notes, hints and unused settings; each kind in the
/// order of the rules. Does not read files: a texture whose file is not in `images` counts as missing. Never
/// fails, for any scene.
[[nodiscard]] std::vector<Finding> diagnose(const Scene& scene, const ImageSource& images,
                                            const DriverFacts& driver = {});

/// Whether the diagnosis looks at texels: then the images of `diagnose` should not be outlines alone.
[[nodiscard]] bool looksAtTexels(const Scene& scene);

/// Makes the assignments of a fix. If one is not possible (the scene has changed), the scene is unchanged.
[[nodiscard]] Result<void> apply(const Fix& fix, Scene& scene);

/// Whether `path` is `whole`, a parameter or struct, or part of it.
[[nodiscard]] bool isPartOf(std::string_view path, std::string_view whole);

/// Returns the first finding about a parameter: an error, a warning or a note about it or part of it; or a
/// hint or unused setting about it or a struct that contains it, unless the fix sets it. nullptr: none.
[[nodiscard]] const Finding* problemOf(const std::vector<Finding>& findings, std::string_view path);
[[nodiscard]] const Finding* idleReasonOf(const std::vector<Finding>& findings, std::string_view path);

} // namespace texplorer
