#pragma once

// How the rules of the diagnosis are written: a row each, {name, severity, function}. Only diagnosis*.cpp
// include this.

#include "core/diagnosis/diagnosis.h"
#include "core/reference/sampling/completeness.h"
#include "core/scene/params/keys.h"
#include "core/texture/level_plan.h"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace texplorer::diagnosis {

/// A texture as one target takes it.
struct TargetFacts {
    Target target = Target::Texture2D;
    LevelPlan plan;
    reference::Completeness completeness;
    BaseFormat format = BaseFormat::Rgba; ///< that the environment sees
};

/// What the rules ask about a texture again and again.
struct TextureFacts {
    TexturePictures pictures;
    std::shared_ptr<const TextureImage> image; ///< the base's; nullptr: not loaded
    bool shown = false;                        ///< by a unit that is on
    bool seamless = false;                     ///< all of these show a seamless cube map
    /// The targets of the units that are on and show it; where there are none, of those that are off.
    std::vector<TargetFacts> targets;

    [[nodiscard]] bool hasTarget(Target target) const;
    [[nodiscard]] const TargetFacts* as(Target target) const;
};

/// What `texture` is as one target takes it, whatever the driver is.
[[nodiscard]] TargetFacts factsAs(Target target, const Texture& texture, const TexturePictures& pictures);

/// The same to sample: its extents, without texels and parameters.
[[nodiscard]] reference::SampledTexture shapeOf(const TargetFacts& facts, InternalFormat format);

struct Case {
    const Scene& scene;
    const DriverFacts& driver;
    std::vector<TextureFacts> textures; ///< one for each of the scene's

    /// The texture that a unit names, or nullptr where there is none.
    [[nodiscard]] const TextureFacts* textureOf(const Unit& unit) const;
    /// Whether a unit changes colours: it is on and its texture is there and complete.
    [[nodiscard]] bool works(const Unit& unit) const;
};

/// Takes what a rule finds.
class Report {
public:
    explicit Report(std::vector<Finding>& findings)
        : findings_(findings) {}

    void begin(std::string_view rule, Severity severity, bool reportedByRenderer) {
        rule_ = rule;
        severity_ = severity;
        reportedByRenderer_ = reportedByRenderer;
    }
    void add(std::string path, std::string sentence, std::vector<Fix> fixes = {}) {
        findings_.push_back(
            {rule_, severity_, std::move(path), std::move(sentence), std::move(fixes), reportedByRenderer_});
    }
    void add(std::string path, std::string sentence, Fix fix) {
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
    bool reportedByRenderer = false; ///< a renderer reports it, too
};

[[nodiscard]] std::span<const Rule> textureRules();       ///< what is wrong with textures
[[nodiscard]] std::span<const Rule> formatRules();        ///< what internal formats do to colours
[[nodiscard]] std::span<const Rule> textureEffectRules(); ///< which of their settings do nothing
[[nodiscard]] std::span<const Rule> unitRules();
[[nodiscard]] std::span<const Rule> cubeRules(); ///< the edges of faces
[[nodiscard]] std::span<const Rule> combineRules();
[[nodiscard]] std::span<const Rule> passRules();
[[nodiscard]] std::span<const Rule> modelRules();
[[nodiscard]] std::span<const Rule>
vertexRules(); ///< normals and coordinates without a value, or without bits
[[nodiscard]] std::span<const Rule> lightRules(); ///< material, too
[[nodiscard]] std::span<const Rule> sideRules();  ///< front and back
[[nodiscard]] std::span<const Rule> fogRules();
[[nodiscard]] std::span<const Rule> depthRules(); ///< and the projector

/// Whether a texture shows what the light sees, or is projected by it.
[[nodiscard]] bool usesLightView(const Scene& scene);

/// "passes[0].units[1]."
[[nodiscard]] std::string unitPath(std::size_t pass, std::size_t unit);

/// One of GL_COMBINE's arguments.
struct Argument {
    std::string_view sourceKey;
    std::string_view operandKey;
    CombineSource source = CombineSource::Texture;
    bool read = false; ///< by the function that is chosen
    bool ofAlpha = false;
};
[[nodiscard]] std::array<Argument, 6> argumentsOf(const Combine& combine);

template<class Visit> ///< visit(unit, "passes[0].units[1].", pass number), of passes that are drawn
void forEachUnit(const Scene& scene, Visit visit) {
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        if (!scene.passes[p].enabled)
            continue;
        for (std::size_t u = 0; u < maxUnits; ++u)
            visit(scene.passes[p].units[u], unitPath(p, u), p);
    }
}

/// The name of an enumerator, as GL or a scene file has it.
template<Enumerated E>
[[nodiscard]] std::string nameOf(E value) {
    return std::string(rowOf(value).name);
}

} // namespace texplorer::diagnosis
