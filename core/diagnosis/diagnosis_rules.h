#pragma once

// The rules of the diagnosis: one row each, {name, severity, function}. Included only by diagnosis*.cpp.

#include "texplorer/diagnosis/diagnosis.h"
#include "texplorer/reference/sampling/completeness.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/params/value_words.h"
#include "texplorer/texture/level_plan.h"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace texplorer::diagnosis {

/// A texture on one target.
struct TargetFacts {
    Target target = Target::Texture2D;
    LevelPlan plan;
    reference::Completeness completeness;
    BaseFormat format = BaseFormat::Rgba; ///< as the environment sees it
};

/// The facts about a texture that several rules need.
struct TextureFacts {
    TexturePictures pictures;
    std::shared_ptr<const TextureImage> image; ///< of the base level; nullptr: not loaded
    bool shown = false;                        ///< an enabled unit uses it
    bool seamless = false;                     ///< all such units use a seamless cube map
    /// The targets of the enabled units that use it; if there are none, those of the disabled ones.
    std::vector<TargetFacts> targets;

    [[nodiscard]] bool hasTarget(Target target) const;
    [[nodiscard]] const TargetFacts* as(Target target) const;
};

/// Returns the facts of `texture` on one target, independent of the driver.
[[nodiscard]] TargetFacts factsAs(Target target, const Texture& texture, const TexturePictures& pictures);

/// The texture for sampling: its extents, without texels and parameters.
[[nodiscard]] reference::SampledTexture shapeOf(const TargetFacts& facts, InternalFormat format);

struct Case {
    const Scene& scene;
    const DriverFacts& driver;
    std::vector<TextureFacts> textures; ///< one for each texture of the scene

    /// The texture of a unit, or nullptr if it does not exist.
    [[nodiscard]] const TextureFacts* textureOf(const Unit& unit) const;
    /// Whether a unit changes colours: it is enabled, and its texture exists and is complete.
    [[nodiscard]] bool works(const Unit& unit) const;
};

/// Receives the findings of a rule.
class Report {
public:
    explicit Report(std::vector<Finding>& findings)
        : findings_(findings) {}

    void begin(std::string_view rule, Severity severity, bool reportedByRenderer) {
        rule_ = rule;
        severity_ = severity;
        reportedByRenderer_ = reportedByRenderer;
    }
    void add(std::string path, Sentence sentence, std::vector<Fix> fixes = {}) {
        findings_.push_back(
            {rule_, severity_, std::move(path), std::move(sentence), std::move(fixes), reportedByRenderer_});
    }
    void add(std::string path, Sentence sentence, Fix fix) {
        add(std::move(path), std::move(sentence), std::vector{std::move(fix)});
    }

private:
    std::vector<Finding>& findings_;
    std::string_view rule_;
    Severity severity_ = Severity::Warning;
    bool reportedByRenderer_ = false;
};

struct Rule {
    std::string_view name;
    Severity severity;
    void (*find)(const Case& about, Report& report);
    bool reportedByRenderer = false; ///< a renderer also reports it
};

[[nodiscard]] std::span<const Rule> textureRules();       ///< errors in textures
[[nodiscard]] std::span<const Rule> sizeRules();          ///< textures that a driver has no room for
[[nodiscard]] std::span<const Rule> formatRules();        ///< effects of internal formats on colours
[[nodiscard]] std::span<const Rule> uploadRules();        ///< uploads that don't fit the memory
[[nodiscard]] std::span<const Rule> textureEffectRules(); ///< texture settings without effect
[[nodiscard]] std::span<const Rule> unitRules();
[[nodiscard]] std::span<const Rule> matrixRules(); ///< of textures, and their stacks
[[nodiscard]] std::span<const Rule> cubeRules();   ///< the edges of cube faces
[[nodiscard]] std::span<const Rule> combineRules();
[[nodiscard]] std::span<const Rule> passRules();
[[nodiscard]] std::span<const Rule> pictureRules(); ///< what passes draw, and parts that are replaced
[[nodiscard]] std::span<const Rule> alphaRules();   ///< what filters and levels do to alpha
[[nodiscard]] std::span<const Rule> modelRules();
[[nodiscard]] std::span<const Rule> vertexRules(); ///< normals and coordinates: missing values or precision
[[nodiscard]] std::span<const Rule> lightRules();  ///< and materials
[[nodiscard]] std::span<const Rule> sideRules();   ///< front and back faces
[[nodiscard]] std::span<const Rule> fogRules();
[[nodiscard]] std::span<const Rule> depthRules(); ///< and the projector

/// Whether a texture shows the light's view or is projected from it.
[[nodiscard]] bool usesLightView(const Scene& scene);

/// Whether a unit of a pass has a texture matrix with any model that the pass draws.
[[nodiscard]] bool hasMatrix(const Scene& scene, std::size_t pass, std::size_t unit);
/// Whether a later pass that uses the unit keeps or pushes what is left of its matrix.
[[nodiscard]] bool isLeftMatrixRead(const Scene& scene, std::size_t pass, std::size_t unit);

/// What names a texture's image.
[[nodiscard]] Key imageKey(const Texture& texture);

/// Appends a step to the preparation of "textures[0].".
[[nodiscard]] edit::Set newStep(const std::string& texture, ImageOp op);

/// "passes[0].units[1]."
[[nodiscard]] std::string unitPath(std::size_t pass, std::size_t unit);
/// "models[0].noTexCoord1"
[[nodiscard]] std::string noTexCoordPath(std::size_t model, std::size_t unit);

/// One of GL_COMBINE's arguments.
struct Argument {
    std::string_view sourceKey;
    std::string_view operandKey;
    CombineSource source = CombineSource::Texture;
    bool read = false; ///< the chosen function reads it
    bool ofAlpha = false;
};
[[nodiscard]] std::array<Argument, 6> argumentsOf(const Combine& combine);

template<class Visit> ///< visit(unit, "passes[0].units[1].", pass number), for passes that are drawn
void forEachUnit(const Scene& scene, Visit visit) {
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        if (!scene.passes[p].enabled)
            continue;
        for (std::size_t u = 0; u < maxUnits; ++u)
            visit(scene.passes[p].units[u], unitPath(p, u), p);
    }
}

template<class Visit> ///< visit(texture, its facts, "textures[0].")
void forEachTexture(const Case& about, Visit visit) {
    for (std::size_t i = 0; i < about.textures.size(); ++i)
        visit(about.scene.textures[i], about.textures[i], elementOf<&Scene::textures>(i) + ".");
}

/// The name of an enumerator, in GL or in scene files.
template<Enumerated E>
[[nodiscard]] std::string nameOf(E value) {
    return std::string(rowOf(value).name);
}

/// The same in a sentence.
template<Enumerated E>
[[nodiscard]] Sentence named(E value) {
    return wordsOf(rowOf(value));
}

} // namespace texplorer::diagnosis
