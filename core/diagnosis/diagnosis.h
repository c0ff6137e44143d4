#pragma once

// What is wrong in a scene, undefined, or without effect, in sentences for a reader. One table of rules
// (diagnosis_*.cpp) feeds the window, `texshot shot` and `texshot check`.

#include "core/scene/scene.h"
#include "core/texture/image_source.h"

#include <string>
#include <string_view>
#include <vector>

namespace texplorer {

/// What of a driver decides whether a scene can be drawn as it says. As it stands here, nothing is lacking.
struct DriverFacts {
    std::string renderer{};      ///< GL_RENDERER, by which its flaws are known
    int textureUnits = maxUnits; ///< of the fixed functions
    int maxTextureSize = 1 << 30;
    int max3DTextureSize = 1 << 30;
    int maxCubeMapSize = 1 << 30;
    float maxAnisotropy = 16; ///< 1 where there is no anisotropic filtering
    bool nonPowerOfTwo = true;
    bool s3tc = true;
    bool rgtc = true;
    bool seamlessCubeMaps = true;
    bool textureBorders = true; ///< a border of texels stays with its image

    bool operator==(const DriverFacts&) const = default;

    /// How many texels the base level may have along each axis.
    [[nodiscard]] constexpr int mostTexels(Target target) const {
        return target == Target::Texture3D ? max3DTextureSize
               : target == Target::CubeMap ? maxCubeMapSize
                                           : maxTextureSize;
    }
};

enum class Severity : std::uint32_t { Error, Warning, Note, Hint, Unused };

inline constexpr std::array severityRows{
    row(Severity::Error, "error", "Error",
        "Something that the scene asks for isn't there: it is drawn without it."),
    row(Severity::Warning, "warning", "Warning",
        "OpenGL leaves the result undefined, or does otherwise than one would think."),
    row(Severity::Note, "note", "Worth knowing",
        "Nothing is wrong: the setting does what it is for, and that is what one sees."),
    row(Severity::Hint, "hint", "No effect", "The setting changes no pixel as the others are at present."),
    row(Severity::Unused, "unused", "Not used",
        "The setting belongs to a choice that isn't made: a panel need not show it."),
};
template<>
struct EnumTable<Severity> {
    static constexpr std::span<const EnumRow> rows = severityRows;
};
static_assert(severityRows.size() == 5);

/// One value to set, as setParam takes it.
struct Assignment {
    std::string path;
    std::string value;

    bool operator==(const Assignment&) const = default;
};

struct Fix {
    std::string label; ///< "Generate mipmaps"
    std::vector<Assignment> assignments;
};

struct Finding {
    std::string_view rule; ///< its name in the table: "incomplete"
    Severity severity = Severity::Warning;
    /// The parameter, "textures[0].minFilter"; or a struct, "passes[0].units[1].combine": all below it.
    std::string path;
    std::string sentence;   ///< without a capital and a full stop, as an error's message
    std::vector<Fix> fixes; ///< each of them mends it; the one that is most often meant comes first
    /// Whether a renderer, too, reports this when it draws.
    bool reportedByRenderer = false;
};

/// Everything that there is to say, errors first, then warnings, notes, hints and what is unused; each kind
/// in the order of the rules. Reads no file: a texture whose file `images` doesn't hold counts as missing.
/// Never fails, whatever the scene holds.
[[nodiscard]] std::vector<Finding> diagnose(const Scene& scene, const ImageSource& images,
                                            const DriverFacts& driver = {});

/// Sets what a fix says. An assignment that can't be made (the scene has changed) leaves the scene as it was.
[[nodiscard]] Result<void> apply(const Fix& fix, Scene& scene);

/// Whether `path` is that of `whole`, a parameter or a struct, or of something in it.
[[nodiscard]] bool isPartOf(std::string_view path, std::string_view whole);

/// The first finding about a parameter: an error, a warning or a note about itself or about something in it;
/// or a hint or what is unused, about itself or a struct that it is part of, unless the fix sets it. nullptr:
/// none.
[[nodiscard]] const Finding* problemOf(const std::vector<Finding>& findings, std::string_view path);
[[nodiscard]] const Finding* idleReasonOf(const std::vector<Finding>& findings, std::string_view path);

} // namespace texplorer
