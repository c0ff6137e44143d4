// Passes and models.

#include "texplorer/diagnosis/diagnosis_rules.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/model_mesh.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

namespace texplorer::diagnosis {
namespace {

template<class Visit> ///< visit(pass, "passes[0].", number), of passes that are drawn
void forEachPass(const Scene& scene, Visit visit) {
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        if (scene.passes[p].enabled)
            visit(scene.passes[p], elementOf<&Scene::passes>(p) + ".", p);
    }
}

void passOff(const Case& about, Report& report) {
    for (std::size_t p = 0; p < about.scene.passes.size(); ++p) {
        const std::string path = elementOf<&Scene::passes>(p);
        if (!about.scene.passes[p].enabled)
            report.add(path, N_("the pass is not drawn"),
                       Fix{N_("Draw it"), {{fmt::format("{}.{}", path, keyOf<&Pass::enabled>()), "true"}}});
    }
}

void emptyPass(const Case& about, Report& report) {
    forEachPass(about.scene, [&](const Pass& pass, const std::string& path, std::size_t) {
        if (!pass.models.empty() && !drawsAnything(about.scene, pass))
            report.add(path + keyOf<&Pass::models>(),
                       N_("all models of this pass are hidden: it draws nothing"));
    });
}

void nothingPasses(const Case& about, Report& report) {
    forEachPass(about.scene, [&](const Pass& pass, const std::string& path, std::size_t) {
        if (pass.alphaTest && pass.alphaFunc == CompareFunc::Never)
            report.add(
                path + keyOf<&Pass::alphaFunc>(),
                Sentence("{0} lets no fragment through: this pass draws nothing", named(pass.alphaFunc)),
                Fix{N_("Switch the alpha test off"), {{path + keyOf<&Pass::alphaTest>(), "false"}}});
        if (pass.depthTest && pass.depthFunc == CompareFunc::Never)
            report.add(
                path + keyOf<&Pass::depthFunc>(),
                Sentence("{0} lets no fragment through: this pass draws nothing", named(pass.depthFunc)),
                Fix{Sentence("Set {0}", named(CompareFunc::LessEqual)),
                    {{path + keyOf<&Pass::depthFunc>(), nameOf(CompareFunc::LessEqual)}}});
    });
}

/// The same triangles have the same depths in every pass (appendix A.2): none is less than itself.
void hiddenPass(const Case& about, Report& report) {
    std::map<int, std::vector<bool>> depths; // by picture: whether a pass before has written a model's depth
    forEachPass(about.scene, [&](const Pass& pass, const std::string& path, std::size_t) {
        std::vector<bool>& written = depths[pass.picture];
        written.resize(about.scene.models.size());
        const bool strict = pass.depthFunc == CompareFunc::Less;
        const std::vector<std::size_t> models = drawnModels(about.scene, pass);
        const bool drawn =
            !models.empty() && std::ranges::all_of(models, [&](std::size_t model) { return written[model]; });
        if (drawn && pass.depthTest && strict)
            report.add(path + keyOf<&Pass::depthFunc>(),
                       N_("an earlier pass has drawn the same surfaces, and no depth is less than itself: "
                          "this pass draws nothing"),
                       Fix{Sentence("Set {0}", named(CompareFunc::LessEqual)),
                           {{path + keyOf<&Pass::depthFunc>(), nameOf(CompareFunc::LessEqual)}}});
        const bool writes = strict || pass.depthFunc == CompareFunc::LessEqual;
        if (pass.depthTest && writes && !pass.alphaTest) {
            for (const std::size_t model : models)
                written[model] = true;
        }
    });
}

/// Lines, points, or triangles in one plane of constant z.
bool isFlat(const MeshData& mesh) {
    return partCorners(mesh.primitive) < 3 ||
           std::ranges::all_of(mesh.positions, [&](const glm::vec3& position) {
               return position.z == mesh.positions.front().z;
           });
}

/// Whether models of a pass may hide each other, or themselves: a closed shape has a far side, and two flat
/// ones stand one behind the other unless they share a plane.
bool canHide(const Scene& scene, const Pass& pass) {
    const Model* first = nullptr;
    for (const std::size_t index : drawnModels(scene, pass)) {
        const Model& each = scene.models[index];
        if (each.shape == Shape::Mesh && isFlat(each.mesh))
            continue; // nothing of it stands behind the rest of it
        if (each.shape != Shape::Quad && each.shape != Shape::Floor)
            return true;
        const int across = each.shape == Shape::Floor ? 1 : 2; // the axis that the flat shape is upright to
        const bool turned = each.rotation != glm::vec3(0) || each.spin != glm::vec3(0);
        if (first && (turned || each.shape != first->shape || each.rotation != first->rotation ||
                      each.spin != first->spin || each.position[across] != first->position[across]))
            return true;
        first = &each;
    }
    return false;
}

/// GL's initial state draws the far side of a cube over its near side. What is blended has its own order.
void noDepthTest(const Case& about, Report& report) {
    forEachPass(about.scene, [&](const Pass& pass, const std::string& path, std::size_t p) {
        const bool blends =
            pass.blend && (pass.blendSrc != BlendFactor::One || pass.blendDst != BlendFactor::Zero);
        if (pass.depthTest || blends || !canHide(about.scene, pass))
            return;
        Fix fix{N_("Switch the depth test on"), {{path + keyOf<&Pass::depthTest>(), "true"}}};
        const auto before = std::span(about.scene.passes).first(p);
        if (std::ranges::find(before, pass.picture, &Pass::picture) !=
            before.end()) // no depth is less than that of a pass before
            fix.assignments.push_back({path + keyOf<&Pass::depthFunc>(), nameOf(CompareFunc::LessEqual)});
        report.add(path + keyOf<&Pass::depthTest>(),
                   N_("there is no depth test: what is drawn last covers nearer surfaces"), std::move(fix));
    });
}

void noFragmentTest(const Case& about, Report& report) {
    forEachPass(about.scene, [&](const Pass& pass, const std::string& path, std::size_t) {
        if (!pass.depthTest)
            report.add(path + keyOf<&Pass::depthFunc>(), N_("the depth test is off"));
        if (!pass.alphaTest) {
            report.add(path + keyOf<&Pass::alphaFunc>(), N_("the alpha test is off"));
            report.add(path + keyOf<&Pass::alphaRef>(), N_("the alpha test is off"));
        } else if (pass.alphaFunc == CompareFunc::Always || pass.alphaFunc == CompareFunc::Never)
            report.add(path + keyOf<&Pass::alphaRef>(),
                       Sentence("{0} compares nothing", named(pass.alphaFunc)));
        if (!pass.blend) {
            report.add(path + keyOf<&Pass::blendSrc>(), N_("blending is off"));
            report.add(path + keyOf<&Pass::blendDst>(), N_("blending is off"));
        } else if (pass.blendSrc == BlendFactor::One && pass.blendDst == BlendFactor::Zero)
            report.add(path + keyOf<&Pass::blend>(),
                       N_("with these factors the new colour replaces the old one, as without blending"));
    });
}

/// "models[0].texCoords1"
std::string texCoordsPath(std::size_t model, std::size_t unit) {
    return fmt::format("{}.{}", elementOf<&Scene::models>(model), findKey(memberId<&Model::texCoords>, unit));
}

/// Coordinates that reach the texture: those of units that are on.
void badCoordinates(const Case& about, Report& report, bool wantsInfinite) {
    for (std::size_t m = 0; m < about.scene.models.size(); ++m) {
        for (std::size_t u = 0; u < maxUnits; ++u) {
            const auto draws = [&](const Pass& pass) {
                const std::vector<std::size_t> drawn = drawnModels(about.scene, pass);
                return pass.units[u].enabled && std::ranges::find(drawn, m) != drawn.end();
            };
            const bool on = std::ranges::any_of(about.scene.passes, draws);
            const bool ownQ = std::ranges::any_of(about.scene.passes, [&](const Pass& pass) {
                return draws(pass) && !pass.units[u].texGenQ.enabled;
            });
            if (!on)
                continue;
            const auto isBad = [&](const glm::vec4& each) {
                const bool finite = std::isfinite(each.x) && std::isfinite(each.y) && std::isfinite(each.z) &&
                                    std::isfinite(each.w);
                return wantsInfinite ? !finite : finite && ownQ && each.w == 0;
            };
            const TexCoords& list = about.scene.models[m].texCoords[u];
            const auto first = std::ranges::find_if(list, isBad);
            if (first == list.end())
                continue;
            const auto vertex = first - list.begin();
            const auto others = std::count_if(first + 1, list.end(), isBad);
            Sentence sentence =
                wantsInfinite ? Sentence("a coordinate of vertex {0} is infinite or not a number", vertex)
                              : Sentence("q of vertex {0} is 0, but s, t and r are divided by q", vertex);
            if (others > 0)
                sentence = Sentence("{0}; the same is true of {1} more", sentence, others);
            report.add(fmt::format("{}[{}]", texCoordsPath(m, u), vertex), std::move(sentence));
        }
    }
}

void infiniteCoordinates(const Case& about, Report& report) {
    badCoordinates(about, report, true);
}

void zeroQ(const Case& about, Report& report) {
    badCoordinates(about, report, false);
}

void unreadCoordinates(const Case& about, Report& report) {
    const std::vector<Pass>& passes = about.scene.passes;
    for (std::size_t u = 0; u < maxUnits; ++u) {
        const bool off = std::ranges::none_of(
            passes, [&](const Pass& pass) { return pass.enabled && pass.units[u].enabled; });
        const bool generated = std::ranges::all_of(passes, [&](const Pass& pass) {
            const Unit& unit = pass.units[u];
            return !pass.enabled || !unit.enabled ||
                   (unit.texGenS.enabled && unit.texGenT.enabled && unit.texGenR.enabled &&
                    unit.texGenQ.enabled);
        });
        const Sentence reason =
            off ? Sentence("unit {0} is off", u) : Sentence("unit {0} generates all of its coordinates", u);
        for (std::size_t m = 0; m < about.scene.models.size() && (off || generated); ++m) {
            report.add(texCoordsPath(m, u), reason);
            const std::string path = noTexCoordPath(m, u);
            const std::vector<KeyFrame>& keys = about.scene.timeline.keys;
            if (!about.scene.models[m].noTexCoord[u].empty() ||
                std::ranges::find(keys, path, &KeyFrame::path) != keys.end())
                report.add(path, reason);
        }
    }
}

void ignoredHint(const Case& about, Report& report) {
    const View& view = about.scene.view;
    if (view.perspectiveHint == HintMode::Fastest && view.projection == Projection::Perspective)
        report.add(pathOf<&Scene::view, &View::perspectiveHint>(),
                   N_("the fixed function may ignore this hint, and most drivers do; the shaders and the "
                      "reference interpolate without perspective"),
                   Fix{N_("Correct the perspective"),
                       {{pathOf<&Scene::view, &View::perspectiveHint>(), nameOf(HintMode::Nicest)}}});
}

void nothingToCorrect(const Case& about, Report& report) {
    if (about.scene.view.projection == Projection::Orthographic)
        report.add(pathOf<&Scene::view, &View::perspectiveHint>(),
                   N_("an orthographic view has no perspective to correct"));
}

constexpr std::array passRuleRows{
    Rule{"infinite-coordinate", Severity::Error, infiniteCoordinates},
    Rule{"zero-q-of-vertex", Severity::Warning, zeroQ},
    Rule{"nothing-passes", Severity::Warning, nothingPasses},
    Rule{"empty-pass", Severity::Warning, emptyPass},
    Rule{"hidden-pass", Severity::Warning, hiddenPass},
    Rule{"no-depth-test", Severity::Warning, noDepthTest},
    Rule{"ignored-hint", Severity::Warning, ignoredHint},
    Rule{"no-perspective", Severity::Hint, nothingToCorrect},
    Rule{"fragment-test", Severity::Hint, noFragmentTest},
    Rule{"pass-off", Severity::Hint, passOff},
    Rule{"unread-coordinates", Severity::Hint, unreadCoordinates},
};

} // namespace

std::span<const Rule> passRules() {
    return passRuleRows;
}

} // namespace texplorer::diagnosis
